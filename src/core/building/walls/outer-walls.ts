import { areaOf, combine } from '../../geometry/areas.ts';
import { type Bounds, boundsOf, ringsOf } from '../../geometry/rings.ts';
import { lineIntersection } from '../../geometry/segments.ts';
import { isSimpleRing } from '../../geometry/simplicity.ts';
import type { Polygon, Ring } from '../../types.ts';
import { validParts } from './valid-parts.ts';

/** Corners reach no farther out than so many thicknesses: sharper ones are cut off. */
const MITRE_LIMIT = 3;
/** Walls that share less than this do so by rounding, m². */
const LEAST_OVERLAP = 1e-5;
/** Pieces of walls smaller than this are debris, m². */
const DEBRIS = 1e-3;

/** An outer wall along one edge of the outline. */
export interface OuterWall {
  /** Number of the edge, counted through all rings. */
  readonly edge: number;
  readonly outline: Polygon;
  readonly thickness: number;
}

/**
 * Walls along outlines, outside of them, a wall an edge; they meet in mitres. Where one would stand in a room or in another
 * wall, at alcoves narrower than walls are thick, the longer has the place.
 *
 * @param thicknesses of the edges of all rings, m, in order: outer ring first, then the holes, polygon by polygon
 * @returns by edges; a wall that is cut may come in pieces, or not at all. O(edges²) comparisons of bounds.
 */
export function outerWalls(outlines: readonly Polygon[], thicknesses: readonly number[]): OuterWall[] {
  let first = 0;
  const walls = ringsOf(outlines).flatMap((ring) => {
    const own = thicknesses.slice(first, first + ring.length / 2);
    const begin = first;
    first += ring.length / 2;
    return wallsAround(ring, own).map((wall) => ({ ...wall, edge: begin + wall.edge }));
  });
  return keptApart(walls, outlines);
}

function keptApart(walls: readonly PlannedWall[], outlines: readonly Polygon[]): OuterWall[] {
  const taken = outlines.map(inBounds);
  const longestFirst = [...walls].sort((a, b) => b.length - a.length || a.edge - b.edge);
  const kept = longestFirst.flatMap(({ edge, ring, thickness }) => {
    const wall: Polygon = { outer: ring, holes: [] };
    const { bounds } = inBounds(wall);
    const near = taken.filter((other) => boundsMeet(other.bounds, bounds)).map(({ area }) => area);
    const isClear = isSimpleRing(ring) && areaOf(combine('intersection', [wall], near)) < LEAST_OVERLAP;
    const parts = isClear ? [wall] : validParts(combine('difference', [wall], near));
    const standing = parts.filter((part) => areaOf([part]) >= DEBRIS);
    taken.push(...standing.map(inBounds));
    return standing.map((outline): OuterWall => ({ edge, outline, thickness }));
  });
  return kept.sort((a, b) => a.edge - b.edge);
}

interface BoundedArea {
  readonly area: Polygon;
  readonly bounds: Bounds;
}

function inBounds(area: Polygon): BoundedArea {
  return { area, bounds: boundsOf(area.outer) };
}

function boundsMeet(a: Bounds, b: Bounds): boolean {
  return a.minX <= b.maxX && b.minX <= a.maxX && a.minY <= b.maxY && b.minY <= a.maxY;
}

/** The wall of an edge before it is known what stands there already. */
interface PlannedWall {
  readonly edge: number;
  readonly ring: Ring;
  readonly thickness: number;
  /** Length of the edge, m. */
  readonly length: number;
}

type Point = readonly [x: number, y: number];

function wallsAround(ring: Ring, thicknesses: readonly number[]): PlannedWall[] {
  const n = ring.length / 2;
  const at = (i: number): Point => [ring[2 * ((i + n) % n)], ring[2 * ((i + n) % n) + 1]];
  /** Edge i moved out by its thickness. */
  const moved = (i: number): readonly [Point, Point] => {
    const [[ax, ay], [bx, by]] = [at(i), at(i + 1)];
    const reach = thicknesses[(i + n) % n] / Math.hypot(bx - ax, by - ay);
    const [dx, dy] = [(by - ay) * reach, (ax - bx) * reach];
    return [
      [ax + dx, ay + dy],
      [bx + dx, by + dy],
    ];
  };
  return thicknesses.map((thickness, i): PlannedWall => {
    const start = cornerOf(at(i), moved(i - 1), moved(i), thickness);
    const end = cornerOf(at(i + 1), moved(i), moved(i + 1), thickness);
    const [[ax, ay], [bx, by]] = [at(i), at(i + 1)];
    const outline = Float64Array.from([at(i), start.ofSecond, end.ofFirst, at(i + 1)].flat());
    return { edge: i, ring: outline, thickness, length: Math.hypot(bx - ax, by - ay) };
  });
}

/** Where the outer faces of two edges meet at a vertex; apart where they would meet far out or run alike. */
function cornerOf(
  vertex: Point,
  before: readonly [Point, Point],
  after: readonly [Point, Point],
  thickness: number,
) {
  const mitre = lineIntersection(...before[0], ...before[1], ...after[0], ...after[1]);
  const isNear =
    mitre !== null && Math.hypot(mitre[0] - vertex[0], mitre[1] - vertex[1]) <= MITRE_LIMIT * thickness;
  return isNear ? { ofFirst: mitre, ofSecond: mitre } : { ofFirst: before[1], ofSecond: after[0] };
}
