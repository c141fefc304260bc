/** Made-up slices for boundary tests: points along walls, with gaps and noise, from a seed. */
import type { StageContext } from '../../../../src/core/context.ts';
import { meanSpacing } from '../../../../src/core/geometry/spacing.ts';
import { resolveOptions } from '../../../../src/core/options.ts';
import type { Options } from '../../../../src/core/params.ts';
import type { Slice, Warning } from '../../../../src/core/types.ts';

/** Uniform numbers in [0, 1) from a seed (mulberry32). */
export function randomNumbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

export function normalNumbers(random: () => number): () => number {
  return () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
}

export type Path = readonly (readonly [number, number])[];

/** A room with a concave corner, m. */
export const ELL: Path = [
  [0, 0],
  [6, 0],
  [6, 2],
  [3, 2],
  [3, 5],
  [0, 5],
];

export interface WallScan {
  /** Walls as open paths; a closed ring repeats its first vertex. */
  readonly walls: readonly Path[];
  /** Points per metre of wall. */
  readonly perMetre: number;
  /** Standard deviation across and along, m. */
  readonly noise: number;
  readonly seed: number;
  /** No point within these discs or stretches: from, to along wall number `wall`, metres from its start. */
  readonly gaps?: readonly { readonly wall: number; readonly from: number; readonly to: number }[];
  /** Stray points: as many, in the box given. */
  readonly strays?: { readonly count: number; readonly box: readonly [number, number, number, number] };
}

/** The points of a scan of walls. */
export function scanWalls({ walls, perMetre, noise, seed, gaps = [], strays }: WallScan): Float64Array {
  const random = randomNumbers(seed);
  const normal = normalNumbers(random);
  const xy: number[] = [];
  walls.forEach((path, wall) => {
    let start = 0;
    for (let k = 0; k + 1 < path.length; k++) {
      const [a, b] = [path[k], path[k + 1]];
      const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
      for (let n = Math.round(length * perMetre); n > 0; n--) {
        const along = random() * length;
        const at = start + along;
        const dx = normal() * noise;
        const dy = normal() * noise;
        if (gaps.some((gap) => gap.wall === wall && at > gap.from && at < gap.to)) continue;
        xy.push(a[0] + ((b[0] - a[0]) * along) / length + dx, a[1] + ((b[1] - a[1]) * along) / length + dy);
      }
      start += length;
    }
  });
  for (let n = strays?.count ?? 0; n > 0 && strays !== undefined; n--) {
    const [x0, y0, x1, y1] = strays.box;
    xy.push(x0 + random() * (x1 - x0), y0 + random() * (y1 - y0));
  }
  return Float64Array.from(xy);
}

export function asSlice(xy: Float64Array): Slice {
  return { xy, band: [0, 1], spacing: meanSpacing(xy) };
}

export function optionsWith(given: Partial<Options> = {}): Options {
  return resolveOptions(given);
}

/** A context that keeps the warnings. The stroke test is the canvas's; no boundary method asks it. */
export function listeningContext(): StageContext & { readonly warnings: Warning[] } {
  const warnings: Warning[] = [];
  return {
    warnings,
    warn: (warning) => warnings.push(warning),
    progress: () => {},
    strokeTest: () => {
      throw new Error('the boundary stage asks no stroke test');
    },
  };
}

/** Closes a path. */
export function closed(path: Path): Path {
  return [...path, path[0]];
}
