import type { PictureFacts, PictureOf } from '../worker/protocol.ts';
import type { PlanMaker } from './plan-maker.ts';

/** Which step's picture stands in place of the drawing, of the plan shown or of the run that failed after it. */
export class StepChoice {
  readonly #maker: PlanMaker;
  #name: string | null = null;
  #place = 0;
  #of: PictureOf = 'plan';

  constructor(maker: PlanMaker) {
    this.#maker = maker;
  }

  /** Null while the drawing is shown. */
  get name(): string | null {
    return this.#name;
  }

  /** Whose pictures they are; a run that ends well ends those of the one that failed. */
  get of(): PictureOf {
    return this.#maker.failed === null ? 'plan' : this.#of;
  }

  get pictures(): readonly PictureFacts[] {
    const { failed, view } = this.#maker;
    return (this.of === 'failed' ? failed?.pictures : view?.pictures) ?? [];
  }

  /** The chosen picture; where this plan lacks it, the one in its place. */
  get picture(): PictureFacts | null {
    if (this.#name === null) return null;
    const { pictures } = this;
    const chosen = pictures.findIndex(({ name }) => name === this.#name);
    if (chosen >= 0) this.#place = chosen;
    return pictures[Math.min(this.#place, pictures.length - 1)] ?? null;
  }

  /** Shows a picture of the plan shown; null shows the drawing again. */
  open(name: string | null): void {
    this.#name = name;
    if (name === null) this.#of = 'plan';
  }

  /** Goes to the pictures of the plan shown, or to the last one the failed run got to. */
  turnTo(of: PictureOf): void {
    this.#of = of;
    if (of === 'failed') this.#name = this.pictures.at(-1)?.name ?? null;
  }

  /** Forth by 1, back by −1; at either end nothing happens. */
  move(by: 1 | -1): void {
    const { picture, pictures } = this;
    const next = picture && pictures[pictures.indexOf(picture) + by];
    if (next) this.#name = next.name;
  }
}
