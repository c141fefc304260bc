import { type Bounds, boundsOfAll } from '../../core/geometry/rings.ts';
import { type Affine, type SheetItem, TEXT_SIZES } from '../../core/sheet.ts';
import type { Polygon, Ring, Storey } from '../../core/types.ts';
import { placeFigures, TICK } from './chain-figures.ts';
import { type DisplayUnit, formatDimension } from './measure-words.ts';
import type { Surround } from './sheet-page.ts';
import { CAPITAL } from './text-width.ts';

/** Distance of the first chain from the plan, between chains, and of text above its line, mm. */
export const FIRST_CHAIN = 9;
export const NEXT_CHAIN = 8;
export const TEXT_GAP = 1;
/** Extension lines are short, so that they cross no figures: so far to either side of their chain, mm. */
export const EXTENSION = 1.4;
/** … and figures below a chain so far past these, mm. */
const FIGURE_GAP = 0.3;
/** Blank beyond the outermost chain, mm. */
const CLEARANCE = 4;
/** A step in the outline gets a dimension when it is at least this deep, m, and its dimension this wide, mm. */
const STEP_DEPTH = 0.3;
const SHORTEST = 8;
/** An edge within 2° of the axis stands square to the chain. */
export const SQUARE = Math.sin(Math.PI / 90);
/** What is nearer to the outside than this lies in the outer wall or along it, m. */
const THICKEST_OUTER_WALL = 0.8;
/** Between chords of a curve a ring turns by less than this, at corners of walls by more, radians. */
const CORNER = Math.PI / 12;
/** Two places nearer than this are one: no tape tells them apart, m. */
const SAME_PLACE = 0.015;
/** Base line of a figure that stands below its line, mm from there. */
export const BELOW = EXTENSION + FIGURE_GAP + CAPITAL * TEXT_SIZES.label;
/** The outline is looked at this far left and right of a step, m. */
const BESIDE = 0.01;
/** More steps than this on a side are a jagged outline, not corners to be measured. */
const MOST_STEPS = 8;

/** A side of the plan as seen from outside: the axis that runs along it and the direction that leads away from it. */
interface Side {
  readonly name: 'left' | 'right' | 'top' | 'bottom';
  readonly along: 0 | 1;
  readonly away: 1 | -1;
}

const SIDES: readonly Side[] = [
  { name: 'bottom', along: 0, away: -1 },
  { name: 'top', along: 0, away: 1 },
  { name: 'left', along: 1, away: -1 },
  { name: 'right', along: 1, away: 1 },
];

/** What is measured on each side: places of ticks along the side, metres, innermost chain first. */
export interface Dimensions {
  readonly chains: Readonly<Record<Side['name'], readonly (readonly number[])[]>>;
  /** Space the chains take. */
  readonly surround: Surround;
}

/** Nothing measured; the plan still stands off the edge. */
export const NO_DIMENSIONS: Dimensions = {
  chains: { left: [], right: [], top: [], bottom: [] },
  surround: { left: CLEARANCE, right: CLEARANCE, top: CLEARANCE, bottom: CLEARANCE },
};

/** Rooms and openings behind the outline, turned as it is. */
export type Inside = Pick<Storey, 'rooms' | 'openings'>;

const NOTHING: Inside = { rooms: [], openings: [] };

/**
 * Chooses what to measure: on every side, from the plan outwards, the openings of the outer wall, the rooms and walls
 * behind it with the steps of the outline that are seen from there, and below and at the left the whole.
 *
 * @param footprint disjoint polygons, metres
 * @param scale 50 for 1:50
 */
