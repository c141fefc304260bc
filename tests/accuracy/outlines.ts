import {
  distance,
  distanceToSegment,
  interpolate,
  perimeter,
  signedArea,
  type XY,
} from '../../fixtures/simulator/ring.ts';

/** m */
const SAMPLE_STEP = 0.05;
/** A vertex that turns by less belongs to a curve, degrees. */
const CORNER_TURN_DEG = 12;
/** Edges shorter than this have no direction, m. */
const TINY = 1e-9;

/** The ring as the reference measure walks it: clockwise from its first vertex. */
export function clockwise(ring: readonly XY[]): readonly XY[] {
  return signedArea(ring) > 0 ? [ring[0], ...ring.slice(1).reverse()] : ring;
}

/** Points every 5 cm along each ring, from its first vertex on; the last stretch, shorter than that, is left out. */
export function sampleRings(rings: readonly (readonly XY[])[]): XY[] {
  return rings.flatMap(sampleRing);
}

function sampleRing(ring: readonly XY[]): XY[] {
  const count = Math.max(1, Math.trunc(perimeter(ring) / SAMPLE_STEP));
  const samples: XY[] = [];
  let walked = 0;
  for (let i = 0; i < ring.length && samples.length < count; i++) {
    const next = ring[(i + 1) % ring.length];
    const length = distance(ring[i], next);
    while (samples.length < count && samples.length * SAMPLE_STEP <= walked + length && length > 0) {
      samples.push(interpolate(ring[i], next, (samples.length * SAMPLE_STEP - walked) / length));
    }
    walked += length;
  }
  return samples;
}

/** Distance of each point to the nearest of the rings' lines, m. O(points · edges). */
export function offsets(points: readonly XY[], rings: readonly (readonly XY[])[]): number[] {
  return points.map(([x, y]) => {
    let best = Infinity;
    for (const ring of rings) {
      for (let i = 0; i < ring.length; i++) {
        best = Math.min(best, distanceToSegment(x, y, ring[i], ring[(i + 1) % ring.length]));
      }
    }
    return best;
  });
}

/** Vertices that really turn. */
export function cornersOf(rings: readonly (readonly XY[])[]): XY[] {
  return rings.flatMap((ring) =>
    ring.filter((point, i) => {
      const before = ring[(i + ring.length - 1) % ring.length];
      const after = ring[(i + 1) % ring.length];
      const [ax, ay] = [point[0] - before[0], point[1] - before[1]];
      const [bx, by] = [after[0] - point[0], after[1] - point[1]];
      if (Math.hypot(ax, ay) < TINY || Math.hypot(bx, by) < TINY) return false;
      const turn = Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by));
      return (turn * 180) / Math.PI > CORNER_TURN_DEG;
    }),
  );
}

/** Value below which this share of the values lies, between neighbours in proportion. */
export function quantile(values: readonly number[], share: number): number {
  const sorted = Float64Array.from(values).sort();
  const at = share * (sorted.length - 1);
  const low = Math.floor(at);
  const high = Math.min(low + 1, sorted.length - 1);
  return sorted[low] + (sorted[high] - sorted[low]) * (at - low);
}
