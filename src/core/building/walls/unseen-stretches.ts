import type { Gap } from '../../types.ts';
import type { WallStrip } from '../openings/wall-strip.ts';
import type { RoomEdge } from './room-edges.ts';

/** A face is looked at through a window this wide, m, moved on by steps of a part of it. */
const STEP = 0.025;
const STEPS_A_WINDOW = 4;
/** Shortest stretch told, m: voxels leave shorter ones in any wall. */
const SHORTEST = 0.3;
/** Height over which a window must have points to be seen, m. */
const LEAST_HEIGHT = 0.1;
/** Above a cupboard a wall may be seen just below the ceiling: points there are counted so near before the face, m … */
const NEAR = 0.06;
/** … over so long a stretch, m … */
const LOOK = 0.4;
/** … and farther before it, by which it is known how densely the ceiling was seen. */
const BESIDE = { from: 0.1, to: 0.35 };
/** With so many times the points of a ceiling, and at least so many, some are the wall's. */
const MORE_THAN_CEILING = 1.4;
const FEWEST = 4;

/** A part of an edge, as places along it, m. */
interface Part {
  readonly from: number;
  readonly to: number;
}

/** The points along an edge. */
export interface Sights {
  /** Those on its face. */
  readonly face: WallStrip;
  /** Those near the ceiling, on the face and before it; the strip begins {@link CEILING_LOOK} before. */
  readonly ceiling: WallStrip;
}

/** How far before a face its ceiling is looked at, m. */
export const CEILING_LOOK = BESIDE.to;

/**
 * The stretches of a face that no point supports and no opening explains. O(points + length).
 *
 * By a window that moves: by bits of 10 cm, of those there are in clean scenes .70 were told, now .82.
 */
export function unseenStretches(
  { ax, ay, ux, uy, length }: RoomEdge,
  { face, ceiling }: Sights,
  band: number,
  openings: readonly Part[],
): Gap[] {
  const isSeen = seenWindows(face, length, band);
  const isSeenAbove = ceilingWindows(ceiling, length, band);
  const isOpen = (window: number) => {
    const middle = (window + STEPS_A_WINDOW / 2) * STEP;
    return openings.some(({ from, to }) => middle > from && middle < to);
  };
  const stretches: Gap[] = [];
  for (let window = 0, begin = 0; window <= isSeen.length; window++) {
    if (window < isSeen.length && !(isSeen[window] || isSeenAbove[window] || isOpen(window))) continue;
    const whole = { from: begin * STEP, to: Math.min(length, (window - 1 + STEPS_A_WINDOW) * STEP) };
    const { from, to } = besideOpenings(whole, openings);
    if (window > begin && to - from >= SHORTEST) {
      const at = (along: number) => [ax + along * ux, ay + along * uy] as const;
      stretches.push({ from: at(from), to: at(to), width: to - from });
    }
    begin = window + 1;
  }
  return stretches;
}

/** 1 for the windows in which points of a face lie over some height, from the start of an edge to its end. */
function seenWindows({ count, along, deep, high }: WallStrip, length: number, band: number): Uint8Array {
  const steps = stepsOf(length);
  const low = new Float64Array(steps).fill(Infinity);
  const top = new Float64Array(steps).fill(-Infinity);
  for (let i = 0; i < count; i++) {
    if (Math.abs(deep[i]) > band) continue;
    const step = Math.min(steps - 1, Math.floor(along[i] / STEP));
    low[step] = Math.min(low[step], high[i]);
    top[step] = Math.max(top[step], high[i]);
  }
  return Uint8Array.from({ length: steps - STEPS_A_WINDOW + 1 }, (_, window) => {
    const end = window + STEPS_A_WINDOW;
    const seen = Math.max(...top.subarray(window, end)) - Math.min(...low.subarray(window, end));
    return seen >= LEAST_HEIGHT ? 1 : 0;
  });
}

/** 1 for the windows in which more points lie below the ceiling than it has itself. */
function ceilingWindows({ count, along, deep }: WallStrip, length: number, band: number): Uint8Array {
  const steps = stepsOf(length);
  const [near, beside] = [new Uint32Array(steps), new Uint32Array(steps)];
  for (let i = 0; i < count; i++) {
    const step = Math.min(steps - 1, Math.floor(along[i] / STEP));
    const before = CEILING_LOOK - deep[i];
    if (before >= -band && before <= NEAR) near[step]++;
    else if (before >= BESIDE.from && before <= BESIDE.to) beside[step]++;
  }
  const half = Math.round((LOOK / STEP - STEPS_A_WINDOW) / 2);
  const sum = (counts: Uint32Array, window: number) =>
    counts
      .subarray(Math.max(0, window - half), window + STEPS_A_WINDOW + half)
      .reduce((total, n) => total + n, 0);
  const least = (MORE_THAN_CEILING * NEAR) / (BESIDE.to - BESIDE.from);
  return Uint8Array.from({ length: steps - STEPS_A_WINDOW + 1 }, (_, window) => {
    const seen = sum(near, window);
    return seen >= FEWEST && seen >= least * sum(beside, window) ? 1 : 0;
  });
}

const stepsOf = (length: number): number => Math.max(STEPS_A_WINDOW, Math.ceil(length / STEP));

/** A part without the openings that it begins or ends in. */
function besideOpenings({ from, to }: Part, openings: readonly Part[]): Part {
  const first = openings.find((opening) => opening.from < from && from < opening.to);
  const last = openings.find((opening) => opening.from < to && to < opening.to);
  return { from: first?.to ?? from, to: last?.from ?? to };
}
