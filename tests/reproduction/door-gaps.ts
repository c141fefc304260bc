/** What a gap in a wall costs with the safeguard and without, and how well a recess as wide is followed. */
import { findBoundary } from '../../src/core/boundary.ts';
import { signedArea } from '../../src/core/geometry/rings.ts';
import { squaredDistanceToSegment } from '../../src/core/geometry/segments.ts';
import type { Options } from '../../src/core/params.ts';
import type { Gap, Ring, Slice } from '../../src/core/types.ts';
import { areaError, intersectionOverUnion, ringOf } from '../unit/core/boundary/measures.ts';
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
import {
  closableArea,
  cornersAlong,
  isConvexAt,
  pointAlong,
  RECESSES,
  ROOMS,
  rotated,
} from './room-cases.ts';

export const GAP_WIDTHS = [0.3, 0.6, 1, 1.5, 2, 2.5, 3] as const;
const PLACES = ['in a wall', 'near a corner', 'at a convex corner', 'at a concave corner'] as const;
const NOISES = [0, 0.006, 0.02] as const;
const PER_METRE = [20, 33, 60, 100] as const;
const SEEDS = [1, 2] as const;
/** From finer than any scan to longer than most recesses are wide. */
export const OPENING_LENGTHS = [0.05, 'auto', 0.3, 0.5, 1, 2, 3, 5] as const;
type OpeningLength = Options['openingLength'];
/** Shorter sides are of a round wall, m. */
const SHORTEST_WALL = 1;
/** Less of a wall, m, is a handful of points. */
const REMNANT = 0.1;
/** A bridge straight across a corner passes it at up to half its length. */
const STRAIGHT_ACROSS = 0.5;

/** One scan of a room with a gap, and of the same room without. */
export interface GapCase {
  readonly room: string;
  readonly place: (typeof PLACES)[number];
  readonly width: number;
  readonly noise: number;
  readonly perMetre: number;
  /** The room as it stands. */
  readonly path: Path;
  readonly truth: Ring;
  /** Where the wall is missing: its two ends, and the corners between them. */
  readonly missing: Path;
  readonly slice: Slice;
  /** Outline of the same scan without the gap. */
  outlineOfWhole(openingLength: OpeningLength): Ring;
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
      const outlineOfWhole = outlinesOf(asSlice(scanWalls(scan)));
      const missing = stretchOf(path, from, from + width);
      const truth = ringOf(path);
      cases.push({ room, place, width, noise, perMetre, path, truth, missing, slice, outlineOfWhole });
    }
  }
  return cases;
}