export function planDimensions(
  footprint: readonly Polygon[],
  extent: Bounds,
  scale: number,
  inside: Inside = NOTHING,
): Dimensions {
  const chains = { left: [], right: [], top: [], bottom: [] } as Record<Side['name'], (readonly number[])[]>;
  const surround = { left: 0, right: 0, top: 0, bottom: 0 };
  const rings = footprint.map(({ outer }) => outer);
  for (const side of SIDES) {
    const [low, high] = side.along === 0 ? [extent.minX, extent.maxX] : [extent.minY, extent.maxY];
    const steps = visibleSteps(footprint, side, { low, high, apart: (SHORTEST * scale) / 1000 });
    const own = chains[side.name];
    for (const places of [jambsAlong(rings, side, inside), [...steps, ...roomsAlong(rings, side, inside)]]) {
      const chain = apartFrom([low, ...places, high]);
      if (chain.length > 2) own.push(chain);
    }
    if (side.away === -1) own.push([low, high]);
    surround[side.name] = CLEARANCE + (own.length > 0 ? FIRST_CHAIN + (own.length - 1) * NEXT_CHAIN : 0);
  }
  return { chains, surround };
}

/** Jambs of the openings that lead out on a side. */
function jambsAlong(rings: readonly Ring[], side: Side, { openings }: Inside): number[] {
  return openings.flatMap(({ from, to }) => {
    const [along, across] = [side.along, (1 - side.along) as 0 | 1];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (Math.abs(to[across] - from[across]) > SQUARE * length) return [];
    const middle = (from[along] + to[along]) / 2;
    const deep = reach(rings, side, middle) - side.away * ((from[across] + to[across]) / 2);
    return deep >= 0 && deep < THICKEST_OUTER_WALL ? [from[along], to[along]] : [];
  });
}

/** Ends of the edges of rooms that stand along the outer wall of a side. */
function roomsAlong(rings: readonly Ring[], side: Side, { rooms }: Inside): number[] {
  const [along, across] = [side.along, 1 - side.along];
  return rooms.flatMap(({ outline: { outer } }) => {
    const places: number[] = [];
    for (let i = 0; i < outer.length; i += 2) {
      const j = (i + 2) % outer.length;
      const length = Math.hypot(outer[j] - outer[i], outer[j + 1] - outer[i + 1]);
      if (length < STEP_DEPTH || Math.abs(outer[j + across] - outer[i + across]) > SQUARE * length) continue;
      if (isSmooth(outer, i) && isSmooth(outer, j)) continue;
      const deep =
        reach(rings, side, (outer[i + along] + outer[j + along]) / 2) - side.away * outer[i + across];
      if (deep >= 0 && deep < THICKEST_OUTER_WALL) places.push(outer[i + along], outer[j + along]);
    }
    return places;
  });
}

/** Whether a ring turns so little at a vertex that it stands for a curve. */
function isSmooth(ring: Ring, i: number): boolean {
  const [h, j] = [(i + ring.length - 2) % ring.length, (i + 2) % ring.length];
  const [ax, ay] = [ring[i] - ring[h], ring[i + 1] - ring[h + 1]];
  const [bx, by] = [ring[j] - ring[i], ring[j + 1] - ring[i + 1]];
  return Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by)) < CORNER;
}

/** Rising, each so far from the one before that it can be read. */
function apartFrom(places: readonly number[]): number[] {
  const [low, high] = [Math.min(...places), Math.max(...places)];
  const chain: number[] = [];
  for (const place of [...places].sort((a, b) => a - b)) {
    if (place - (chain.at(-1) ?? Number.NEGATIVE_INFINITY) >= SAME_PLACE) chain.push(place);
  }
  // The ends are the plan's own.
  chain[0] = low;
  if (chain.length > 1) chain[chain.length - 1] = high;
  return chain;
}

/** Draws the chains: thin lines, oblique ticks, figures read from below or the right. */
export function drawDimensions(
  { chains }: Dimensions,
  extent: Bounds,
  { planToSheet, unit }: { planToSheet: Affine; unit: DisplayUnit },
): SheetItem[] {
  return SIDES.flatMap((side) =>
    chains[side.name].flatMap((places, i) =>
      drawChain(side, places, { extent, planToSheet, unit, offset: FIRST_CHAIN + i * NEXT_CHAIN }),
    ),
  );
}

