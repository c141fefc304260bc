import type { PointChunk } from './cloud-reader.ts';

/** Points of one preview. */
const BATCH_POINTS = 4096;
/** Of so many points one is shown, at first. */
const FIRST_STRIDE = 16;
/** After so many points shown the stride doubles: a view stays light under any scan. */
const POINTS_PER_STRIDE = 1 << 16;

/** Shows a sample of the points while they are read. */
export class Preview {
  readonly #show: (positions: Float32Array) => void;
  #batch = new Float32Array(3 * BATCH_POINTS);
  #filled = 0;
  #stride = FIRST_STRIDE;
  #shown = 0;
  #origin: readonly [number, number, number] | null = null;

  /** @param show takes x, y, z a point, source axes and units, relative to the first finite point */
  constructor(show: (positions: Float32Array) => void) {
    this.#show = show;
  }

  add({ count, xyz }: PointChunk): void {
    for (let i = 0; i < count; i += this.#stride) {
      const [x, y, z] = [xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]];
      if (!Number.isFinite(x + y + z)) continue;
      this.#origin ??= [x, y, z];
      this.#batch[this.#filled++] = x - this.#origin[0];
      this.#batch[this.#filled++] = y - this.#origin[1];
      this.#batch[this.#filled++] = z - this.#origin[2];
      if (this.#filled === this.#batch.length) this.flush();
    }
  }

  /** Shows what has gathered. */
  flush(): void {
    if (this.#filled === 0) return;
    this.#shown += this.#filled / 3;
    if (this.#shown >= POINTS_PER_STRIDE) {
      this.#shown = 0;
      this.#stride *= 2;
    }
    this.#show(this.#batch.slice(0, this.#filled));
    this.#filled = 0;
  }
}
