import type { PictureOf } from '../../worker/protocol.ts';

/** The pictures of one run, each fetched once. */
export class PictureShelf {
  readonly #fetch: (name: string, of: PictureOf) => Promise<string | null>;
  readonly #pictures = new Map<string, Promise<string | null>>();
  #run: object | null = null;
  #of: PictureOf = 'plan';

  constructor(fetch: (name: string, of: PictureOf) => Promise<string | null>) {
    this.#fetch = fetch;
  }

  /** Names the run whose pictures follow; those of another are forgotten. @returns whether it is another */
  turnTo(run: object | null, of: PictureOf): boolean {
    if (run === this.#run) return false;
    this.#run = run;
    this.#of = of;
    this.#pictures.clear();
    return true;
  }

  /** SVG text; null where the run has no such picture. @throws FloorPlanError */
  get(name: string): Promise<string | null> {
    let picture = this.#pictures.get(name);
    if (!picture) {
      picture = this.#fetch(name, this.#of);
      this.#pictures.set(name, picture);
      // What failed or was cancelled may be asked for again.
      picture.catch(() => this.#pictures.delete(name));
    }
    return picture;
  }
}
