import { buildPointGrid } from '../geometry/point-grid.ts';
import { squaredDistanceToSegment } from '../geometry/segments.ts';
import type { Ring, Slice } from '../types.ts';
import { settleRings } from './settle-rings.ts';
import { type Strip, StripPoints } from './strip-points.ts';
import { fitWallLine, type WallLine } from './wall-line.ts';

/** Points nearer across than this many mean spacings are not told apart … */
const BANDWIDTH_SPACINGS = 2;
/** … nor than this, m: the noise of a good scanner; faces of a wall are three times farther apart. */
const LEAST_BANDWIDTH = 0.025;
/** Strips reach this many bandwidths inwards of the outline: the far side of the noise. */
const REACH = 3;
/** A corner moves by at most this many bandwidths: further off, the lines do not belong together. */
const FARTHEST_CORNER = 4;
/** Lines that turn by less meet too far along to tell where: a curve, or one wall in two pieces. Sine of 8°. */
const LEAST_SINE = Math.sin((8 * Math.PI) / 180);
/** Edges shorter than this many bandwidths have no direction of their own. */
const SHORTEST_EDGE = 2;
/** Steps of this many standard deviations are noise. */
const NOISES = 2;
/** A merged edge is fitted again and may merge again. */
const MOST_ROUNDS = 4;

type Point = readonly [x: number, y: number];

/**
 * Restores the corners that simplification cut and takes off the outer noise the outline stands on. Ours; the paper names
 * lost corners as its weakness ([Stojanovic19] §5).
 *
 * To each edge a line is fitted by the points it stands for, and neighbouring lines meet in the new vertex. Where they
 * are nearly parallel, as on curves, the old vertex is projected onto both; an edge without points (a bridged gap) keeps its
 * ends but for what its neighbours' lines take off them. Edges too short to have a direction, between lines that meet
 * there, go; so do vertices on straight walls.
 *
 * @param rings simplified
 * @param hulls the rings they were simplified from: no point an edge stands for lies outside its stretch of hull
 * @returns rings as valid as those given: where a moved vertex would make edges cross it stays. O(points).
 */
export function restoreCorners(rings: readonly Ring[], hulls: readonly Ring[], { xy, spacing }: Slice): readonly Ring[] {
  if (xy.length === 0) return rings;
  const bandwidth = Math.max(LEAST_BANDWIDTH, BANDWIDTH_SPACINGS * spacing);
  const points = new StripPoints(buildPointGrid(xy, bandwidth));
  const drafts = rings.map((ring, r) => {
    const refining = new RingRefining(ring, hulls[r], points, bandwidth);
    return refining.draft();
  });
  return settleRings(rings, drafts);
}

class RingRefining {
  private readonly ring: Ring;
  private readonly hull: Ring;
  /** Number in the hull of each vertex. */
  private readonly places: readonly number[];
  private readonly points: StripPoints;
  private readonly bandwidth: number;
  private readonly fitted = new Map<number, WallLine | null>();
  private kept: number[];

  constructor(ring: Ring, hull: Ring, points: StripPoints, bandwidth: number) {
    this.ring = ring;
    this.hull = hull;
    this.points = points;
    this.bandwidth = bandwidth;
    this.places = placesOf(ring, hull);
    this.kept = Array.from({ length: ring.length / 2 }, (_, v) => v);
  }

  draft() {
    let lines = this.lines();
    let placed = this.place(lines);
    for (let round = 0; round < MOST_ROUNDS; round++) {
      const needless = this.needless(lines, placed);
      if (needless.size === 0) break;
      this.kept = this.kept.filter((_, k) => !needless.has(k));
      lines = this.lines();
      placed = this.place(lines);
    }
    return { kept: this.kept, moved: new Map(this.kept.map((vertex, k) => [vertex, placed[k]])) };
  }

  /** Line of each edge kept[k] → kept[k + 1]. */
  private lines(): (WallLine | null)[] {
    return this.kept.map((from, k) => {
      const to = this.kept[(k + 1) % this.kept.length];
      const key = from * this.ring.length + to;
      const known = this.fitted.get(key);
      if (known !== undefined) return known;
      const line = this.fit(from, to);
      this.fitted.set(key, line);
      return line;
    });
  }