/** Outlines of a slice, each made once. */
function outlinesOf(slice: Slice): GapCase['outlineOfWhole'] {
  const outlines = new Map<OpeningLength, Ring>();
  return (openingLength) => {
    const outline = outlines.get(openingLength) ?? outlineOf(slice, { openingLength });
    outlines.set(openingLength, outline);
    return outline;
  };
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

/** The stretch of a path from one place along it to another. */
function stretchOf(path: Path, from: number, to: number): Path {
  const at = cornersAlong(path);
  const total = at.at(-1)!;
  const corners = [-total, 0, total].flatMap((by) => at.slice(0, -1).map((place) => place + by));
  const between = corners.filter((place) => place > from && place < to);
  return [from, ...between, to].map((place) => pointAlong(path, place));
}

/**
 * Share of the true area that a gap costs: by how much an outline misses the areas that outlines of the same room
 * without a gap have.
 *
 * These are no single number. Noise widens any hull. And gift opening leaves edges up to the opening length closed, gap
 * or none: which of them, at a concave corner or across a bay, hangs on where single points lie. Eight scans of one
 * room without a gap differ by up to 5 % at 3 m, 20 % at 5 m. So an outline may lie between the truth and all that
 * edges of the opening length can close ({@link closableArea}), plus the noise of the same scan without its gap.
 */
export function areaLostToGap(
  found: Ring,
  { path, truth, outlineOfWhole }: GapCase,
  openingLength: OpeningLength,
): number {
  const area = areaOf(truth);
  const same = areaOf(outlineOfWhole(openingLength));
  const closable = openingLength === 'auto' ? 0 : closableArea(path, openingLength);
  const most = Math.max(same, areaOf(outlineOfWhole('auto')) + closable, area + closable);
  return Math.max(0, Math.min(area, same) - areaOf(found), areaOf(found) - most) / area;
}

function areaOf(ring: Ring): number {
  return Math.abs(signedArea(ring));
}

export function outlineOf(slice: Slice, given: Partial<Options> = {}): Ring {
  return findBoundary(slice, optionsWith(given), listeningContext()).polygons[0].outer;
}

/** How far the ends of a gap lie apart: less than its width where it goes around a corner. */
export function widthAcross({ missing }: GapCase): number {
  const [[ax, ay], [bx, by]] = [missing[0], missing[missing.length - 1]];
  return Math.hypot(bx - ax, by - ay);
}

/** Width of the gaps named where the wall is missing. */
export function widthNamed({ missing, width }: GapCase, gaps: readonly Gap[]): number {
  const isThere = ({ from, to }: Gap) => {
    const [x, y] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    return missing.some((end, k) => {
      const next = missing[Math.min(k + 1, missing.length - 1)];
      return squaredDistanceToSegment(x, y, ...end, ...next) <= (STRAIGHT_ACROSS * width) ** 2;
    });
  };
  return gaps.filter(isThere).reduce((sum, gap) => sum + gap.width, 0);
}

interface Trial {
  readonly room: string;
  readonly width: number;
  readonly openingLength: OpeningLength;
  readonly cost: number;
  readonly costWithout: number;
  /** Error of the area of the same room without a gap. */
  readonly own: number;
}

/** Every case at three opening lengths in turn, with the safeguard and, where `bridgeGap` is 0, without. */
function trials(): readonly Trial[] {
  const cases = GAP_WIDTHS.flatMap((width) => SEEDS.flatMap((seed) => gapCases(width, seed)));
  return cases.flatMap((gapCase, k) =>
    [k, k + 3, k + 6].map((turn) => tryOut(gapCase, OPENING_LENGTHS[turn % OPENING_LENGTHS.length])),
  );
}

function tryOut(gapCase: GapCase, openingLength: OpeningLength): Trial {
  const { room, width, truth, slice, outlineOfWhole } = gapCase;
  const costWith = (given: Partial<Options>) =>
    areaLostToGap(outlineOf(slice, { openingLength, ...given }), gapCase, openingLength);
  const own = areaError(outlineOfWhole(openingLength), truth);
  return { room, width, openingLength, cost: costWith({}), costWithout: costWith({ bridgeGap: 0 }), own };
}

/** What gaps cost, see {@link areaLostToGap}: by their width, and by the opening length and the room. */
export function doorGaps(): DoorGaps {
  const tried = trials();
  const byWidth = GAP_WIDTHS.map((width) => {
    const same = tried.filter((trial) => trial.width === width);
    const [costs, without] = [same.map(({ cost }) => cost), same.map(({ costWithout }) => costWithout)];
    return {
      width,
      worst: Math.max(...costs),
      mean: meanOf(costs),
      worstWithout: Math.max(...without),
      meanWithout: meanOf(without),
    };
  });
  const byOpeningLength = OPENING_LENGTHS.map((openingLength) => {
    const same = tried.filter((trial) => trial.openingLength === openingLength);
    const worstIn = (room: string) =>
      Math.max(...same.filter((trial) => trial.room === room).map(({ cost }) => cost));
    const worst = Object.fromEntries(Object.keys(ROOMS).map((room) => [room, worstIn(room)]));
    return { openingLength, worst, own: Math.max(...same.map(({ own }) => own)) };
  });
  return { byWidth, byOpeningLength };
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
