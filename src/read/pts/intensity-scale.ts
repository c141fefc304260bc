import type { PointChunk } from '../cloud-reader.ts';

/** What Leica's scanners count. */
const LEAST = -2048;
const MOST = 2047;
const MOST_BYTE = 255;

/**
 * Maps the intensity of a PTS file to 0 … 1.
 *
 * Leica's own files hold −2048 … 2047; other programs write bytes or shares into them. The first chunk tells which;
 * what fits none is left as read.
 */
export class IntensityScale {
  #shift: number | undefined;
  #factor = 1;

  apply(chunk: PointChunk): PointChunk {
    const { intensity, count } = chunk;
    if (!intensity) return chunk;
    if (this.#shift === undefined) this.#judge(intensity.subarray(0, count));
    const shift = this.#shift ?? 0;
    for (let i = 0; i < count; i++) intensity[i] = (intensity[i] + shift) * this.#factor;
    return chunk;
  }

  #judge(values: Float32Array): void {
    let least = 0;
    let most = 0;
    for (const value of values) {
      if (value < least) least = value;
      if (value > most) most = value;
    }
    const isLeica = least >= LEAST && most <= MOST && (least < 0 || most > MOST_BYTE);
    const isByte = least >= 0 && most > 1 && most <= MOST_BYTE;
    this.#shift = isLeica ? -LEAST : 0;
    if (isLeica) this.#factor = 1 / (MOST - LEAST);
    else if (isByte) this.#factor = 1 / MOST_BYTE;
  }
}
