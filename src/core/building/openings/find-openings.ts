import type { PlacedOpening } from './joined-openings.ts';
import { faceHeights } from './opening-heights.ts';
import { revealLevels } from './reveal-levels.ts';
import { leafParts, type VoidPart, voidParts } from './void-parts.ts';
import {
  FEWEST,
  faceBand,
  STEP,
  type Stretch,
  THROUGH_SHARE,
  throughShare,
  type WallLook,
} from './wall-look.ts';
import type { WallStretch, WallStrip } from './wall-strip.ts';

/** Heights are looked for so far off the ends of an opening, m, or a quarter of its width where it is narrow. */
const OFF_ENDS = 0.1;
/** Least height of an opening, m. */
const LEAST_OPEN = 0.3;
/** A door's sill is no higher, its head no lower, m. */
const DOOR_SILL = 0.15;
const LEAST_HEAD = 1.8;
/** An opening whose head is this near the ceiling has no lintel, m: points nearer to it are the ceiling's. */
const NO_LINTEL = 0.1;
/** Reveals are so near an opening's ends, m … */
const REVEAL_REACH = 0.05;
/** … and as deep as this share of their points, a few astray. */
const REVEAL_SHARE = 0.98;

/** How sure a closed leaf in a wall is. */
const CLOSED_CONFIDENCE = 0.6;

/** A hole in a wall: reach along its face and heights above the floor, m. */
export interface FoundOpening {
  readonly type: 'door' | 'window' | 'passage';
  readonly from: number;
  readonly to: number;
  readonly sill: number;
  readonly head: number;
  /** Depth of its reveals, m; NaN where none was seen. */
  readonly reveal: number;
  readonly confidence: number;
}

/**
 * Doors, windows and passages of a stretch of wall.
 *
 * A void at eye height in every face of the wall may be an opening or hidden. Reveals tell: points within the wall, which
 * stand upright at jambs and lie level at sills and heads. Jambs part a void; a part is an opening where sill or head is seen
 * over most of its width, where beside a jamb the scan sees through or the face stands above and below, or where both faces of the
 * wall end at both its sides: no two things hide the two faces alike. Leaves that noise put on the face come second: where they came first, they took the place of
 * windows and drew false openings (of 84 clouds 3 worse, 1 better). O(points).
 */
export function findOpenings(look: WallLook): FoundOpening[] {
  const band = faceBand(look);
  const open = voidParts(look, band).flatMap((part) => openingIn(look, part, band) ?? []);
  const leaves = leafParts(look, band).flatMap((part) => openingIn(look, part, band) ?? []);
  const isApart = (leaf: FoundOpening) => open.every(({ from, to }) => to <= leaf.from || from >= leaf.to);
  return [...open, ...leaves.filter(isApart)];
}

function openingIn(look: WallLook, part: VoidPart, band: number): FoundOpening | null {
  const { from, to, jambs, reveals, isClosed } = part;
  const margin = Math.min(OFF_ENDS, (to - from) / 4);
  const stretch: Stretch = { begin: from + margin, end: to - margin };
  // A closed leaf has points at all heights, so that only the faces beside it tell.
  const { head, sill } = isClosed ? { head: null, sill: null } : revealLevels(look.strip, reveals, stretch);
  const through = throughShare(look, stretch);
  const isSeenThrough = jambs > 0 && through >= THROUGH_SHARE;
  const faces = faceHeights(look, stretch, band, isClosed);
  const isRinged = jambs > 0 && faces.sill > DOOR_SILL && faces.head < look.ceiling - NO_LINTEL;
  const isHole = head !== null || sill !== null || isSeenThrough || isRinged || part.isFramed;
  if (!isHole && !isClosed) return null;
  const [bottom, top] = [sill ?? faces.sill, head ?? faces.head];
  if (top - bottom < LEAST_OPEN) return null;
  const isLow = bottom <= DOOR_SILL && top >= LEAST_HEAD;
  const type = !isLow ? 'window' : look.ceiling - top <= NO_LINTEL ? 'passage' : 'door';
  // What else stands flat before a hidden wall is furniture.
  if (isClosed && type !== 'door') return null;
  const evidence = jambs + (head === null ? 0 : 1) + (isLow ? through : sill === null ? 0 : 1);
  return {
    type,
    from,
    to,
    sill: isLow ? 0 : bottom,
    head: top,
    reveal: isClosed ? Number.NaN : revealDepth(look.strip, part),
    confidence: isClosed ? CLOSED_CONFIDENCE : Math.min(1, evidence / 3),
  };
}

function revealDepth({ along, deep }: WallStrip, { from, to, reveals }: VoidPart): number {
  const own = reveals.filter((i) => along[i] > from - REVEAL_REACH && along[i] < to + REVEAL_REACH);
  if (own.length < FEWEST) return Number.NaN;
  const depths = Float64Array.from(own, (i) => deep[i]).sort();
  return depths[Math.floor(REVEAL_SHARE * (depths.length - 1))];
}

/** A hole of a stretch of wall in the plan, its line `deep` behind the face, m. */
export function placeOpening(
  { type, from, to, sill, head, confidence }: FoundOpening,
  { x, y, ux, uy, length }: WallStretch,
  deep: number,
): PlacedOpening {
  const at = (along: number) => [x + along * ux + deep * uy, y + along * uy - deep * ux] as const;
  return {
    opening: { type, from: at(from), to: at(to), sill, head, confidence },
    isCutBefore: from <= STEP,
    isCutAfter: to >= length - STEP,
  };
}
