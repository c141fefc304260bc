import { areaOf, combine } from '../../geometry/areas.ts';
import type { Circle } from '../../geometry/circle.ts';
import { crossingWithCircle, withArcs } from '../../geometry/ring-arcs.ts';
import { inBounds, near, orientRing, ringsOf } from '../../geometry/rings.ts';
import { lineIntersection } from '../../geometry/segments.ts';
import { isSimpleRing } from '../../geometry/simplicity.ts';
import type { Polygon, Ring } from '../../types.ts';
import { validParts } from './valid-parts.ts';
import { sidesOf, type WallSide } from './wall-sides.ts';

/** Corners reach no farther out than so many thicknesses: sharper ones are cut off. */
const MITRE_LIMIT = 3;
/** Places on an outer face nearer to each other are one, m. */
const SHORTEST_CHORD = 0.001;
/** Walls that share less than this do so by rounding, m². */
const LEAST_OVERLAP = 1e-5;
/** Pieces of walls smaller than this are debris, m². */
const DEBRIS = 1e-3;

/** An outer wall along one side of the outline. */
export interface OuterWall {
  /** Number of the side. */
  readonly side: number;
  readonly outline: Polygon;
  readonly thickness: number;
}

/**
 * Walls along outlines, outside of them, a wall a side; they meet in mitres. Where one would stand in a room or in another
 * wall, at alcoves narrower than walls are thick, the longer has the place.
 *
 * @param thicknesses of the outlines' sides, m
 * @returns by sides; a wall that is cut may come in pieces, or not at all. O(sides²) comparisons of bounds.
 */
export function outerWalls(outlines: readonly Polygon[], thicknesses: readonly number[]): OuterWall[] {
  const sides = sidesOf(outlines);
  let first = 0;
  const walls = ringsOf(outlines).flatMap((ring) => {
    const own = sides.flatMap((side, number): OutlineSide[] => {
      const isOwn = side.edges[0] >= first && side.edges[0] < first + ring.length / 2;
      return isOwn ? [outlineSide(ring, side, first, { number, thickness: thicknesses[number] })] : [];
    });
    first += ring.length / 2;
    return wallsAround(own);
  });
  return keptApart(walls, outlines);
}

function keptApart(walls: readonly PlannedWall[], outlines: readonly Polygon[]): OuterWall[] {
  const taken = outlines.map(inBounds);
  const longestFirst = [...walls].sort((a, b) => b.length - a.length || a.side - b.side);
  const kept = longestFirst.flatMap(({ side, ring, thickness, circles }) => {
    const wall: Polygon = { outer: orientRing(ring, 'counter-clockwise'), holes: [] };
    const others = near(taken, wall);
    const isClear = isSimpleRing(ring) && areaOf(combine('intersection', [wall], others)) < LEAST_OVERLAP;
    const parts = isClear ? [wall] : validParts(combine('difference', [wall], others));
    const standing = parts.filter((part) => areaOf([part]) >= DEBRIS);
    taken.push(...standing.map(inBounds));
    return standing.map((outline): OuterWall => ({ side, outline: withArcs(outline, circles), thickness }));
  });
  return kept.sort((a, b) => a.side - b.side);
}

/** The wall of a side before it is known what stands there already. */
interface PlannedWall {
  readonly side: number;
  readonly ring: Ring;
  readonly thickness: number;
  /** Length of the side, m. */
  readonly length: number;
  /** Those of its faces, where it is curved. */
  readonly circles: readonly Circle[];
}

type Point = readonly [x: number, y: number];

/** A side of an outline and the outer face of its wall. */
interface OutlineSide {
  readonly number: number;
  readonly thickness: number;
  /** Vertices of the outline along it. */
  readonly inner: readonly Point[];
  /** The same moved out by the thickness. */
  readonly outer: readonly Point[];
  /** The outer face of a curved wall, after the inner. */
  readonly circles: readonly Circle[];
}

