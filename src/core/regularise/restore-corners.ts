import { buildPointGrid } from '../geometry/point-grid.ts';
import { distinctPoints } from '../geometry/point-order.ts';
import { leastVertex } from '../geometry/rings.ts';
import { squaredDistanceToSegment } from '../geometry/segments.ts';
import type { Ring, Slice } from '../types.ts';
import { chainBetween, stripAlong } from './chain-strip.ts';
import { bandwidthFor } from './face-offset.ts';
import { placesIn } from './places-in.ts';
import { type RingDraft, settleRings } from './settle-rings.ts';
import { StripPoints } from './strip-points.ts';
import {
  distanceToLine,
  fitWallLine,
  meetingOf,
  type Point,
  projectOnto,
  type WallLine,
} from './wall-line.ts';

/** Points of a face lie up to this many bandwidths behind the hull: the far side of the noise. */
const REACH = 3;
/**
 * A vertex moves by at most this many bandwidths: where lines meet further off they do not belong together, and a line
 * further off is no face of the wall the vertex stands on, as where ε is larger than the rooms.
 */
const FARTHEST_CORNER = 4;
/** Edges shorter than this many bandwidths have no direction of their own. */
const SHORTEST_EDGE = 2;
/** Steps of this many standard deviations of a wall's points are noise. */
const NOISE = 2;
/** A merged edge is fitted again and may merge again. */
const MOST_ROUNDS = 4;

/**
 * Restores the corners that simplification cut, and takes off the outer noise the outline stands on. Ours; the paper
 * names lost corners as its weakness ([Stojanovic19] §5).
 *
 * To each edge a line is fitted by the points it stands for, and neighbouring lines meet in the new vertex. Where they
 * are nearly parallel, as in a gentle bend, the old vertex is projected onto both. No vertex moves far. An edge without
 * points, a bridged gap, stays straight between its ends. A vertex within the noise of a straight wall goes, and so does an edge that cuts a
 * corner: one too short to have a direction, or no further from the corner than the noise.
 *
 * @param rings simplified
 * @param hulls the rings they were simplified from: no point that an edge stands for lies outside its stretch of hull
 * @param bandwidth points nearer across are not told apart, m; give it where the noise is known
 * @param from the hulls with vertices moved, where it was those that were simplified
 * @returns rings as valid as those given: where a moved vertex would make edges cross it stays. O(points).
 */
export function restoreCorners(
  rings: readonly Ring[],
  hulls: readonly Ring[],
  { xy, spacing }: Pick<Slice, 'xy' | 'spacing'>,
  { bandwidth = bandwidthFor(spacing), from = hulls }: Given = {},
): readonly Ring[] {
  if (xy.length === 0) return rings;
  const points = new StripPoints(buildPointGrid(distinctPoints(xy), bandwidth));
  const drafts = rings.map((ring, r) => {
    const places = placesIn(from[r], ring);
    return new Refining({ ring, hull: hulls[r], places }, points, bandwidth).draft();
  });
  return settleRings(rings, drafts);
}

interface Given {
  readonly bandwidth?: number;
  readonly from?: readonly Ring[];
}

interface Simplified {
  readonly ring: Ring;
  readonly hull: Ring;
  /** Number in the hull of each vertex. */
  readonly places: readonly number[];
}

/** One ring; an edge goes by the place of its first vertex in `kept`. */
class Refining {
  private readonly ring: Ring;
  private readonly hull: Ring;
  private readonly places: readonly number[];
  private readonly points: StripPoints;
  private readonly bandwidth: number;
  private readonly fitted = new Map<number, WallLine | null>();
  private kept: readonly number[];
  private lines: readonly (WallLine | null)[];
  /** New places of the vertices kept. */
  private corners: readonly Point[];

  constructor({ ring, hull, places }: Simplified, points: StripPoints, bandwidth: number) {
    this.ring = ring;
    this.hull = hull;
    this.places = places;
    this.points = points;
    this.bandwidth = bandwidth;
    this.kept = verticesFromFirst(ring);
    this.lines = this.fitLines();
    this.corners = this.placeCorners();
  }

  draft(): RingDraft {
    for (let round = 0; round < MOST_ROUNDS; round++) {
      const needless = this.needless();
      if (needless.size === 0) break;
      this.kept = this.kept.filter((_, k) => !needless.has(k));
      this.lines = this.fitLines();
      this.corners = this.placeCorners();
    }
    const moved = new Map(this.kept.map((vertex, k) => [vertex, this.corners[k]]));
    return { kept: [...this.kept].sort((a, b) => a - b), moved };
  }

