import { areaOf, closed, withoutHairlines } from '../core/geometry/areas.ts';
import type { Circle } from '../core/geometry/circle.ts';
import { withArcs } from '../core/geometry/ring-arcs.ts';
import { orientRing, pointInRing, ringsOf } from '../core/geometry/rings.ts';
import { conflictingEdges } from '../core/geometry/simplicity.ts';
import type { Polygon, Ring } from '../core/types.ts';
import { separatePinches } from '../solid/pinches.ts';

/** What still meets when rounded is knocked out twice as wide each time; 3 mm in the last. */
const ROUNDS = 4;
/** Gaps that rounding may close are filled before, m. */
const HAIRLINE = 2e-4;

type Position = readonly [x: number, y: number];

/** The circles that a polygon may follow, and the unit, in a file's coordinates. */
export interface FileCurves {
  readonly circles: readonly Circle[];
  readonly metresPerUnit: number;
}

/** A polygon, or a piece of one, and what a file says of it. */
export interface RoundedPolygon {
  /** Metres, plan frame. */
  readonly piece: Polygon;
  /** In the file's coordinates: outer ring counter-clockwise, holes clockwise, all simple and apart from each other. */
  readonly rounded: Polygon;
}

/**
 * A polygon as a file can hold it: its vertices rounded, and valid as rounded. Every format that writes areas does it by
 * this.
 *
 * Vertices that rounding makes one are written once, holes left without area go, and rings turn as asked for after rounding,
 * which may turn a sliver over. A polygon that stays sound keeps all else; another loses its hairline gaps, or is cut where
 * its rings all but touch, and of its pieces those without a width that rounding leaves are left out. Where cutting helps
 * nothing, a slit that leads into it say, all its gaps of a hairline are filled.
 *
 * @param polygon metres; rings in any turn
 * @param place from plan metres to the file's rounded coordinates, keeping the turn of rings
 * @param curves what arcs may be told of
 */
export function roundedPolygons(
  polygon: Polygon,
  place: (x: number, y: number) => Position,
  curves: FileCurves = { circles: [], metresPerUnit: 1 },
): RoundedPolygon[] {
  const cut = soundPieces([polygon], place, curves);
  if (cut.lost.length === 0) return cut.done;
  const filled = soundPieces(closed([polygon], HAIRLINE), place, curves);
  return areaOf(filled.lost) < areaOf(cut.lost) ? filled.done : cut.done;
}

/** Pieces of polygons that are sound when rounded, and those that were not to be had. */
function soundPieces(
  polygons: readonly Polygon[],
  place: (x: number, y: number) => Position,
  { circles, metresPerUnit }: FileCurves,
): { readonly done: RoundedPolygon[]; readonly lost: readonly Polygon[] } {
  const done: RoundedPolygon[] = [];
  let waiting = polygons;
  for (let round = 0; round <= ROUNDS + 1 && waiting.length > 0; round++) {
    const unsound: Polygon[] = [];
    for (const piece of waiting) {
      const rounded = roundPolygon(piece, place);
      if (rounded !== null && isSound(rounded))
        done.push({ piece, rounded: withArcs(rounded, circles, metresPerUnit) });
      else if (rounded !== null) unsound.push(piece);
    }
    waiting = unsound.flatMap((piece) =>
      round === 0 ? withoutHairlines([piece], HAIRLINE) : separatePinches([piece], 2 ** (round - 1)),
    );
  }
  return { done, lost: waiting };
}

/** Null where rounding leaves no area. */
function roundPolygon({ outer, holes }: Polygon, place: (x: number, y: number) => Position): Polygon | null {
  const shell = roundRing(outer, place);
  if (shell === null) return null;
  const inner = holes.flatMap((hole) => roundRing(hole, place) ?? []);
  return {
    outer: orientRing(shell, 'counter-clockwise'),
    holes: inner.map((hole) => orientRing(hole, 'clockwise')),
  };
}

function roundRing(ring: Ring, place: (x: number, y: number) => Position): Ring | null {
  const xy: number[] = [];
  for (let i = 0; i < ring.length; i += 2) {
    const [x, y] = place(ring[i], ring[i + 1]);
    if (x !== xy.at(-2) || y !== xy.at(-1)) xy.push(x, y);
  }
  while (xy.length > 2 && xy[0] === xy.at(-2) && xy[1] === xy.at(-1)) xy.length -= 2;
  return xy.length < 6 ? null : Float64Array.from(xy);
}

/** Whether the rings are simple, share no point, and the holes lie in the outer ring and in no other hole. */
function isSound(polygon: Polygon): boolean {
  const rings = ringsOf([polygon]);
  if (conflictingEdges(rings).length > 0 || haveCommonVertex(rings)) return false;
  const isIn = (inner: Ring, outer: Ring) => pointInRing(inner[0], inner[1], outer) > 0;
  const { outer, holes } = polygon;
  return holes.every(
    (hole) => isIn(hole, outer) && holes.every((other) => other === hole || !isIn(hole, other)),
  );
}

function haveCommonVertex(rings: readonly Ring[]): boolean {
  const met = new Set<string>();
  let count = 0;
  for (const ring of rings) {
    count += ring.length / 2;
    for (let i = 0; i < ring.length; i += 2) met.add(`${ring[i]} ${ring[i + 1]}`);
  }
  return met.size < count;
}
