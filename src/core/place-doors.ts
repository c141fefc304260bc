import type { StageContext } from './context.ts';
import { DOOR_HEIGHT, parseDoors } from './doors.ts';
import { directionAt, type Foot, nearestFoot, straightReach } from './geometry/ring-foot.ts';
import type { Options } from './params.ts';
import { penReach } from './plan-walls.ts';
import { planPlace } from './source-coordinates.ts';
import type { Frame, Gap, Opening, Polygon, Ring, Storey, Warning } from './types.ts';

/** Bridged gaps this wide may be doors: from a narrow leaf to a double door, m. */
const DOOR_GAP = [0.6, 3] as const;
/** A place read off a drawing or clicked misses its wall by less, m. */
const OFF_WALL = 0.5;
/** Within a door a wall may bulge by this much, m: a curved wall takes a door, a corner does not. */
const BULGE = 0.1;
/** A door narrower than this is none, m. */
const LEAST_WIDTH = 0.1;
/** A door clipped by less is not worth a word, m. */
const UNSAID = 0.01;

/** What doors are cut into. */
export interface DoorSite {
  /** The outlines that walls stand along, and how sure the walls are. */
  readonly outlines: readonly { readonly polygon: Polygon; readonly confidence: number }[];
  readonly gaps: readonly Gap[];
  readonly frame: Frame;
  /** Of the walls, m. */
  readonly height: number;
  readonly options: Options;
}

/** The outlines that a storey's walls stand along: those of its rooms, without rooms its own. */
export function doorOutlines({ rooms, primary }: Pick<Storey, 'rooms' | 'primary'>): DoorSite['outlines'] {
  return rooms.length > 0
    ? rooms.map(({ outline, confidence }) => ({ polygon: outline, confidence }))
    : primary.map((polygon) => ({ polygon, confidence: 1 }));
}

interface Wish {
  readonly name: string;
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly head: number;
  /** Given by a person, not taken from a gap. */
  readonly isGiven: boolean;
}

interface NearWall {
  readonly foot: Foot;
  /** The outline the wall stands along. */
  readonly ring: Ring;
  readonly confidence: number;
}

/**
 * Puts the doors of the parameter `doors` into the walls: each at the foot of its place on the nearest wall, along the
 * wall's direction there ([Stojanovic19] §3 cuts doors by hand; bridged gaps as doors are ours).
 *
 * A door is clipped where its wall ends and as high as the wall at most; one that finds no wall is left out. Warnings:
 * `plan/door-off-wall`, `plan/door-too-wide`. Doors × vertices.
 *
 * @throws option/invalid
 */
export function placeDoors(site: DoorSite, context: Pick<StageContext, 'warn' | 'placeInSource'>): Opening[] {
  return wishesOf(site, context).flatMap((wish) => placeDoor(wish, site, context) ?? []);
}

function wishesOf(
  { gaps, frame, options }: DoorSite,
  { placeInSource }: Pick<StageContext, 'placeInSource'>,
): Wish[] {
  const doors = parseDoors(options.doors);
  const place = (x: number, y: number) => placeInSource?.(x, y) ?? `(${x.toFixed(2)}, ${y.toFixed(2)}) m`;
  const given = doors.cuts.map(({ x: sourceX, y: sourceY, width, height }): Wish => {
    const [x, y] = planPlace(frame, sourceX, sourceY);
    return { name: `door at ${place(x, y)}`, x, y, width, head: height ?? DOOR_HEIGHT, isGiven: true };
  });
  const found = (doors.gaps ? gaps : []).flatMap(({ from, to, width }): Wish[] => {
    if (width < DOOR_GAP[0] || width > DOOR_GAP[1]) return [];
    const [x, y] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    return [{ name: `gap at ${place(x, y)}`, x, y, width, head: DOOR_HEIGHT, isGiven: false }];
  });
  return [...found, ...given];
}

function placeDoor(wish: Wish, site: DoorSite, { warn }: Pick<StageContext, 'warn'>): Opening | null {
  const { outside, inside } = penReach(site.options);
  const aside = (outside - inside) / 2;
  const wall = nearestWall(wish, site, aside);
  const away = wall === null ? Infinity : wall.foot.distance - site.options.wallThickness / 2;
  if (wall === null || away > OFF_WALL) {
    warn(offWall(wish, away));
    return null;
  }
  const { foot, ring, confidence } = wall;
  const half = wish.width / 2;
  // Outer rings run counter-clockwise, holes clockwise: the room is at their left.
  const stands = { left: inside, right: outside };
  const direction = directionAt(ring, foot, { along: half, kink: BULGE });
  const [before, after] = ([-1, 1] as const).map((way) =>
    straightReach(ring, foot, { direction, way, limit: half, bulge: BULGE, stands }),
  );
  if (before + after < wish.width - UNSAID) warn(tooWide(wish, before + after));
  if (before + after < LEAST_WIDTH) return null;
  const [ux, uy] = direction;
  const jamb = (along: number) =>
    [foot.x + along * ux + aside * uy, foot.y + along * uy - aside * ux] as const;
  return {
    type: 'door',
    from: jamb(-before),
    to: jamb(after),
    sill: 0,
    head: Math.min(wish.head, site.height),
    confidence: wish.isGiven ? 1 : confidence,
  };
}

function nearestWall({ x, y }: Wish, { outlines }: DoorSite, aside: number): NearWall | null {
  let nearest: NearWall | null = null;
  for (const { polygon, confidence } of outlines) {
    for (const ring of [polygon.outer, ...polygon.holes]) {
      const foot = nearestFoot(ring, x, y, aside);
      if (nearest === null || foot.distance < nearest.foot.distance) nearest = { foot, ring, confidence };
    }
  }
  return nearest;
}

function offWall({ name }: Wish, away: number): Warning {
  const found = away === Infinity ? 'there is none' : `the nearest is ${away.toFixed(2)} m away`;
  return {
    code: 'plan/door-off-wall',
    message: `The ${name} was not cut: it needs a wall within ${OFF_WALL} m, ${found}.`,
    hint: 'Give a place on the wall in source coordinates.',
  };
}

function tooWide({ name, width, isGiven }: Wish, fits: number): Warning {
  const outcome = fits < LEAST_WIDTH ? 'it was not cut' : `it was cut ${fits.toFixed(2)} m wide`;
  return {
    code: 'plan/door-too-wide',
    message: `The ${name} is ${width.toFixed(2)} m wide, the wall there ${fits.toFixed(2)} m: ${outcome}.`,
    hint: isGiven
      ? 'Move the door away from the corner or make it narrower.'
      : 'The gap runs into a corner; if the door is elsewhere, cut it by hand.',
  };
}
