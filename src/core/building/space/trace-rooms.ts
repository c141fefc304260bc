import { areaOf, combine } from '../../geometry/areas.ts';
import type { Circle } from '../../geometry/circle.ts';
import { placedOnArcs } from '../../geometry/ring-arcs.ts';
import { perimeter, polygonArea, signedArea } from '../../geometry/rings.ts';
import type { Polygon, Ring } from '../../types.ts';
import { rootOf, separateSets, unite } from '../../union-find.ts';
import { isValid, validParts } from '../walls/valid-parts.ts';
import type { Arrangement } from './arrangement.ts';
import { cleanRing } from './clean-ring.ts';

/** Smallest room, m²: a lavatory or a store. */
const SMALLEST_ROOM = 0.8;
/** A room is wider than this over most of its length, m; what is narrower is a wall or a cavity. */
const NARROWEST_ROOM = 0.6;
/** Parts of a room that a wall stands between to this share are two rooms. */
export const PARTING = 0.5;
/** Rooms that share less than this do so by rounding, m². */
const LEAST_OVERLAP = 1e-4;

/** A room in the arrangement. */
export interface RoomFaces {
  readonly outline: Polygon;
  /** Faces it is made of. */
  readonly faces: readonly number[];
  readonly areaM2: number;
}

/**
 * Joins room faces that no wall parts, and draws a ring around each group.
 *
 * @param curves circles that curved walls follow
 */
export function traceRooms(
  arrangement: Arrangement,
  isRoom: Uint8Array,
  support: Float64Array,
  curves: readonly Circle[],
): RoomFaces[] {
  const group = groupFaces(arrangement, isRoom, support);
  const members = new Map<number, number[]>();
  group.forEach((g, f) => {
    if (g < 0) return;
    const list = members.get(g);
    if (list) list.push(f);
    else members.set(g, [f]);
  });
  const rooms = [...members].flatMap(([g, faces]) => {
    const rings = outlineOf(arrangement, group, g, faces).map((ring) => placedOnArcs(ring, curves));
    const outer = rings
      .filter((ring) => signedArea(ring) > 0)
      .sort((a, b) => signedArea(b) - signedArea(a))[0];
    if (!outer || !isRoomSized({ outer })) return [];
    return [{ faces, outline: { outer, holes: rings.filter((ring) => signedArea(ring) < 0) } }];
  });
  const outlines = keptApart(rooms.map(({ outline }) => outline));
  return rooms.flatMap(({ faces }, i) => {
    const outline = outlines[i];
    return outline ? [{ outline, faces, areaM2: polygonArea(outline) }] : [];
  });
}

/** Whether an outline is as large and as wide as a room, at least. */
export function isRoomSized({ outer }: Pick<Polygon, 'outer'>): boolean {
  const area = signedArea(outer);
  return area >= SMALLEST_ROOM && (2 * area) / perimeter(outer) >= NARROWEST_ROOM / 1.1;
}

/**
 * Outlines that are valid and do not overlap: closing a seam may move a corner over what is around it. Each keeps the
 * largest part that those before it leave; null where none is left.
 */
function keptApart(outlines: readonly Polygon[]): (Polygon | null)[] {
  const kept: Polygon[] = [];
  return outlines.map((outline) => {
    const clashing = kept.filter(
      (other) => areaOf(combine('intersection', [other], [outline])) > LEAST_OVERLAP,
    );
    const isFine = clashing.length === 0 && isValid(outline);
    const parts = isFine ? [outline] : validParts(combine('difference', [outline], clashing));
    const largest = parts.sort((a, b) => polygonArea(b) - polygonArea(a))[0] ?? null;
    if (largest !== null) kept.push(largest);
    return largest;
  });
}

/** Number of the first face of the group each room face is in; −1 for what is no room. */
function groupFaces({ face }: Arrangement, isRoom: Uint8Array, support: Float64Array): Int32Array {
  const sets = separateSets(isRoom.length);
  for (let e = 0; e < support.length; e++) {
    const [f, g] = [face[2 * e], face[2 * e + 1]];
    if (f >= 0 && g >= 0 && isRoom[f] && isRoom[g] && support[e] < PARTING) unite(sets, f, g);
  }
  return Int32Array.from(isRoom, (room, f) => (room ? rootOf(sets, f) : -1));
}

/** Rings around the faces of a group, straight stretches in one piece. */
function outlineOf(arrangement: Arrangement, group: Int32Array, g: number, faces: readonly number[]): Ring[] {
  const { next, face, faceEdge, holes } = arrangement;
  const isOwn = (f: number) => f >= 0 && group[f] === g;
  const isSeen = new Set<number>();
  const rings: Ring[] = [];
  const starts = faces.flatMap((f) => [faceEdge[f], ...holes[f]]);
  for (const start of starts) {
    let h = start;
    do {
      if (!isSeen.has(h) && !isOwn(face[h ^ 1])) rings.push(walk(arrangement, h, isOwn, isSeen));
      h = next[h];
    } while (h !== start);
  }
  return rings;
}

function walk(
  { x, y, origin, next, face }: Arrangement,
  start: number,
  isOwn: (f: number) => boolean,
  isSeen: Set<number>,
): Ring {
  const ring: number[] = [];
  let h = start;
  do {
    isSeen.add(h);
    ring.push(x[origin[h]], y[origin[h]]);
    h = next[h];
    while (isOwn(face[h ^ 1])) h = next[h ^ 1];
  } while (h !== start);
  return cleanRing(withoutStraights(Float64Array.from(ring)));
}

/** Leaves out vertices in the middle of a straight stretch. */
function withoutStraights(ring: Ring): Ring {
  const kept: number[] = [];
  const n = ring.length / 2;
  for (let i = 0; i < n; i++) {
    const [p, q] = [(i + n - 1) % n, (i + 1) % n];
    const [ax, ay] = [ring[2 * i] - ring[2 * p], ring[2 * i + 1] - ring[2 * p + 1]];
    const [bx, by] = [ring[2 * q] - ring[2 * i], ring[2 * q + 1] - ring[2 * i + 1]];
    const cross = ax * by - ay * bx;
    if (Math.abs(cross) > 1e-6 * Math.hypot(ax, ay) * Math.hypot(bx, by) || ax * bx + ay * by < 0) {
      kept.push(ring[2 * i], ring[2 * i + 1]);
    }
  }
  return Float64Array.from(kept);
}
