import { areaOf, combine } from '../../core/geometry/areas.ts';
import { type Bounds, boundsMeet, boundsOf, ringsOf } from '../../core/geometry/rings.ts';
import { type Affine, mapped, type SheetItem, type SheetText, TEXT_SIZES } from '../../core/sheet.ts';
import type { Ring, Storey } from '../../core/types.ts';
import { isClear, meetsEdges } from './clear-box.ts';
import { isolated } from './isolated.ts';
import { labelPoint } from './label-point.ts';
import { type DisplayUnit, formatArea } from './measure-words.ts';
import type { KeyEntry } from './room-key.ts';
import { shorten, textWidth } from './text-width.ts';

/** Blank around a text, mm, and around a number in a small room. */
const BLANK = 1;
const BLANK_AROUND_NUMBER = 0.4;
/** Blank between two lines of a label, mm. */
const LEADING = 1;
/** A label that does not fit at the middle of its room is tried at so many places across and down. */
const PLACES = 24;
/** Longer names are cut, mm: what may stand beside a plan on the smallest sheet. */
const LONGEST_NAME = 60;

/** A room's name as it stands in the drawing: on one line, and not too long. */
export function drawnName(name: string): string {
  return shorten(name, TEXT_SIZES.label, LONGEST_NAME);
}

/** Middle of texts that are led out, off the plan, mm: between it and the first chain. */
const LED_OUT = 2.8;
/** Boxes that stand side by side are so far apart, mm. */
const APART = 0.01;

export interface LabelFacts {
  readonly storey: Storey;
  readonly planToSheet: Affine;
  readonly unit: DisplayUnit;
  /** The plan on the sheet, mm; what does not fit its room stands around it. */
  readonly extent: Bounds;
  /** What stands there already, mm: the chains of dimensions. */
  readonly taken?: readonly Bounds[];
}

/** A label with the box it takes, mm. */
export interface PlacedLabel {
  readonly items: readonly SheetItem[];
  readonly box: Bounds;
}

/** How a label may be written, best first. */
interface Look {
  readonly size: keyof typeof TEXT_SIZES;
  readonly isUpright: boolean;
  /** mm */
  readonly blank: number;
}

const LOOKS: readonly Look[] = [
  { size: 'room', isUpright: false, blank: BLANK },
  { size: 'label', isUpright: false, blank: BLANK },
  { size: 'label', isUpright: true, blank: BLANK },
];
const NUMBER_LOOKS: readonly Look[] = [
  { size: 'label', isUpright: false, blank: BLANK },
  { size: 'label', isUpright: false, blank: BLANK_AROUND_NUMBER },
  { size: 'label', isUpright: true, blank: BLANK_AROUND_NUMBER },
];

/** So many labels may be led out; of more the lines would hide the plan, and there is a key instead. */
const MOST_LED_OUT = 6;

/** Labels, and what the numbers among them stand for. */
export interface PlacedLabels {
  readonly labels: readonly PlacedLabel[];
  readonly key: readonly KeyEntry[];
}

/**
 * Room names over areas; where no rooms are known, the area within the primary boundary.
 *
 * Each as near to where its room has most space as it fits in, clear of walls and structures, and of furniture where that
 * leaves it a place; smaller, then turned, where it does not fit. What fits in no way stands at the end of a line out of
 * the plan or, where that goes for many, in a key, and the room bears its number there.
 */
export function placeLabels({ storey, planToSheet, unit, extent, taken = [] }: LabelFacts): PlacedLabels {
  const furniture = ringsOf((storey.furniture ?? []).map(({ outline }) => outline)).map((ring) =>
    mapped(ring, planToSheet),
  );
  const rooms = roomsOf(storey, { planToSheet, unit });
  const placed = rooms.map(({ title, words, spaces }) =>
    placeInRoom(spaces, title === '' ? [words] : [title, words], { looks: LOOKS, furniture }),
  );
  const besides = [...taken];
  const lead = (text: string, { spaces }: LabelledRoom): PlacedLabel => {
    const led = leadOut(spaces[0].middle, text, extent, besides);
    besides.push(led.box);
    return led;
  };
  if (placed.filter((label) => label === null).length <= MOST_LED_OUT) {
    return { labels: rooms.map((room, i) => placed[i] ?? lead(onOneLine(room), room)), key: [] };
  }
  const labels = rooms.map((room, i) => {
    if (placed[i] !== null) return placed[i];
    const number = numberOf(room);
    return placeInRoom(room.spaces, [number], { looks: NUMBER_LOOKS, furniture: [] }) ?? lead(number, room);
  });
  const keyed = rooms.filter((_, i) => placed[i] === null);
  return { labels, key: keyed.map((room) => ({ number: numberOf(room), words: onOneLine(room) })) };
}

