import type { PictureAsked, PictureOf } from '../../worker/protocol.ts';

/** The pictures of one run, each fetched once. */
export class PictureShelf {
  readonly #fetch: (asked: PictureAsked) => Promise<string | null>;
  readonly #pictures = new Map<string, Promise<string | null>>();
  #run: object | null = null;
  #of: PictureOf = 'plan';

  constructor(fetch: (asked: PictureAsked) => Promise<string | null>) {
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

  /**
   * SVG text; null where the run has no such picture.
   *
   * @param round from 1; the last where absent
   * @throws FloorPlanError
   */
  get(name: string, round?: number): Promise<string | null> {
    const key = `${name} ${round ?? 'last'}`;
    let picture = this.#pictures.get(key);
    if (!picture) {
      picture = this.#fetch({ name, of: this.#of, round });
      this.#pictures.set(key, picture);
      // What failed or was cancelled may be asked for again.
      picture.catch(() => this.#pictures.delete(key));
    }
    return picture;
  }
}