  private fit(from: number, to: number): WallLine | null {
    const strip = this.stripAlong(from, to);
    if (strip === null) return null;
    this.points.gather(strip);
    return fitWallLine(this.points, strip, this.bandwidth);
  }

  /** Along the hull the edge stands for, which the ends alone, outermost of the noise, may lie askew to. Null when too short. */
  private stripAlong(from: number, to: number): Strip | null {
    const [ax, ay] = vertexOf(this.ring, from);
    const [bx, by] = vertexOf(this.ring, to);
    const length = Math.hypot(bx - ax, by - ay);
    if (length < SHORTEST_EDGE * this.bandwidth) return null;
    const chain = this.chainBetween(from, to);
    const [x, y, ux, uy] = directionOf(chain);
    if (ux * (bx - ax) + uy * (by - ay) < length / 2) return null;
    const start = (ax - x) * ux + (ay - y) * uy;
    const end = (bx - x) * ux + (by - y) * uy;
    // The neighbours' points end where their own noise does.
    const margin = Math.min(this.bandwidth, length / 4);
    let [low, high] = [0, 0];
    for (let k = 0; k < chain.length; k += 2) {
      const across = (chain[k + 1] - y) * ux - (chain[k] - x) * uy;
      low = Math.min(low, across);
      high = Math.max(high, across);
    }
    return { x, y, ux, uy, along: [start + margin, end - margin], across: [low, high + REACH * this.bandwidth] };
  }

  private chainBetween(from: number, to: number): Float64Array {
    const n = this.hull.length / 2;
    const steps = (this.places[to] - this.places[from] + n) % n;
    const chain = new Float64Array(2 * steps + 2);
    for (let k = 0; k <= steps; k++) {
      const v = (this.places[from] + k) % n;
      chain[2 * k] = this.hull[2 * v];
      chain[2 * k + 1] = this.hull[2 * v + 1];
    }
    return chain;
  }

  private place(lines: readonly (WallLine | null)[]): Point[] {
    return this.kept.map((vertex, k) => {
      const before = lines[(k + lines.length - 1) % lines.length];
      const old = vertexOf(this.ring, vertex);
      return placeVertex(old, before, lines[k], FARTHEST_CORNER * this.bandwidth);
    });
  }

  /** Numbers in `kept` of the vertices that can go. */
  private needless(lines: readonly (WallLine | null)[], placed: readonly Point[]): Set<number> {
    const found = new Set<number>();
    const n = this.kept.length;
    for (let k = 0; k < n && n - found.size > 3; k++) {
      const before = (k + n - 1) % n;
      const after = (k + 1) % n;
      // One at a time, so that small steps do not add up.
      if (found.has(before) || found.has(after)) continue;
      if (this.isFlat(lines, placed, before, k, after) || this.isCutCorner(lines, before, k)) found.add(k);
    }
    return found;
  }

  /** Whether vertex k lies on one straight wall: nearer to it than the noise. */
  private isFlat(lines: readonly (WallLine | null)[], placed: readonly Point[], before: number, k: number, after: number): boolean {
    const [one, other] = [lines[before], lines[k]];
    if (one === null || other === null) return false;
    const noise = Math.max(one.deviation, other.deviation);
    const squared = squaredDistanceToSegment(...placed[k], ...placed[before], ...placed[after]);
    return one.ux * other.ux + one.uy * other.uy > 0 && squared <= (NOISES * noise) ** 2;
  }

