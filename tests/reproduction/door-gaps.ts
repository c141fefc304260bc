/** What a gap in a wall costs with the safeguard and without, and how well a recess as wide is followed. */
import { findBoundary } from '../../src/core/boundary.ts';
import { signedArea } from '../../src/core/geometry/rings.ts';
import type { Options } from '../../src/core/params.ts';
import type { Ring, Slice } from '../../src/core/types.ts';
import { intersectionOverUnion, ringOf } from '../unit/core/boundary/measures.ts';
import {
  asSlice,
  closed,
  listeningContext,
  optionsWith,
  type Path,
  randomNumbers,
  scanWalls,
} from '../unit/core/boundary/wall-slices.ts';
import type { DoorGaps, Recesses } from './experiments.ts';
import { cornersAlong, isConvexAt, RECESSES, ROOMS, rotated } from './room-cases.ts';

export const GAP_WIDTHS = [0.3, 0.6, 1, 1.5, 2, 2.5, 3] as const;
const PLACES = ['in a wall', 'near a corner', 'at a convex corner', 'at a concave corner'] as const;
const NOISES = [0, 0.006, 0.02] as const;
const PER_METRE = [20, 33, 60, 100] as const;
const SEEDS = [1, 2] as const;
/** Shorter sides are of a round wall, m. */
const SHORTEST_WALL = 1;
/** Less of a wall, m, is a handful of points. */
const REMNANT = 0.1;

/** One scan of a room with a gap, and of the same room without. */
export interface GapCase {
  readonly room: string;
  readonly place: (typeof PLACES)[number];
  readonly width: number;
  readonly noise: number;
  readonly perMetre: number;
  readonly truth: Ring;
  readonly slice: Slice;
  readonly whole: Slice;
}

/** Every room and place with a gap of one width; the exact place, turn, density and noise by the seed. */
export function gapCases(width: number, seed: number): GapCase[] {
  const random = randomNumbers(1000 * seed + Math.round(100 * width));
  const cases: GapCase[] = [];
  for (const [room, shape] of Object.entries(ROOMS)) {
    for (const place of PLACES) {
      const from = startOfGap(shape, place, width, random);
      if (from === null || takesAWall(shape, from, from + width)) continue;
      const path = rotated(shape, random() < 0.3 ? 0 : 2 * Math.PI * random());
      const perMetre = PER_METRE[Math.floor(random() * PER_METRE.length)];
      const noise = NOISES[Math.floor(random() * NOISES.length)];
      const scan = { walls: [closed(path)], perMetre, noise, seed: Math.floor(random() * 1e9) };
      const total = cornersAlong(shape).at(-1)!;
      const gaps = [-total, 0, total].map((by) => ({ wall: 0, from: from + by, to: from + by + width }));
      const slice = asSlice(scanWalls({ ...scan, gaps }));
      const whole = asSlice(scanWalls(scan));
      cases.push({ room, place, width, noise, perMetre, truth: ringOf(path), slice, whole });
    }
  }
  return cases;
}

/** Metres along a room to where a gap begins; null when the room has no such corner. */
function startOfGap(room: Path, place: GapCase['place'], width: number, random: () => number): number | null {
  const at = cornersAlong(room);
  if (place === 'in a wall') return random() * at.at(-1)!;
  const wanted = place === 'near a corner' ? null : place === 'at a convex corner';
  const corners = room.map((_, k) => k).filter((k) => wanted === null || isConvexAt(room, k) === wanted);
  if (corners.length === 0) return null;
  const corner = at[corners[Math.floor(random() * corners.length)]];
  if (wanted !== null) return corner - width * (0.1 + 0.8 * random());
  const beside = 0.05 + 0.25 * random();
  return random() < 0.5 ? corner + beside : corner - beside - width;
}

/** Whether a gap leaves nothing of some wall: no point tells then where it stood. Round walls have no such. */
function takesAWall(room: Path, from: number, to: number): boolean {
  const at = cornersAlong(room);
  const total = at.at(-1)!;
  return room.some((_, k) => {
    if (at[k + 1] - at[k] < SHORTEST_WALL) return false;
    return [-total, 0, total].some((by) => at[k] + by >= from - REMNANT && at[k + 1] + by <= to + REMNANT);
  });
}

/**
 * Share of the true area by which an outline misses the range from the truth to the outline of the same scan without
 * its gap: noise widens any hull and a long opening length closes notches, gap or none.
 */
export function areaLostToGap(found: Ring, truth: Ring, whole: Ring): number {
  const [area, first, second] = [found, truth, whole].map((ring) => Math.abs(signedArea(ring)));
  return Math.max(0, Math.min(first, second) - area, area - Math.max(first, second)) / first;
}

export function outlineOf(slice: Slice, given: Partial<Options> = {}): Ring {
  return findBoundary(slice, optionsWith(given), listeningContext()).polygons[0].outer;
}

/**
 * Area errors by the width of the gap, at the opening lengths auto, 0.05, 0.5 and 2 m, see {@link areaLostToGap};
 * without the safeguard `bridgeGap` is 0.
 */
export function doorGaps(): readonly DoorGaps[] {
  return GAP_WIDTHS.map((width) => {
    const errors: number[] = [];
    const errorsWithout: number[] = [];
    for (const { slice, whole, truth } of SEEDS.flatMap((seed) => gapCases(width, seed))) {
      for (const openingLength of ['auto', 0.05, 0.5, 2] as const) {
        const reference = outlineOf(whole, { openingLength });
        const errorWith = (given: Partial<Options>) =>
          areaLostToGap(outlineOf(slice, { openingLength, ...given }), truth, reference);
        errors.push(errorWith({}));
        errorsWithout.push(errorWith({ bridgeGap: 0 }));
      }
    }
    return {
      width,
      worst: Math.max(...errors),
      mean: meanOf(errors),
      worstWithout: Math.max(...errorsWithout),
      meanWithout: meanOf(errorsWithout),
    };
  });
}

const RECESS_DEPTHS = [0.2, 0.3, 0.6, 1.2, 2, 3] as const;
/** Deeper in mouths, a recess no wider than a thick wall counts as the hollow of a wall. */
const DEEPEST_IN_MOUTHS = 4;

/** IoU of the raw hull with the truth by the width of a recess's mouth; every recess, depth and noise. */
export function recesses(): readonly Recesses[] {
  return GAP_WIDTHS.map((width) => {
    const shares: number[] = [];
    const random = randomNumbers(Math.round(1000 * width));
    for (const shape of Object.values(RECESSES)) {
      for (const depth of RECESS_DEPTHS) {
        for (const noise of NOISES) {
          if (depth > DEEPEST_IN_MOUTHS * width) continue;
          const path = rotated(shape(width, depth), 2 * Math.PI * random());
          const scan = { walls: [closed(path)], perMetre: 60, noise, seed: Math.floor(random() * 1e9) };
          shares.push(intersectionOverUnion(outlineOf(asSlice(scanWalls(scan))), ringOf(path)));
        }
      }
    }
    return { mouth: width, lowest: Math.min(...shares), mean: meanOf(shares) };
  });
}

function meanOf(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}
