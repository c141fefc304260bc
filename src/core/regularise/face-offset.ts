/** Points nearer across a wall than this many mean spacings are not told apart … */
const BANDWIDTH_SPACINGS = 2;
/** … nor than this, m: above the noise of a scanner, a third of the thinnest wall's thickness. */
const LEAST_BANDWIDTH = 0.025;
/** Bins a bandwidth. */
const BINS = 4;
/** A face must hold this share of the points of the strongest one beside it: fewer are reveals, frames and noise. */
const LEAST_SHARE = 0.3;
/** A peak ends, and the next begins, where the density has fallen to, and rises from, this share. */
const VALLEY = 0.7;

/** Where across a strip a wall's face is. */
export interface FaceOffset {
  readonly peak: number;
  /** The densest points belong to this face up to here; behind it another may begin. */
  readonly end: number;
}

/** How near points across a wall are not told apart, m, where the noise is not known. */
export function bandwidthFor(spacing: number): number {
  return Math.max(LEAST_BANDWIDTH, BANDWIDTH_SPACINGS * spacing);
}

/**
 * The first dense face across a strip, seen from its low side: where both faces of a wall were scanned, or furniture
 * stands before it, the one the outline stands on.
 *
 * The peaks of a density by a triangular kernel; dips of less than a third are noise.
 *
 * @param offsets m, of which the first `size` count
 * @param bandwidth m; faces nearer to each other than about twice this are one
 * @returns null for no points, and where they grow no sparser behind the peak: they fill an area, as a floor does, and no
 *   face stands out. O(points + range / bandwidth).
 */
export function firstFace(
  offsets: Float64Array,
  size: number,
  [low, high]: readonly [number, number],
  bandwidth: number,
): FaceOffset | null {
  const density = smoothed(counts(offsets, size, low, high, bandwidth / BINS));
  const most = density.reduce((a, b) => Math.max(a, b), 0);
  if (most === 0) return null;
  let peak = 0;
  for (let bin = 1; bin < density.length; bin++) {
    if (density[bin] > density[peak]) peak = bin;
    else if (density[bin] >= VALLEY * density[peak]) continue;
    else if (density[peak] >= LEAST_SHARE * most) break;
    else peak = bin;
  }
  let valley = peak;
  for (let bin = peak; bin < density.length; bin++) {
    if (density[bin] < density[valley]) valley = bin;
    else if (VALLEY * density[bin] > density[valley]) break;
  }
  // The last bins lack the points beyond the strip, so they seem sparser.
  const behind = density.subarray(peak, Math.max(peak + 1, density.length - BINS + 1));
  if (behind.every((value) => value >= VALLEY * density[peak])) return null;
  const centre = (bin: number) => low + ((bin + 0.5) * bandwidth) / BINS;
  return { peak: centre(peak), end: valley > peak ? centre(valley) : high };
}

function counts(offsets: Float64Array, size: number, low: number, high: number, width: number): Float64Array {
  const bins = new Float64Array(Math.max(1, Math.ceil((high - low) / width)));
  for (let k = 0; k < size; k++) {
    const bin = Math.floor((offsets[k] - low) / width);
    if (bin >= 0) bins[Math.min(bin, bins.length - 1)]++;
  }
  return bins;
}

/** By a triangular kernel. */
function smoothed(bins: Float64Array): Float64Array {
  const density = new Float64Array(bins.length);
  for (let bin = 0; bin < bins.length; bin++) {
    const last = Math.min(bins.length - 1, bin + BINS - 1);
    for (let k = Math.max(0, bin - BINS + 1); k <= last; k++)
      density[bin] += (BINS - Math.abs(k - bin)) * bins[k];
  }
  return density;
}
