import { type Bounds, boundsOfAll } from '../core/geometry/rings.ts';
import type { Polygon } from '../core/types.ts';
import type { Affine, SheetItem } from './sheet.ts';
import type { Surround } from './sheet-page.ts';

/** Distance of the first chain from the plan, between chains, and of text above its line, mm. */
const FIRST_CHAIN = 10;
const NEXT_CHAIN = 8;
const TEXT_GAP = 1;
/** Extension lines start this far from the plan and end this far past the chain, mm. */
const EXTENSION_GAP = 3;
const EXTENSION_OVERHANG = 2;
/** Half the length of an oblique tick along each axis, mm. */
const TICK = 1.1;
/** Blank beyond the outermost chain, mm. */
const CLEARANCE = 6;
/** A step in the outline gets a dimension when it is at least this deep, m, and its dimension this wide, mm. */
const STEP_DEPTH = 0.3;
const SHORTEST = 8;
/** An edge within 2° of the axis stands square to the chain. */
const SQUARE = Math.sin(Math.PI / 90);
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

/**
 * Chooses what to measure: the whole width below and depth at the left, and on every side the steps of the outline
 * that are seen from there.
 *
 * @param footprint disjoint polygons, metres
 * @param scale 50 for 1:50
 */
export function planDimensions(footprint: readonly Polygon[], extent: Bounds, scale: number): Dimensions {
  const chains = { left: [], right: [], top: [], bottom: [] } as Record<Side['name'], (readonly number[])[]>;
  const surround = { left: 0, right: 0, top: 0, bottom: 0 };
  for (const side of SIDES) {
    const [low, high] = side.along === 0 ? [extent.minX, extent.maxX] : [extent.minY, extent.maxY];
    const steps = visibleSteps(footprint, side, { low, high, apart: (SHORTEST * scale) / 1000 });
    if (steps.length > 0) chains[side.name].push([low, ...steps, high]);
    if (side.away === -1) chains[side.name].push([low, high]);
    const count = chains[side.name].length;
    surround[side.name] = CLEARANCE + (count > 0 ? FIRST_CHAIN + (count - 1) * NEXT_CHAIN : 0);
  }
  return { chains, surround };
}

/** Draws the chains: thin lines, oblique ticks, figures in metres to the centimetre read from below or the right. */
export function drawDimensions({ chains }: Dimensions, extent: Bounds, planToSheet: Affine): SheetItem[] {
  return SIDES.flatMap((side) =>
    chains[side.name].flatMap((places, i) =>
      drawChain(side, places, { extent, planToSheet, offset: FIRST_CHAIN + i * NEXT_CHAIN }),
    ),
  );
}

function drawChain(
  side: Side,
  places: readonly number[],
  { extent, planToSheet, offset }: { extent: Bounds; planToSheet: Affine; offset: number },
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
    lines.push(Float64Array.of(...at(place, EXTENSION_GAP), ...at(place, offset + EXTENSION_OVERHANG)));
    const [x, y] = at(place, offset);
    ticks.push(Float64Array.of(x - TICK, y + TICK, x + TICK, y - TICK));
  }
  const items: SheetItem[] = [
    { kind: 'path', style: 'dimension', lines, isClosed: false },
    { kind: 'path', style: 'tick', lines: ticks, isClosed: false },
  ];
  for (let i = 0; i + 1 < places.length; i++) {
    const [x, y] = at((places[i] + places[i + 1]) / 2, offset);
    const text = (places[i + 1] - places[i]).toFixed(2);
    const isUpright = side.along === 1;
    const place = isUpright ? { x: x - TEXT_GAP, y, isUpright } : { x, y: y - TEXT_GAP };
    items.push({ kind: 'text', size: 'label', ...place, text, anchor: 'middle' });
  }
  return items;
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
