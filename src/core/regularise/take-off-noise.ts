import { buildPointGrid } from '../geometry/point-grid.ts';
import { distinctPoints } from '../geometry/point-order.ts';
import type { Ring, Slice } from '../types.ts';
import { chainBetween, stripAlong } from './chain-strip.ts';
import { bandwidthFor } from './face-offset.ts';
import { type RingDraft, settleRings } from './settle-rings.ts';
import { StripPoints } from './strip-points.ts';
import { distanceToLine, fitWallLine, projectOnto, type WallLine } from './wall-line.ts';

/** Bandwidths of hull over which the wall beside a vertex is looked at: far above its noise, below a niche's width. */
const WINDOW = 10;
/** Points of a face lie up to this many bandwidths behind the hull, and no vertex moves farther. */
const REACH = 3;
/** Where the points of one side lie this much straighter than those of both, a corner is near. */
const STRAIGHTER = 0.8;

/**
 * Takes off the outer noise a hull stands on, however many vertices it has: each is projected onto a line fitted to the
 * points beside it, as in moving least squares [Levin98], and near a corner to those of one side of it.
 *
 * Of a wall scanned from both sides, or with furniture before it, it is the outer face, see {@link fitWallLine}. A
 * vertex without points enough beside it stays.
 *
 * @returns rings vertex by vertex those given, and as valid: where moved vertices would make edges cross they stay.
 *   O(points) for vertices of even density.
 */
export function takeOffNoise(hulls: readonly Ring[], slice: Pick<Slice, 'xy' | 'spacing'>): readonly Ring[] {
  if (slice.xy.length === 0) return hulls;
  const bandwidth = bandwidthFor(slice.spacing);
  const points = new StripPoints(buildPointGrid(distinctPoints(slice.xy), bandwidth));
  const drafts = hulls.map((hull) => draftOf(hull, points, bandwidth));
  return settleRings(hulls, drafts);
}

function draftOf(hull: Ring, points: StripPoints, bandwidth: number): RingDraft {
  const kept = Array.from({ length: hull.length / 2 }, (_, v) => v);
  const moved = new Map<number, readonly [x: number, y: number]>();
  for (const v of kept) {
    const old = [hull[2 * v], hull[2 * v + 1]] as const;
    const line = lineBeside(hull, v, points, bandwidth);
    if (line === null || Math.abs(distanceToLine(line, old)) > REACH * bandwidth) continue;
    moved.set(v, projectOnto(line, old));
  }
  return { kept, moved };
}

/** The line through the points on both sides of a vertex or, where much straighter, on one. */
function lineBeside(hull: Ring, v: number, points: StripPoints, bandwidth: number): WallLine | null {
  const along = WINDOW * bandwidth;
  const windows = [
    [vertexWithin(hull, v, -1, along / 2), vertexWithin(hull, v, 1, along / 2)],
    [vertexWithin(hull, v, -1, along), v],
    [v, vertexWithin(hull, v, 1, along)],
  ] as const;
  let best: WallLine | null = null;
  for (const [from, to] of windows) {
    const strip = from === to ? null : stripAlong(chainBetween(hull, from, to), 0, REACH * bandwidth);
    if (strip === null) continue;
    points.gather(strip);
    const line = fitWallLine(points, strip, bandwidth);
    if (line !== null && (best === null || line.deviation < STRAIGHTER * best.deviation)) best = line;
    const bend = strip.across[1] - REACH * bandwidth - strip.across[0];
    if (best !== null && bend <= bandwidth) break;
  }
  return best;
}

/** The first vertex from v on that is so far away, or the last before an edge much longer: a bridged gap. */
function vertexWithin(hull: Ring, v: number, step: 1 | -1, distance: number): number {
  const n = hull.length / 2;
  let at = v;
  for (let k = 0; k < n / 2; k++) {
    const next = (at + step + n) % n;
    const far = Math.hypot(hull[2 * next] - hull[2 * v], hull[2 * next + 1] - hull[2 * v + 1]);
    if (far > 2 * distance) break;
    at = next;
    if (far >= distance) break;
  }
  return at;
}