function outlineSide(
  ring: Ring,
  { edges, arc }: WallSide,
  first: number,
  { number, thickness }: { readonly number: number; readonly thickness: number },
): OutlineSide {
  const n = ring.length / 2;
  const inner = [...edges, edges[edges.length - 1] + 1].map((edge, k): Point => {
    const i = k < edges.length ? edge - first : (edges[k - 1] - first + 1) % n;
    return [ring[2 * i], ring[2 * i + 1]];
  });
  const [[ax, ay], [bx, by]] = [inner[0], inner[1]];
  const length = Math.hypot(bx - ax, by - ay);
  const [nx, ny] = [(by - ay) / length, (ax - bx) / length];
  if (!arc) {
    const outer = inner.map(([x, y]): Point => [x + nx * thickness, y + ny * thickness]);
    return { number, thickness, inner, outer, circles: [] };
  }
  const { centre, radius } = arc;
  const [cx, cy] = centre;
  const reach = radius + Math.sign((ax - cx) * nx + (ay - cy) * ny) * thickness;
  const outer = inner.map(([x, y]): Point => {
    const share = reach / Math.hypot(x - cx, y - cy);
    return [cx + (x - cx) * share, cy + (y - cy) * share];
  });
  return {
    ...{ number, thickness, inner, outer },
    circles: [
      { cx, cy, radius },
      { cx, cy, radius: reach },
    ],
  };
}

/** Mitres that cross each other, at a side between steps shorter than walls are thick, are left out: it ends at right angles. */
function wallsAround(sides: readonly OutlineSide[]): PlannedWall[] {
  const n = sides.length;
  return sides.map((side, i): PlannedWall => {
    const { number, thickness, inner, outer, circles } = side;
    const start = cornerOf(sides[(i + n - 1) % n], side, thickness);
    const end = cornerOf(side, sides[(i + 1) % n], thickness);
    const out = [start.ofSecond, ...between(side, start.ofSecond, end.ofFirst), end.ofFirst].reverse();
    const mitred = Float64Array.from([...inner, ...out].flat());
    const ring = isSimpleRing(mitred) ? mitred : Float64Array.from([...inner, ...outer.toReversed()].flat());
    return { side: number, ring, thickness, length: lengthOf(inner), circles };
  });
}

/** Vertices of a curved outer face that lie between its corners: in a mitre it goes on past its ends, or ends before. */
function between({ outer, circles }: OutlineSide, start: Point, end: Point): Point[] {
  const [circle] = circles;
  if (circle === undefined) return [];
  const { cx, cy } = circle;
  const [mx, my] = outer[outer.length >> 1];
  const turn = ([x, y]: Point) =>
    Math.atan2((mx - cx) * (y - cy) - (my - cy) * (x - cx), (mx - cx) * (x - cx) + (my - cy) * (y - cy));
  const way = Math.sign(turn(outer[outer.length - 1]) - turn(outer[0]));
  const apart = SHORTEST_CHORD / circles[1].radius;
  const [from, to] = [way * turn(start) + apart, way * turn(end) - apart];
  return outer.filter((place) => way * turn(place) > from && way * turn(place) < to);
}

function lengthOf(places: readonly Point[]): number {
  let length = 0;
  for (let i = 1; i < places.length; i++)
    length += Math.hypot(places[i][0] - places[i - 1][0], places[i][1] - places[i - 1][1]);
  return length;
}

/** Where the outer faces of two sides meet at a vertex; apart where they would meet far out or run alike. */
function cornerOf(before: OutlineSide, after: OutlineSide, thickness: number) {
  const [x, y] = after.inner[0];
  const mitre = meetingOf(before, after);
  const isNear = mitre !== null && Math.hypot(mitre[0] - x, mitre[1] - y) <= MITRE_LIMIT * thickness;
  const [ofFirst, ofSecond] = [before.outer[before.outer.length - 1], after.outer[0]];
  return isNear ? { ofFirst: mitre, ofSecond: mitre } : { ofFirst, ofSecond };
}

function meetingOf(before: OutlineSide, after: OutlineSide): Point | null {
  const [first, second] = [before.outer, after.outer];
  const [a, b] = [first[first.length - 2], first[first.length - 1]];
  const [c, d] = [second[0], second[1]];
  const [ofFirst, ofSecond] = [before.circles[1], after.circles[1]];
  if (ofFirst && ofSecond) return null;
  if (ofFirst) return crossingWithCircle(c, d, ofFirst);
  if (ofSecond) return crossingWithCircle(b, a, ofSecond);
  return lineIntersection(...a, ...b, ...c, ...d);
}