  private fitLines(): (WallLine | null)[] {
    return this.kept.map((from, k) => {
      const to = this.kept[this.after(k)];
      const key = from * this.ring.length + to;
      let line = this.fitted.get(key);
      if (line === undefined) {
        line = this.fitLine(from, to);
        this.fitted.set(key, line);
      }
      return line;
    });
  }

  private fitLine(from: number, to: number): WallLine | null {
    const { bandwidth } = this;
    const length = distance(this.vertex(from), this.vertex(to));
    if (length < SHORTEST_EDGE * bandwidth) return null;
    const chain = chainBetween(this.hull, this.places[from], this.places[to]);
    const strip = stripAlong(chain, bandwidth, REACH * bandwidth);
    if (strip === null) return null;
    this.points.gather(strip);
    return fitWallLine(this.points, strip, bandwidth);
  }

  private placeCorners(): Point[] {
    return this.kept.map((vertex, k) => {
      const old = this.vertex(vertex);
      const near = (point: Point) => distance(point, old) <= FARTHEST_CORNER * this.bandwidth;
      const [one, other] = [this.lines[this.before(k)], this.lines[k]];
      const corner = one && other && meetingOf(one, other);
      if (corner !== null && near(corner)) return corner;
      const feet = [one, other]
        .flatMap((line) => (line === null ? [] : [projectOnto(line, old)]))
        .filter(near);
      return feet.length === 0 ? old : middleOf(feet);
    });
  }

  /** Places in `kept` of vertices that can go, never two in a row: small steps must not add up. */
  private needless(): Set<number> {
    const found = new Set<number>();
    for (let k = 0; k < this.kept.length && this.kept.length - found.size > 3; k++) {
      if (found.has(this.before(k)) || found.has(this.after(k))) continue;
      if (this.isFlat(k) || this.endsCutCorner(k)) found.add(k);
    }
    return found;
  }

  /** Whether vertex k lies on one straight wall, but for the noise. */
  private isFlat(k: number): boolean {
    const [one, other] = [this.lines[this.before(k)], this.lines[k]];
    if (one === null || other === null || !isOnwards(one, other)) return false;
    const [before, after] = [this.corners[this.before(k)], this.corners[this.after(k)]];
    return squaredDistanceToSegment(...this.corners[k], ...before, ...after) <= noiseOf(one, other) ** 2;
  }

  /** Whether the edge that ends at vertex k stands where the lines beside it meet, or are one. */
  private endsCutCorner(k: number): boolean {
    const edge = this.before(k);
    const [one, line, other] = [this.lines[this.before(edge)], this.lines[edge], this.lines[k]];
    if (one === null || other === null) return false;
    const [a, b] = [this.vertex(this.kept[edge]), this.vertex(this.kept[k])];
    const reach = FARTHEST_CORNER * this.bandwidth;
    if (distance(a, b) > reach) return false;
    const noise = noiseOf(one, other);
    const corner = meetingOf(one, other);
    if (corner === null) {
      const steps = Math.max(Math.abs(distanceToLine(one, b)), Math.abs(distanceToLine(other, a)));
      return isOnwards(one, other) && steps <= noise;
    }
    if (line !== null) return squaredDistanceToSegment(...corner, ...a, ...b) <= noise ** 2;
    return distance(corner, a) <= reach && distance(corner, b) <= reach;
  }

  private vertex(v: number): Point {
    return [this.ring[2 * v], this.ring[2 * v + 1]];
  }

  private before(k: number): number {
    return (k + this.kept.length - 1) % this.kept.length;
  }

  private after(k: number): number {
    return (k + 1) % this.kept.length;
  }
}

function isOnwards(a: WallLine, b: WallLine): boolean {
  return a.ux * b.ux + a.uy * b.uy > 0;
}

function noiseOf(a: WallLine, b: WallLine): number {
  return NOISE * Math.max(a.deviation, b.deviation);
}

function middleOf(points: readonly Point[]): Point {
  const [x, y] = points.reduce(([sumX, sumY], point) => [sumX + point[0], sumY + point[1]]);
  return [x / points.length, y / points.length];
}

function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** All vertices, from the first by x, then y: what is found must not depend on where the ring starts. */
function verticesFromFirst(ring: Ring): number[] {
  const n = ring.length / 2;
  const first = leastVertex(ring);
  return Array.from({ length: n }, (_, k) => (first + k) % n);
}
