import { PLANE_REACH } from '../columns/height-columns.ts';
import { alongOf, asideOf, type Face, type FaceSite, pointOn } from './face.ts';
import { columnsAlong, type FaceBits } from './face-bits.ts';

/** Points are counted in layers of this height, m: finer than the gap a wardrobe needs to be set up … */
const LAYER = 0.025;
/** … from this far above the ceiling, m … */
const ABOVE = 0.1;
/** … to 0.7 m below it. */
const LAYERS = 32;
/** Points so far off a face are its own, m, or so many deviations. */
const BAND = 0.03;
const DEVIATIONS = 3;
/** Bits are looked at over so long a stretch of the face, m; over a longer one where that holds too few points. */
const LOOKS = [0.5, 1];
/** Fewer points at the top are strays. */
const FEWEST_ON_TOP = 3;
/** So far down, m, or so many deviations, the highest points may be a ceiling's, spread by noise: a gap begins there … */
const CEILING_SPREAD = 0.05;
const SPREADS = 4;
/** … or so many layers farther down, and is so many high. */
const SLACK = 1;
const LEAST_GAP = 2;
/** What a face's density is told by: its densest layers, for cupboards before it may hide the others … */
const DENSEST = 8;
/** … if a gap would cost so many points. */
const FEWEST = 4;
/** A layer with less than this share of those layers' mean is empty. */
const EMPTY = 0.25;

/**
 * Whether a face ends below the ceiling, 1 or 0 a bit: furniture does, walls do not; NaN where too little was seen.
 *
 * Below the highest points along a cupboard, which are the ceiling's, layers are empty; below a wall's they are as full as
 * farther down. Points in rows farther apart than the gap tell nothing. It needs no height of the ceiling to be exact, so
 * slopes and sagging do not matter. O(points near the top of the face).
 */
export function gapAbove(site: FaceSite, face: Face, bits: FaceBits): Float64Array {
  const layers = countLayers(site, face, bits);
  const spread = Math.ceil(Math.max(CEILING_SPREAD, SPREADS * face.noise) / LAYER);
  return Float64Array.from({ length: bits.count }, (_, k) => {
    for (const look of LOOKS) {
      const half = Math.round(look / 2 / bits.step);
      const from = Math.max(0, k - half);
      const gap = gapIn(summed(layers, from, Math.min(bits.count, k + half + 1)), spread);
      if (!Number.isNaN(gap)) return gap;
    }
    return Number.NaN;
  });
}

/** Points of a face by height, layer by layer from above, a bit after the other. */
function countLayers(
  { cloud: { positions }, columns, ceiling }: FaceSite,
  face: Face,
  bits: FaceBits,
): Uint32Array {
  const { from, step, count } = bits;
  const { size, points, start, overhead, overPoints, overStart } = columns;
  const band = Math.max(BAND, DEVIATIONS * face.noise);
  const layers = new Uint32Array(count * LAYERS);
  const top = Float64Array.from(
    { length: count },
    (_, k) => ABOVE + ceiling.at(...pointOn(face, from + (k + 0.5) * step)),
  );
  const take = (i: number) => {
    const [x, y] = [positions[i], positions[i + 1]];
    const bit = Math.floor((alongOf(face, x, y) - from) / step);
    if (bit < 0 || bit >= count || Math.abs(asideOf(face, x, y)) > band) return;
    const layer = Math.floor((top[bit] - positions[i + 2]) / LAYER);
    if (layer >= 0 && layer < LAYERS) layers[bit * LAYERS + layer]++;
  };
  for (const c of columnsAlong(columns, face, bits, band + size)) {
    for (let p = overStart[c]; p < overStart[c + 1]; p++) take(3 * overPoints[p]);
    // Those of a lowered ceiling are below the storey's: they were just taken.
    const below = overhead[c] - PLANE_REACH;
    for (let p = start[c]; p < start[c + 1]; p++)
      if (!(positions[3 * points[p] + 2] > below)) take(3 * points[p]);
  }
  return layers;
}

/** Sums of the layers of some bits. */
function summed(layers: Uint32Array, from: number, to: number): Uint32Array {
  const sums = new Uint32Array(LAYERS);
  for (let at = from * LAYERS; at < to * LAYERS; at++) sums[at % LAYERS] += layers[at];
  return sums;
}

function gapIn(layers: Uint32Array, spread: number): number {
  let [top, onTop] = [0, 0];
  while (top < LAYERS && onTop + layers[top] < FEWEST_ON_TOP) onTop += layers[top++];
  const { first, mean } = densestLayers(layers, top + spread);
  const emptyFrom = (layer: number) => {
    let end = layer;
    while (end < LAYERS && layers[end] < EMPTY * mean) end++;
    return end - layer;
  };
  let longest = 0;
  for (let layer = first; layer < first + DENSEST; layer++) longest = Math.max(longest, emptyFrom(layer));
  if (mean * LEAST_GAP < FEWEST || longest >= LEAST_GAP) return Number.NaN;
  let gap = 0;
  for (let skipped = 0; skipped <= SLACK && gap === 0; skipped++) gap = emptyFrom(top + spread + skipped);
  return gap >= LEAST_GAP ? 1 : 0;
}

/** The first of the layers, from one on, that hold the most points together, and the mean of what they hold. */
function densestLayers(layers: Uint32Array, from: number): { first: number; mean: number } {
  let [first, most] = [from, 0];
  for (let layer = from; layer + DENSEST <= LAYERS; layer++) {
    const points = layers.subarray(layer, layer + DENSEST).reduce((sum, n) => sum + n, 0);
    if (points > most) [first, most] = [layer, points];
  }
  return { first, mean: most / DENSEST };
}
