import type { StageContext } from '../context.ts';
import { orientation } from '../geometry/predicates.ts';
import { squaredDistanceToSegment } from '../geometry/segments.ts';
import type { Gap, Ring } from '../types.ts';
import { isClear, missingCorner } from './gap-corner.ts';
import { coordinatesOf } from './hull-ring.ts';
import { NOISE_DEPTH, type Opening } from './opening.ts';
import { findOpeningPoint } from './opening-point.ts';
import { continuesWalls } from './wall-run.ts';

/**
 * A gap lies between walls: the outline turns by less than this at its ends (a whole wall may be missing, and of one
 * beside it more than of the other), not back as at a stray point. Cosine of 135°.
 */
const LEAST_COSINE = -Math.SQRT1_2;
/** Gaps told one by one in the warning; the rest are counted. */
const TOLD = 3;

/** A bridge that is a gap in a wall: its first point, and the corner it took away, if any. */
export interface BridgedGap {
  readonly a: number;
  readonly corner: Gap['from'] | null;
}

/**
 * Which bridges are gaps in walls, and the corners these took away.
 *
 * @param opening down to `supportLength`, so that the walls at the gaps' ends show whatever the opening length
 * @param longestLeg longest way from a gap's end to its corner, m
 */
export function findGaps(opening: Opening, longestLeg: number): readonly BridgedGap[] {
  const { hull, bridges } = opening;
  if (bridges.length === 0) return [];
  const { x, y } = hull.grid;
  const ring = coordinatesOf(hull);
  const found: BridgedGap[] = [];
  for (let k = 0; k < bridges.length; k += 2) {
    const a = bridges[k];
    if (!continuesWalls(hull, a, LEAST_COSINE)) continue;
    const corner = missingCorner(ring, vertexAt(ring, [x[a], y[a]]), longestLeg);
    found.push({ a, corner: corner === null || hidesPoint(opening, a, corner) ? null : corner });
  }
  return found;
}

/**
 * The ring of an opening with the corners that gaps took away put back, and the gaps, widest first.
 *
 * A put-back corner is the one vertex that is no point of the slice; it splits its gap in two.
 */
export function closeGaps(
  { hull }: Opening,
  found: readonly BridgedGap[],
): { readonly ring: Ring; readonly gaps: Gap[] } {
  const { x, y } = hull.grid;
  const gaps: Gap[] = [];
  let ring = coordinatesOf(hull);
  for (const { a, corner } of found) {
    const b = hull.next[a];
    const from = [x[a], y[a]] as const;
    const to = [x[b], y[b]] as const;
    const edge = vertexAt(ring, from);
    if (corner === null || !isClear(ring, edge, corner)) gaps.push(gapBetween(from, to));
    else {
      ring = withVertex(ring, edge, corner);
      gaps.push(gapBetween(from, corner), gapBetween(corner, to));
    }
  }
  gaps.sort((p, q) => q.width - p.width || p.from[0] - q.from[0] || p.from[1] - q.from[1]);
  return { ring, gaps };
}

/** Tells of bridged gaps: `boundary/gap-bridged`, widths in metres, places as a person finds them in the source. */
export function warnOfGaps(gaps: readonly Gap[], context: StageContext): void {
  if (gaps.length === 0) return;
  const told = gaps.slice(0, TOLD).map(({ from, to, width }) => {
    const [x, y] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    const place = context.placeInSource?.(x, y) ?? `(${x.toFixed(2)}, ${y.toFixed(2)}) m`;
    return `${width.toFixed(2)} m wide at ${place}`;
  });
  const more = gaps.length > TOLD ? `, and ${gaps.length - TOLD} narrower` : '';
  const count = gaps.length === 1 ? 'a gap' : `${gaps.length} gaps`;
  context.warn({
    code: 'boundary/gap-bridged',
    message: `The outline bridges ${count} in the walls: ${told.join(', ')}${more}.`,
    hint: 'A door, a window or a stretch the scanner did not see; bridgeGap sets how wide a gap is bridged.',
  });
}

/** Whether a point lies between the bridge a → next[a] and a corner inside the ring, and not on the walls that meet there. */
function hidesPoint({ hull }: Opening, a: number, corner: Gap['from']): boolean {
  const { x, y } = hull.grid;
  const b = hull.next[a];
  const isLeftOf = (px: number, py: number, qx: number, qy: number, k: number) =>
    orientation(px, py, qx, qy, x[k], y[k]) >= 0;
  const isNear = (k: number, end: number) =>
    squaredDistanceToSegment(x[k], y[k], x[end], y[end], ...corner) <= NOISE_DEPTH ** 2;
  const isElsewhere = (k: number) =>
    !isLeftOf(x[b], y[b], ...corner, k) ||
    !isLeftOf(...corner, x[a], y[a], k) ||
    isNear(k, a) ||
    isNear(k, b);
  return orientation(x[a], y[a], x[b], y[b], ...corner) > 0 && findOpeningPoint(hull, a, b, isElsewhere) >= 0;
}

function gapBetween(from: Gap['from'], to: Gap['to']): Gap {
  return { from, to, width: Math.hypot(to[0] - from[0], to[1] - from[1]) };
}

function vertexAt(ring: Ring, [x, y]: Gap['from']): number {
  for (let i = 0; i < ring.length; i += 2) if (ring[i] === x && ring[i + 1] === y) return i / 2;
  return -1;
}

function withVertex(ring: Ring, after: number, [x, y]: Gap['from']): Ring {
  const larger = new Float64Array(ring.length + 2);
  const at = 2 * after + 2;
  larger.set(ring.subarray(0, at));
  larger.set([x, y], at);
  larger.set(ring.subarray(at), at + 2);
  return larger;
}
