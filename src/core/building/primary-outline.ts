import { ClipperOffset, EndType, JoinType, type Path64, type Paths64 } from 'clipper2-ts';
import { combine, STEPS_PER_METRE } from '../geometry/areas.ts';
import { orientRing, signedArea } from '../geometry/rings.ts';
import type { Polygon, Ring } from '../types.ts';

/** Corners are mitred up to this many offsets away: down to 30°. */
const MITRE_LIMIT = 4;
/** Gaps between rooms close where they are this much narrower than the pen, m. */
const SLACK = 0.01;
/** Holes smaller than this are shafts and thick walls, not courtyards, m². */
const SMALLEST_COURTYARD = 4;

/**
 * The outline of all rooms and the walls between them: the closing of the rooms by half the thickest inner wall.
 *
 * @param thickest of the walls between rooms, m
 */
export function primaryOutline(rooms: readonly Polygon[], thickest: number): Polygon[] {
  if (rooms.length === 0) return [];
  const reach = thickest / 2 + SLACK;
  const grown = offset(rooms, reach);
  const closed = offset(combine('union', grown), -reach);
  return combine('union', [...closed, ...rooms]).map(({ outer, holes }) => ({
    outer: withoutSpurs(outer),
    holes: holes.filter((hole) => -signedArea(hole) >= SMALLEST_COURTYARD),
  }));
}

function offset(polygons: readonly Polygon[], distance: number): Polygon[] {
  const origin = polygons[0].outer;
  const [x0, y0] = [Math.round(origin[0]), Math.round(origin[1])];
  const paths: Paths64 = polygons
    .flatMap(({ outer, holes }) => [outer, ...holes])
    .map((ring) => toPath(ring, x0, y0));
  const clipper = new ClipperOffset(MITRE_LIMIT);
  clipper.addPaths(paths, JoinType.Miter, EndType.Polygon);
  const grown: Paths64 = [];
  clipper.execute(distance * STEPS_PER_METRE, grown);
  const rings = grown.map((path) => toRing(path, x0, y0));
  const outers = rings.filter((ring) => signedArea(ring) > 0);
  const holes = rings.filter((ring) => signedArea(ring) < 0);
  return combine(
    'difference',
    outers.map((outer) => ({ outer, holes: [] })),
    holes.map((hole) => ({ outer: orientRing(hole, 'counter-clockwise'), holes: [] })),
  );
}

function toPath(ring: Ring, x0: number, y0: number): Path64 {
  const path: Path64 = [];
  for (let i = 0; i < ring.length; i += 2) {
    path.push({
      x: Math.round((ring[i] - x0) * STEPS_PER_METRE),
      y: Math.round((ring[i + 1] - y0) * STEPS_PER_METRE),
    });
  }
  return path;
}

function toRing(path: Path64, x0: number, y0: number): Ring {
  return Float64Array.from(path.flatMap(({ x, y }) => [x0 + x / STEPS_PER_METRE, y0 + y / STEPS_PER_METRE]));
}

/** Leaves out vertices that rounding and offsets put on straight stretches: nearer than a millimetre to their neighbours' line. */
function withoutSpurs(ring: Ring): Ring {
  let current = ring;
  for (;;) {
    const n = current.length / 2;
    const kept: number[] = [];
    let isDropped = false;
    for (let i = 0; i < n; i++) {
      const [p, q] = [(i + n - 1) % n, (i + 1) % n];
      const [ax, ay] = [current[2 * p], current[2 * p + 1]];
      const [ux, uy] = [current[2 * q] - ax, current[2 * q + 1] - ay];
      const length = Math.hypot(ux, uy);
      const aside = ((current[2 * i] - ax) * uy - (current[2 * i + 1] - ay) * ux) / length;
      if (!isDropped && n > 4 && (length < 0.001 || Math.abs(aside) < 0.001)) isDropped = true;
      else kept.push(current[2 * i], current[2 * i + 1]);
    }
    if (!isDropped) return current;
    current = Float64Array.from(kept);
  }
}
