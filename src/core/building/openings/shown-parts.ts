import { LEVEL_SHARE, levelReach } from './reveal-levels.ts';
import { THROUGH_SHARE, throughShare, type WallLook } from './wall-look.ts';

/** A void that goes on so far past its sill and its head, m, is hidden there: by a cupboard, not by chance. */
const LEAST_HIDDEN = 0.5;

/** An end of a part of a void, m along the wall. */
export interface PartEnd {
  readonly at: number;
  readonly isJamb: boolean;
}

/**
 * What a void between two ends shows: beside a jamb an opening ends where its sill and its head do, unless the scan sees through
 * what is past that. Where a void goes on, the wall behind may be hidden.
 *
 * Windows F1 of scenes .95 → .97. Not taken: voids hidden from 0.25 m on, and between two jambs wherever sill and head break off
 * (doors of hard scenes 11 → 28 mm off their width).
 */
export function shownParts(
  look: WallLook,
  { reveals, isFramed }: { readonly reveals: readonly number[]; readonly isFramed: boolean },
  left: PartEnd,
  right: PartEnd,
): [PartEnd, PartEnd][] {
  if (isFramed) return [[left, right]];
  const between = { begin: left.at, end: right.at };
  const width = right.at - left.at;
  // Two jambs are one opening's unless hardly any of its sill and head was seen.
  const mostShown = left.isJamb && right.isJamb ? LEVEL_SHARE * width : width - LEAST_HIDDEN;
  const reachFrom = (end: PartEnd, way: 1 | -1): number | null => {
    const reach = end.isJamb ? levelReach(look.strip, reveals, between, way) : null;
    return reach !== null && reach <= mostShown ? reach : null;
  };
  const [fromLeft, fromRight] = [reachFrom(left, 1), reachFrom(right, -1)];
  const hidden = { begin: left.at + (fromLeft ?? 0), end: right.at - (fromRight ?? 0) };
  const isWhole = (fromLeft === null && fromRight === null) || hidden.end <= hidden.begin;
  if (isWhole || throughShare(look, hidden) >= THROUGH_SHARE) return [[left, right]];
  const parts: [PartEnd, PartEnd][] = [];
  if (fromLeft !== null) parts.push([left, { at: hidden.begin, isJamb: false }]);
  if (fromRight !== null) parts.push([{ at: hidden.end, isJamb: false }, right]);
  return parts;
}
