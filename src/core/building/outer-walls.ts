import { lineIntersection } from '../geometry/segments.ts';
import { isSimpleRing } from '../geometry/simplicity.ts';
import type { Polygon, Ring } from '../types.ts';

/** Corners reach no farther out than so many thicknesses: sharper ones are cut off. */
const MITRE_LIMIT = 3;

/** An outer wall along one edge of the outline. */
export interface OuterWall {
  /** Number of the edge, counted through all rings. */
  readonly edge: number;
  readonly outline: Polygon;
  readonly thickness: number;
}

/**
 * Walls along an outline, outside of it, a wall an edge; they meet in mitres, so that they neither overlap nor leave a gap.
 *
 * @param thicknesses of the edges of all rings, m, in order: outer ring first, then the holes
 */
export function outerWalls({ outer, holes }: Polygon, thicknesses: readonly number[]): OuterWall[] {
  let first = 0;
  return [outer, ...holes].flatMap((ring) => {
    const own = thicknesses.slice(first, first + ring.length / 2);
    const begin = first;
    first += ring.length / 2;
    return wallsAround(ring, own).map((wall) => ({ ...wall, edge: begin + wall.edge }));
  });
}

type Point = readonly [x: number, y: number];

function wallsAround(ring: Ring, thicknesses: readonly number[]): OuterWall[] {
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
  return thicknesses.flatMap((thickness, i): OuterWall[] => {
    const start = cornerOf(at(i), moved(i - 1), moved(i), thickness);
    const end = cornerOf(at(i + 1), moved(i), moved(i + 1), thickness);
    const outline = Float64Array.from([at(i), start.ofSecond, end.ofFirst, at(i + 1)].flat());
    return isSimpleRing(outline) ? [{ edge: i, outline: { outer: outline, holes: [] }, thickness }] : [];
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
