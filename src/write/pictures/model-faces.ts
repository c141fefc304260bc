import { orientation } from '../../core/geometry/predicates.ts';
import type { SolidGroup } from '../../core/types.ts';
import type { SeenSegment } from './paint-order.ts';
import type { GroupRings, SolidSlab } from './solid-slabs.ts';

/** Faces of a curve that meet flatter than 20° get no line between them. */
const FLAT = Math.cos(Math.PI / 9);
/** Edges nearer than this to a line lie on it, m. */
const ON_LINE = 1e-6;

/** Unit vectors in the plan: towards the viewer and to the viewer's right. */
export interface Sight {
  readonly towards: readonly [x: number, y: number];
  readonly right: readonly [x: number, y: number];
}

/** An upright face of one slab that looks at the viewer, from left to right as seen. */
export interface SideFace extends SeenSegment {
  readonly kind: SolidGroup['kind'];
  /** x, y of either end, m. */
  readonly ends: Float64Array;
  /** Whether the face ends, for the eye, at its left and right end. */
  readonly hasLine: readonly [left: boolean, right: boolean];
  /** Parts of the lower edge with nothing beneath them: x, y, x, y each. */
  readonly feet: readonly Float64Array[];
}

/**
 * The faces of a slab that look at the viewer, cut where two solids run into each other, so that no two cross.
 *
 * @param below the slab beneath, whose walls carry on into this one
 */
export function facesOf({ sections }: SolidSlab, below: SolidSlab | undefined, sight: Sight): SideFace[] {
  const groups = sections.map((section) => {
    const under = below?.sections.find(({ group }) => group === section.group);
    return section.rings.flatMap((ring) => ringFaces(section.group.kind, ring, under, sight));
  });
  if (groups.length === 1) return groups[0];
  return groups.flatMap((faces, g) => {
    const others = groups.filter((_, other) => other !== g).flat();
    return faces.flatMap((face) => cutFace(face, others, sight));
  });
}

function ringFaces(
  kind: SolidGroup['kind'],
  ring: Float64Array,
  under: GroupRings | undefined,
  sight: Sight,
): SideFace[] {
  const n = ring.length;
  const faces: SideFace[] = [];
  for (let i = 0; i < n; i += 2) {
    const ends = Float64Array.of(ring[i], ring[i + 1], ring[(i + 2) % n], ring[(i + 3) % n]);
    const seen = seenFrom(ends, sight);
    // The solid lies to the left, so faces that run to the right are those that look at the viewer.
    if (!(seen.u1 > seen.u0)) continue;
    const hasLine = [isEdge(ring, i, sight, -1), isEdge(ring, i, sight, 1)] as const;
    const feet = under === undefined ? [ends] : uncovered(ends, under.rings);
    faces.push({ kind, ends, ...seen, hasLine, feet });
  }
  return faces;
}

function seenFrom(ends: Float64Array, { towards, right }: Sight): SeenSegment {
  const along = ([x, y]: readonly [number, number], at: number): number => x * ends[at] + y * ends[at + 1];
  return { u0: along(right, 0), v0: along(towards, 0), u1: along(right, 2), v1: along(towards, 2) };
}

/** The parts of a face between the faces that cross it. */
function cutFace(face: SideFace, others: readonly SideFace[], sight: Sight): SideFace[] {
  const cuts = others
    .filter((other) => other.u0 < face.u1 && other.u1 > face.u0 && doCross(face.ends, other.ends))
    .map((other) => crossingShare(face.ends, other.ends))
    .sort((a, b) => a - b);
  if (cuts.length === 0) return [face];
  const [ax, ay, bx, by] = face.ends;
  const stops = [0, ...cuts, 1];
  return stops.slice(1).flatMap((to, i) => {
    const at = (share: number) => [ax + share * (bx - ax), ay + share * (by - ay)] as const;
    const ends = Float64Array.of(...at(stops[i]), ...at(to));
    const seen = seenFrom(ends, sight);
    if (!(seen.u1 > seen.u0)) return [];
    const hasLine = [i === 0 && face.hasLine[0], to === 1 && face.hasLine[1]] as const;
    return [{ kind: face.kind, ends, ...seen, hasLine, feet: face.feet.length === 0 ? [] : [ends] }];
  });
}

function doCross([ax, ay, bx, by]: Float64Array, [cx, cy, dx, dy]: Float64Array): boolean {
  return (
    orientation(ax, ay, bx, by, cx, cy) * orientation(ax, ay, bx, by, dx, dy) < 0 &&
    orientation(cx, cy, dx, dy, ax, ay) * orientation(cx, cy, dx, dy, bx, by) < 0
  );
}

/** Where on the first segment, 0 to 1, the second one crosses it. */
function crossingShare([ax, ay, bx, by]: Float64Array, [cx, cy, dx, dy]: Float64Array): number {
  const from = (dx - cx) * (ay - cy) - (dy - cy) * (ax - cx);
  const to = (dx - cx) * (by - cy) - (dy - cy) * (bx - cx);
  return from / (from - to);
}

/** Whether the face from vertex `i` meets the one beside it at an angle, or that one looks away. */
function isEdge(ring: Float64Array, i: number, { right }: Sight, step: 1 | -1): boolean {
  const n = ring.length;
  const direction = (at: number): readonly [number, number] => {
    const [from, to] = [(at + n) % n, (at + 2 + n) % n];
    const [dx, dy] = [ring[to] - ring[from], ring[to + 1] - ring[from + 1]];
    const length = Math.hypot(dx, dy);
    return [dx / length, dy / length];
  };
  const [own, other] = [direction(i), direction(i + 2 * step)];
  const looksAway = right[0] * other[0] + right[1] * other[1] <= 0;
  return looksAway || own[0] * other[0] + own[1] * other[1] < FLAT;
}

/** What of an edge lies over no edge of the same direction: the lower side of a lintel, not the wall beside it. */
function uncovered(ends: Float64Array, rings: readonly Float64Array[]): Float64Array[] {
  const [ax, ay, bx, by] = ends;
  const length = Math.hypot(bx - ax, by - ay);
  const [dx, dy] = [(bx - ax) / length, (by - ay) / length];
  const spans: [from: number, to: number][] = [];
  for (const ring of rings) {
    for (let i = 0; i < ring.length; i += 2) {
      const j = (i + 2) % ring.length;
      const [px, py, qx, qy] = [ring[i] - ax, ring[i + 1] - ay, ring[j] - ax, ring[j + 1] - ay];
      const isOnLine = Math.abs(dx * py - dy * px) < ON_LINE && Math.abs(dx * qy - dy * qx) < ON_LINE;
      const [from, to] = [dx * px + dy * py, dx * qx + dy * qy];
      if (isOnLine && to > from) spans.push([from, to]);
    }
  }
  const free: Float64Array[] = [];
  let at = 0;
  for (const [from, to] of [...spans.sort((a, b) => a[0] - b[0]), [length, length]]) {
    const end = Math.min(from, length);
    if (end > at + ON_LINE) {
      free.push(Float64Array.of(ax + at * dx, ay + at * dy, ax + end * dx, ay + end * dy));
    }
    at = Math.max(at, to);
  }
  return free;
}
