import { type Bounds, boundsMeet, boundsOf, ringsOf } from '../../core/geometry/rings.ts';
import { type Affine, mapped, type SheetItem, TEXT_SIZES } from '../../core/sheet.ts';
import type { Polygon, Ring } from '../../core/types.ts';
import { meetsEdges } from './clear-box.ts';
import { SQUARE, TEXT_GAP, tickAt } from './dimensions.ts';
import { textWidth } from './text-width.ts';

/** Lines are tried this far from the wall and in such steps into the room, mm. */
const FIRST_LINE = 5;
const LINE_STEP = 1.5;
/** … up to this share of its depth: farther in, a line cuts the room in halves. */
const DEEPEST = 0.45;
/** Blank at either side of a figure on its line, mm. */
const FIGURE_BLANK = 2;
/** A line that stays this much shorter than another measures a niche, not the room. */
const FULL_LENGTH = 0.98;

export interface InnerFacts {
  readonly rooms: readonly Polygon[];
  /** Lines keep off these. */
  readonly structures: readonly Polygon[];
  /** Figures keep off its edges, where they find another place. */
  readonly furniture: readonly Polygon[];
  readonly planToSheet: Affine;
  /** Boxes of labels, mm. */
  readonly taken: readonly Bounds[];
  /** What stands at a line, by its length in mm. */
  figure(length: number): string;
}

/** A line from wall to wall, mm on the sheet: along x (0) or y, its place across, and from where to where it runs. */
export interface RoomChord {
  readonly along: 0 | 1;
  readonly place: number;
  readonly from: number;
  readonly to: number;
}

/** The width and the depth of every room that has space for the figures, along its walls, with ticks at their faces. */
export function drawRoomDimensions(facts: InnerFacts): SheetItem[] {
  return roomChords(facts).flatMap((chord) => drawChord(chord, facts.figure(chord.to - chord.from)));
}

/** Where the width and the depth of every room are measured that has space for the figures. */
export function roomChords(facts: InnerFacts): RoomChord[] {
  const { rooms, structures, planToSheet, taken, figure } = facts;
  const obstacles = [...taken, ...structures.map(({ outer }) => boundsOf(mapped(outer, planToSheet)))];
  const furniture = ringsOf(facts.furniture).map((ring) => mapped(ring, planToSheet));
  return rooms.flatMap((room) => {
    const rings = ringsOf([room]).map((ring) => mapped(ring, planToSheet));
    const choose = (along: 0 | 1, keepOff: readonly Ring[]) =>
      chooseChord(rings, along, { obstacles, keepOff, figure });
    return ([0, 1] as const).flatMap((along) => choose(along, furniture) ?? choose(along, []) ?? []);
  });
}

interface ChordChoice {
  readonly obstacles: readonly Bounds[];
  /** Closed lines that the figure is not to stand on. */
  readonly keepOff: readonly Ring[];
  figure(length: number): string;
}

/** The line nearest to the lower or the left wall that runs the whole room and meets nothing. */
function chooseChord(
  rings: readonly Ring[],
  along: 0 | 1,
  { obstacles, keepOff, figure }: ChordChoice,
): RoomChord | null {
  const { minX, minY, maxX, maxY } = boundsOf(rings[0]);
  // Below is where y is greatest.
  const [start, depth, way] = along === 0 ? [maxY, maxY - minY, -1] : [minX, maxX - minX, 1];
  const whole = along === 0 ? maxX - minX : maxY - minY;
  for (let into = FIRST_LINE; into <= DEEPEST * depth; into += LINE_STEP) {
    const chord = longestChord(rings, along, start + way * into);
    if (chord === null || chord.to - chord.from < FULL_LENGTH * whole) continue;
    const length = chord.to - chord.from;
    const width = textWidth(figure(length), TEXT_SIZES.label) + 2 * FIGURE_BLANK;
    if (width > length) return null;
    const high = TEXT_SIZES.label + 2 * TEXT_GAP;
    const band: Bounds =
      along === 0
        ? { minX: chord.from, maxX: chord.to, minY: chord.place - high, maxY: chord.place + TEXT_GAP }
        : { minX: chord.place - high, maxX: chord.place + TEXT_GAP, minY: chord.from, maxY: chord.to };
    if (obstacles.some((box) => boundsMeet(box, band))) continue;
    const [from, to] = [(chord.from + chord.to - width) / 2, (chord.from + chord.to + width) / 2];
    const words = along === 0 ? { ...band, minX: from, maxX: to } : { ...band, minY: from, maxY: to };
    if (!meetsEdges(keepOff, words)) return chord;
  }
  return null;
}

/** The longest stretch inside that a line at a place has, where walls end it squarely. */
function longestChord(rings: readonly Ring[], along: 0 | 1, place: number): RoomChord | null {
  const across = 1 - along;
  const cuts: { at: number; isSquare: boolean }[] = [];
  for (const ring of rings) {
    for (let i = 0; i < ring.length; i += 2) {
      const j = (i + 2) % ring.length;
      const [a, b] = [ring[i + across], ring[j + across]];
      if (a > place === b > place) continue;
      const run = ring[j + along] - ring[i + along];
      const isSquare = Math.abs(run) < SQUARE * Math.hypot(run, b - a);
      cuts.push({ at: ring[i + along] + ((place - a) / (b - a)) * run, isSquare });
    }
  }
  cuts.sort((a, b) => a.at - b.at);
  let best: RoomChord | null = null;
  for (let k = 0; k + 1 < cuts.length; k += 2) {
    const [from, to] = [cuts[k], cuts[k + 1]];
    if (!from.isSquare || !to.isSquare) continue;
    if (best === null || to.at - from.at > best.to - best.from)
      best = { along, place, from: from.at, to: to.at };
  }
  return best;
}

function drawChord({ along, place, from, to }: RoomChord, text: string): SheetItem[] {
  const at = (value: number) => (along === 0 ? ([value, place] as const) : ([place, value] as const));
  const [x, y] = at((from + to) / 2);
  const figure = along === 0 ? { x, y: y - TEXT_GAP } : { x: x - TEXT_GAP, y, isUpright: true };
  return [
    { kind: 'path', style: 'dimension', lines: [Float64Array.of(...at(from), ...at(to))], isClosed: false },
    { kind: 'path', style: 'tick', lines: [from, to].map((end) => tickAt(...at(end))), isClosed: false },
    { kind: 'text', size: 'label', ...figure, text, anchor: 'middle' },
  ];
}