/** A room, or an area without a name, that has an area to speak of. */
interface LabelledRoom {
  /** Among the storey's. */
  readonly index: number;
  readonly title: string;
  readonly words: string;
  /** The pieces that structures leave of it, the roomiest first; middle and rings in mm on the sheet. */
  readonly spaces: readonly Pick<Space, 'rings' | 'middle'>[];
}

/** As rooms are named that have no name of their own. */
const numberOf = ({ index }: LabelledRoom): string => String(index + 1);

const onOneLine = ({ title, words }: LabelledRoom): string =>
  title === '' ? words : `${isolated(title)}, ${words}`;

function roomsOf(
  storey: Storey,
  { planToSheet, unit }: Pick<LabelFacts, 'planToSheet' | 'unit'>,
): LabelledRoom[] {
  const structures = storey.secondary.map(({ outline }) => outline);
  const rooms =
    storey.rooms.length > 0 ? storey.rooms : storey.primary.map((outline) => ({ name: '', outline }));
  return rooms.flatMap(({ name, outline }, index) => {
    const area = areaOf([outline]);
    if (area === 0) return [];
    const free = combine('difference', [outline], structures);
    const spaces = (free.length > 0 ? free : [outline])
      .map((polygon) => ringsOf([polygon]).map((ring) => mapped(ring, planToSheet)))
      .map((rings) => ({ rings, middle: labelPoint({ outer: rings[0], holes: rings.slice(1) }) }))
      .sort((a, b) => b.middle[2] - a.middle[2]);
    return [{ index, title: drawnName(name), words: formatArea(area, unit), spaces }];
  });
}

/** In the best look that fits, off the furniture where that leaves a place; null where none does. */
function placeInRoom(
  spaces: LabelledRoom['spaces'],
  lines: readonly string[],
  { looks, furniture }: { looks: readonly Look[]; furniture: readonly Ring[] },
): PlacedLabel | null {
  for (const look of looks) {
    for (const keepOff of furniture.length > 0 ? [furniture, []] : [[]]) {
      for (const space of spaces) {
        const placed = placeWithin({ ...space, keepOff }, lines, look);
        if (placed !== null) return placed;
      }
    }
  }
  return null;
}

/** Where a label may stand, mm. */
interface Space {
  readonly rings: readonly Ring[];
  readonly middle: readonly [x: number, y: number, distance: number];
  /** Closed lines that it is not to lie on. */
  readonly keepOff: readonly Ring[];
}

/** At the middle, or the place nearest to it that leaves the box clear. */
function placeWithin(
  { rings, middle: [middleX, middleY], keepOff }: Space,
  lines: readonly string[],
  look: Look,
): PlacedLabel | null {
  const [width, height] = sizeOf(lines, look);
  const boxAt = (x: number, y: number): Bounds => ({
    ...{ minX: x - width / 2, maxX: x + width / 2 },
    ...{ minY: y - height / 2, maxY: y + height / 2 },
  });
  const { minX, minY, maxX, maxY } = boundsOf(rings[0]);
  if (maxX - minX < width || maxY - minY < height) return null;
  let best: readonly [number, number] | null = null;
  const isFree = (box: Bounds) => isClear(rings, box) && !meetsEdges(keepOff, box);
  if (isFree(boxAt(middleX, middleY))) best = [middleX, middleY];
  else {
    let nearest = Infinity;
    for (let i = 0; i < PLACES * PLACES; i++) {
      const x = minX + width / 2 + ((i % PLACES) / (PLACES - 1)) * (maxX - minX - width);
      const y = minY + height / 2 + (Math.floor(i / PLACES) / (PLACES - 1)) * (maxY - minY - height);
      const distance = Math.hypot(x - middleX, y - middleY);
      if (distance < nearest && isFree(boxAt(x, y))) [best, nearest] = [[x, y], distance];
    }
  }
  return best && { items: textsAt(...best, lines, look), box: boxAt(...best) };
}

