import { lengthOf } from './hull-ring.ts';
import {
  depthOf,
  insertInto,
  isDeep,
  leaveClosed,
  noiseDepth,
  type Opening,
  type OpeningRules,
  takeBack,
} from './opening.ts';
import { unpassedPointBehind } from './passed-points.ts';
import {
  CAVITY_DEPTHS,
  fits,
  isCavity,
  isWholeRoom,
  type Pocket,
  restore,
  snapshot,
  startPocket,
  takeIn,
} from './pocket.ts';
import { continuesWalls } from './wall-run.ts';

/** A recess may leave this share of its mouth's length unsupported, windows say; an equal trade is no recess. */
const UNSUPPORTED_SHARE = 0.95;
/** Side tolerance of a pocket per metre of mouth. */
const TOLERANCE_SHARE = 0.02;
/** Openings in openings; a pocket that needs more stays closed. */
const DEEPEST = 1_000;
/** Strips in strips: a window in the back wall of a recess in a courtyard. */
const MOST_STRIPS = 4;
/** Cost of what lies behind a mouth that proved to be none: all of it is taken back at once. */
const LOST = Number.POSITIVE_INFINITY;
/** A mouth behind a mouth has a strip of its own where both its walls turn off by less than this: cosine of 45°. */
const LEAST_COSINE = Math.SQRT1_2;

/**
 * Opens the edge a → next[a] to p and all that lies behind it, and takes it back when it proves to be no recess.
 *
 * Cost of an outline is the length of its edges no points support: those that stay longer than `supportLength`. Each
 * edge behind the mouth stays closed where that costs less than what opening it leads to, so a window in the side of
 * a recess is bridged; the mouth itself is opened only when what lies behind costs less than the mouth, fits a strip
 * ({@link Pocket}), is no hollow wall and not the whole room. Otherwise it is noted as a bridge.
 */
export function openOnTrial(opening: Opening, rules: OpeningRules, a: number, p: number): void {
  if (isCrack(opening, rules, a, p)) return;
  openMouth({ opening, rules }, { a, p, length: lengthOf(opening.hull, a), level: 1 }, null);
}

/** Whether a mouth no longer than a step along a wall, in the chain of pockets, has proved to lead into a hollow. */
function isLost(pocket: Pocket | null, { supportLength }: OpeningRules): boolean {
  for (let at = pocket; at !== null; at = at.outer)
    if (at.length <= supportLength && isCavity(at)) return true;
  return false;
}

/** Whether an edge no longer than a step along a wall leads so deep that it can be no recess: spares most trials. */
function isCrack({ hull }: Opening, rules: OpeningRules, a: number, p: number): boolean {
  const length = lengthOf(hull, a);
  if (length > rules.supportLength) return false;
  return depthOf(hull, a, hull.next[a], p) > Math.max(noiseDepth(rules), CAVITY_DEPTHS * length);
}

interface Trial {
  readonly opening: Opening;
  readonly rules: OpeningRules;
}

interface Mouth {
  readonly a: number;
  readonly p: number;
  readonly length: number;
  readonly level: number;
}

/** Opens a mouth with a strip of its own; returns the cost of the outline it leaves. */
function openMouth(trial: Trial, mouth: Mouth, outer: Pocket | null): number {
  const { opening, rules } = trial;
  const { a, length } = mouth;
  const tolerance = Math.max(noiseDepth(rules), TOLERANCE_SHARE * length);
  const pocket = startPocket(opening.hull, a, { length, tolerance, areaBefore: opening.area, outer });
  return openBehind(trial, mouth, pocket, outer);
}

/** Opens an edge behind a mouth as far as it pays; returns the cost of the outline it leaves. */
function openInner(trial: Trial, a: number, pocket: Pocket, level: number): number {
  const { opening, rules } = trial;
  const { hull } = opening;
  const length = lengthOf(hull, a);
  if (length <= rules.openingLength) return 0;
  const p = level > DEEPEST ? -1 : unpassedPointBehind(hull, a, rules);
  const isOpen = p >= 0 && !isCrack(opening, rules, a, p) && fits(pocket, hull, p);
  if (!isOpen) return leaveClosed(opening, rules, a, length);
  const mouth = { a, p, length, level };
  const mayHaveStrip = length <= rules.bridgeLimit && pocket.level < MOST_STRIPS;
  const isMouth = mayHaveStrip && isDeep(opening, rules, a, p) && continuesWalls(hull, a, LEAST_COSINE);
  return isMouth ? openMouth(trial, mouth, pocket) : openBehind(trial, mouth, pocket, pocket);
}

/**
 * Opens an edge to its point, both new edges in turn, the longer first, and takes that back when closed costs less.
 *
 * @param pocket the strips to stay in; its own one only when `pocket` is not `outer`
 */
function openBehind(trial: Trial, mouth: Mouth, pocket: Pocket, outer: Pocket | null): number {
  const { opening, rules } = trial;
  const { hull, log, bridges } = opening;
  const { a, p, length, level } = mouth;
  const before = snapshot(outer);
  const logged = log.length;
  const bridged = bridges.length;
  const isOwn = pocket !== outer;
  const excess = Math.max(0, length - rules.supportLength);
  const allowed = isOwn ? UNSUPPORTED_SHARE * excess : excess;
  takeIn(pocket, hull, p);
  insertInto(opening, rules, a, p);
  const [long, short] = lengthOf(hull, a) >= lengthOf(hull, p) ? [a, p] : [p, a];
  let cost = isLost(pocket, rules) ? LOST : openInner(trial, long, pocket, level + 1);
  if (cost <= allowed) cost += openInner(trial, short, pocket, level + 1);
  // Whoever's strip is lost takes all of it back.
  if (cost === LOST && isLost(outer, rules)) return LOST;
  const isHollow = isOwn && cost <= allowed && isCavity(pocket);
  if (cost <= allowed && !isHollow && !(isOwn && isWholeRoom(pocket, opening.area))) return cost;
  takeBack(opening, logged);
  restore(outer, before);
  bridges.length = bridged;
  const closed = leaveClosed(opening, rules, a, length);
  // What lies across the end of a hollow wall is no gap.
  if (isHollow) bridges.length = bridged;
  return closed;
}