  /** Whether the edge to vertex k is too short for a line and stands where the lines beside it meet, or are one. */
  private isCutCorner(lines: readonly (WallLine | null)[], edge: number, k: number): boolean {
    const n = lines.length;
    const [one, other] = [lines[(edge + n - 1) % n], lines[k]];
    if (one === null || other === null) return false;
    const a = vertexOf(this.ring, this.kept[edge]);
    const b = vertexOf(this.ring, this.kept[k]);
    if (Math.hypot(a[0] - b[0], a[1] - b[1]) > FARTHEST_CORNER * this.bandwidth) return false;
    const corner = meetingOf(one, other);
    const noise = NOISES * Math.max(one.deviation, other.deviation);
    if (corner === null) {
      if (one.ux * other.ux + one.uy * other.uy < 0) return false;
      return Math.abs(distanceTo(one, b)) <= noise && Math.abs(distanceTo(other, a)) <= noise;
    }
    if (lines[edge] !== null && squaredDistanceToSegment(...corner, ...a, ...b) > noise ** 2) return false;
    const reach = FARTHEST_CORNER * this.bandwidth;
    return Math.hypot(corner[0] - a[0], corner[1] - a[1]) <= reach && Math.hypot(corner[0] - b[0], corner[1] - b[1]) <= reach;
  }
}

function placeVertex(old: Point, before: WallLine | null, after: WallLine | null, reach: number): Point {
  if (before === null || after === null) {
    const only = before ?? after;
    return only === null ? old : projected(old, only);
  }
  const corner = meetingOf(before, after);
  if (corner !== null && Math.hypot(corner[0] - old[0], corner[1] - old[1]) <= reach) return corner;
  const [p, q] = [projected(old, before), projected(old, after)];
  return [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
}

/** Where two lines meet; null when they are nearly parallel. */
function meetingOf(a: WallLine, b: WallLine): Point | null {
  const sine = a.ux * b.uy - a.uy * b.ux;
  if (Math.abs(sine) < LEAST_SINE) return null;
  const along = ((b.x - a.x) * b.uy - (b.y - a.y) * b.ux) / sine;
  return [a.x + along * a.ux, a.y + along * a.uy];
}

function projected(point: Point, line: WallLine): Point {
  const across = distanceTo(line, point);
  return [point[0] + across * line.uy, point[1] - across * line.ux];
}

/** Positive to the left. */
function distanceTo({ x, y, ux, uy }: WallLine, point: Point): number {
  return (point[1] - y) * ux - (point[0] - x) * uy;
}

function vertexOf(ring: Ring, vertex: number): Point {
  return [ring[2 * vertex], ring[2 * vertex + 1]];
}

function placesOf(ring: Ring, hull: Ring): number[] {
  const n = hull.length / 2;
  let at = 0;
  return Array.from({ length: ring.length / 2 }, (_, v) => {
    while (hull[2 * at] !== ring[2 * v] || hull[2 * at + 1] !== ring[2 * v + 1]) at = (at + 1) % n;
    return at;
  });
}

/** Middle and direction of a chain, by total least squares over its length. */
function directionOf(chain: Float64Array): readonly [x: number, y: number, ux: number, uy: number] {
  const [x0, y0] = chain;
  let [sum, sumX, sumY, sumXX, sumXY, sumYY] = [0, 0, 0, 0, 0, 0];
  for (let k = 0; k + 3 < chain.length; k += 2) {
    const [dx, dy] = [chain[k + 2] - chain[k], chain[k + 3] - chain[k + 1]];
    const weight = Math.hypot(dx, dy);
    const [x, y] = [chain[k] + dx / 2 - x0, chain[k + 1] + dy / 2 - y0];
    sum += weight;
    sumX += weight * x;
    sumY += weight * y;
    sumXX += weight * (x * x + (dx * dx) / 12);
    sumXY += weight * (x * y + (dx * dy) / 12);
    sumYY += weight * (y * y + (dy * dy) / 12);
  }
  const [x, y] = [sumX / sum, sumY / sum];
  const angle = Math.atan2(2 * (sumXY / sum - x * y), sumXX / sum - x * x - (sumYY / sum - y * y)) / 2;
  const [ux, uy] = [Math.cos(angle), Math.sin(angle)];
  const end = chain.length - 2;
  const sign = ux * (chain[end] - x0) + uy * (chain[end + 1] - y0) < 0 ? -1 : 1;
  return [x0 + x, y0 + y, sign * ux, sign * uy];
}