/** Width and height on the sheet with the blank around, mm. */
function sizeOf(lines: readonly string[], look: Look): [width: number, height: number] {
  const width = Math.max(...lines.map((line, i) => textWidth(line, TEXT_SIZES[sizeOfLine(look, i)])));
  const height = lines.reduce((sum, _, i) => sum + TEXT_SIZES[sizeOfLine(look, i)], 0);
  const [w, h] = [width + 2 * look.blank, height + (lines.length - 1) * LEADING + 2 * look.blank];
  return look.isUpright ? [h, w] : [w, h];
}

/** The area is smaller than the name. */
const sizeOfLine = ({ size }: Look, line: number): Look['size'] => (line === 0 ? size : 'label');

function textsAt(x: number, y: number, lines: readonly string[], look: Look): SheetText[] {
  const [width, height] = sizeOf(lines, look);
  let down = -(look.isUpright ? width : height) / 2 + look.blank;
  return lines.map((text, i) => {
    const size = sizeOfLine(look, i);
    // Capitals are about three quarters of the type size high, and these lines have few descenders.
    const base = down + 0.85 * TEXT_SIZES[size];
    down += TEXT_SIZES[size] + LEADING;
    const place = look.isUpright ? { x: x + base, y, isUpright: true } : { x, y: y + base };
    return { kind: 'text', size, ...place, text, anchor: 'middle' };
  });
}

/** On one line off a side of the plan, beside what stands there, where the line to its room is shortest. */
function leadOut(
  [x, y]: readonly [number, number, number],
  text: string,
  { minX, minY, maxX, maxY }: Bounds,
  others: readonly Bounds[],
): PlacedLabel {
  const sides = [
    { edge: maxY + LED_OUT, isUpright: false },
    { edge: minY - LED_OUT, isUpright: false },
    { edge: minX - LED_OUT, isUpright: true },
    { edge: maxX + LED_OUT, isUpright: true },
  ];
  const leads = sides.map(({ edge, isUpright }) => {
    const look: Look = { size: 'label', isUpright, blank: BLANK };
    const size = sizeOf([text], look);
    const start = isUpright ? ([edge, y] as const) : ([x, edge] as const);
    const box = freeBox(start, size, { along: isUpright ? 1 : 0, others });
    const end = [
      Math.min(Math.max(x, box.minX + BLANK), box.maxX - BLANK),
      Math.min(Math.max(y, box.minY + BLANK), box.maxY - BLANK),
    ] as const;
    return { look, box, end, length: Math.hypot(end[0] - x, end[1] - y) };
  });
  const { look, box, end } = leads.reduce((best, each) => (each.length < best.length ? each : best));
  const line: SheetItem = {
    ...{ kind: 'path', style: 'rule', lines: [Float64Array.of(x, y, ...end)], isClosed: false },
  };
  const [textX, textY] = [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2];
  return { items: [line, ...textsAt(textX, textY, [text], look)], box };
}

/** The box about a place that meets no other: there, or as little to a side as may be. n log n for n others. */
function freeBox(
  [x, y]: readonly [number, number],
  [width, height]: readonly [number, number],
  { along, others }: { along: 0 | 1; others: readonly Bounds[] },
): Bounds {
  const boxAt = (at: number): Bounds => {
    const [midX, midY] = along === 0 ? [at, y] : [x, at];
    return {
      ...{ minX: midX - width / 2, maxX: midX + width / 2 },
      ...{ minY: midY - height / 2, maxY: midY + height / 2 },
    };
  };
  const start = along === 0 ? x : y;
  const row =
    along === 0
      ? { ...boxAt(x), minX: -Infinity, maxX: Infinity }
      : { ...boxAt(y), minY: -Infinity, maxY: Infinity };
  const half = (along === 0 ? width : height) / 2 + APART;
  const blocked = others
    .filter((other) => boundsMeet(row, other))
    .map(({ minX, minY, maxX, maxY }) =>
      along === 0 ? [minX - half, maxX + half] : [minY - half, maxY + half],
    )
    .sort((a, b) => a[0] - b[0]);
  // What is blocked in one run: the first that ends behind the start is the one about it, or there is none.
  let [low, high] = [-Infinity, -Infinity];
  for (const [from, to] of blocked) {
    if (from >= high) {
      if (high > start) break;
      low = from;
    }
    high = Math.max(high, to);
  }
  if (low >= start || high <= start) return boxAt(start);
  return boxAt(start - low < high - start ? low : high);
}