function drawChain(
  side: Side,
  places: readonly number[],
  {
    extent,
    planToSheet,
    unit,
    offset,
  }: { extent: Bounds; planToSheet: Affine; unit: DisplayUnit; offset: number },
): SheetItem[] {
  const edge = {
    left: extent.minX,
    right: extent.maxX,
    bottom: extent.minY,
    top: extent.maxY,
  }[side.name];
  /** Sheet point at a place along the side, so many mm away from the plan. */
  const at = (place: number, away: number): readonly [number, number] => {
    const [k, , , l, e, f] = planToSheet;
    return side.along === 0
      ? [k * place + e, l * edge + f - side.away * away]
      : [k * edge + e + side.away * away, l * place + f];
  };
  const lines: Float64Array[] = [Float64Array.of(...at(places[0], offset), ...at(places.at(-1)!, offset))];
  const ticks: Float64Array[] = [];
  for (const place of places) {
    lines.push(Float64Array.of(...at(place, offset - EXTENSION), ...at(place, offset + EXTENSION)));
    ticks.push(tickAt(...at(place, offset)));
  }
  const items: SheetItem[] = [
    { kind: 'path', style: 'dimension', lines, isClosed: false },
    { kind: 'path', style: 'tick', lines: ticks, isClosed: false },
  ];
  const figures = places.slice(1).map((place, i) => formatDimension(place - places[i], unit));
  const isUpright = side.along === 1;
  const mmPerMetre = planToSheet[0];
  placeFigures(
    places.map((place) => place * mmPerMetre),
    figures,
  ).forEach((figure, i) => {
    if (figure === null) return;
    const [x, y] = at(figure.at / mmPerMetre, offset);
    const aside = figure.isBelow ? BELOW : -TEXT_GAP;
    const place = isUpright ? { x: x + aside, y, isUpright } : { x, y: y + aside };
    items.push({ kind: 'text', size: 'label', ...place, text: figures[i], anchor: 'middle' });
  });
  return items;
}

/** The oblique tick at a place on the sheet. */
export function tickAt(x: number, y: number): Float64Array {
  return Float64Array.of(x - TICK, y + TICK, x + TICK, y - TICK);
}

/** Places where the outline, seen from the side, steps forwards or back; none where it is jagged all over. */
function visibleSteps(
  footprint: readonly Polygon[],
  side: Side,
  { low, high, apart }: { low: number; high: number; apart: number },
): number[] {
  const rings = footprint.map(({ outer }) => outer);
  const steps: number[] = [];
  for (const place of squareEdges(rings, side).sort((a, b) => a - b)) {
    const before = reach(rings, side, place - BESIDE);
    const after = reach(rings, side, place + BESIDE);
    const isStep = Number.isFinite(before) && Number.isFinite(after) && Math.abs(before - after) > STEP_DEPTH;
    if (isStep && place - (steps.at(-1) ?? low) > apart && high - place > apart) steps.push(place);
  }
  return steps.length > MOST_STEPS ? [] : steps;
}

/** Places along the side of the edges that stand square to it and are deep enough. */
function squareEdges(rings: readonly Float64Array[], { along }: Side): number[] {
  const places: number[] = [];
  for (const ring of rings) {
    for (let i = 0; i < ring.length; i += 2) {
      const j = (i + 2) % ring.length;
      const run = ring[j + along] - ring[i + along];
      const length = Math.hypot(ring[j] - ring[i], ring[j + 1] - ring[i + 1]);
      if (length > STEP_DEPTH && Math.abs(run) < SQUARE * length) places.push(ring[i + along] + run / 2);
    }
  }
  return places;
}

/** How far the outline comes towards the side at a place; infinite beside the plan. */
function reach(rings: readonly Float64Array[], { along, away }: Side, place: number): number {
  const across = 1 - along;
  let farthest = Number.NEGATIVE_INFINITY;
  for (const ring of rings) {
    for (let i = 0; i < ring.length; i += 2) {
      const j = (i + 2) % ring.length;
      const [a, b] = [ring[i + along], ring[j + along]];
      if (a > place === b > place) continue;
      const share = (place - a) / (b - a);
      farthest = Math.max(
        farthest,
        away * (ring[i + across] + share * (ring[j + across] - ring[i + across])),
      );
    }
  }
  return farthest;
}

/** The box around an area. */
export function extentOf(polygons: readonly Polygon[]): Bounds {
  return boundsOfAll(polygons.map(({ outer }) => outer));
}
