import { areaOf, combine } from '../../core/geometry/areas.ts';
import { type Bounds, boundsMeet, boundsOf, ringsOf } from '../../core/geometry/rings.ts';
import { type Affine, mapped, type SheetItem, type SheetText, TEXT_SIZES } from '../../core/sheet.ts';
import type { Ring, Storey } from '../../core/types.ts';
import { isolated } from './isolated.ts';
import { labelPoint } from './label-point.ts';
import { type DisplayUnit, formatArea } from './measure-words.ts';
import { shorten, textWidth } from './text-width.ts';

/** Blank around a text, mm. */
const BLANK = 1;
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

export interface LabelFacts {
  readonly storey: Storey;
  readonly planToSheet: Affine;
  readonly unit: DisplayUnit;
  /** The plan on the sheet, mm; what does not fit its room stands around it. */
  readonly extent: Bounds;
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
}

const LOOKS: readonly Look[] = [
  { size: 'room', isUpright: false },
  { size: 'label', isUpright: false },
  { size: 'label', isUpright: true },
];

/**
 * Room names over areas; where no rooms are known, the area within the primary boundary.
 *
 * Each as near to where its room has most space as it fits in, clear of walls and structures; smaller, then turned, where
 * it does not fit; at the end of a line out of the plan where it fits in no way.
 */
export function placeLabels({ storey, planToSheet, unit, extent }: LabelFacts): PlacedLabel[] {
  const structures = storey.secondary.map(({ outline }) => outline);
  const rooms =
    storey.rooms.length > 0 ? storey.rooms : storey.primary.map((outline) => ({ name: '', outline }));
  const ledOut: PlacedLabel[] = [];
  return rooms.flatMap(({ name, outline }): PlacedLabel[] => {
    const area = areaOf([outline]);
    if (area === 0) return [];
    const words = formatArea(area, unit);
    const title = drawnName(name);
    const lines = title === '' ? [words] : [title, words];
    const free = combine('difference', [outline], structures);
    const spaces = (free.length > 0 ? free : [outline])
      .map((polygon) => ringsOf([polygon]).map((ring) => mapped(ring, planToSheet)))
      .map((rings) => ({ rings, middle: labelPoint({ outer: rings[0], holes: rings.slice(1) }) }))
      .sort((a, b) => b.middle[2] - a.middle[2]);
    for (const look of LOOKS) {
      for (const { rings, middle } of spaces) {
        const placed = placeWithin(rings, middle, lines, look);
        if (placed !== null) return [placed];
      }
    }
    const line = title === '' ? words : `${isolated(title)}, ${words}`;
    const led = leadOut(spaces[0].middle, line, extent, ledOut);
    ledOut.push(led);
    return [led];
  });
}

/** At the middle, or the place nearest to it that leaves the box clear. */
function placeWithin(
  rings: readonly Ring[],
  [middleX, middleY]: readonly [number, number, number],
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
  if (isClear(rings, boxAt(middleX, middleY))) best = [middleX, middleY];
  else {
    let nearest = Infinity;
    for (let i = 0; i < PLACES * PLACES; i++) {
      const x = minX + width / 2 + ((i % PLACES) / (PLACES - 1)) * (maxX - minX - width);
      const y = minY + height / 2 + (Math.floor(i / PLACES) / (PLACES - 1)) * (maxY - minY - height);
      const distance = Math.hypot(x - middleX, y - middleY);
      if (distance < nearest && isClear(rings, boxAt(x, y))) [best, nearest] = [[x, y], distance];
    }
  }
  return best && { items: textsAt(...best, lines, look), box: boxAt(...best) };
}

/** Width and height on the sheet with the blank around, mm. */
function sizeOf(lines: readonly string[], look: Look): [width: number, height: number] {
  const width = Math.max(...lines.map((line, i) => textWidth(line, TEXT_SIZES[sizeOfLine(look, i)])));
  const height = lines.reduce((sum, _, i) => sum + TEXT_SIZES[sizeOfLine(look, i)], 0);
  const [w, h] = [width + 2 * BLANK, height + (lines.length - 1) * LEADING + 2 * BLANK];
  return look.isUpright ? [h, w] : [w, h];
}

/** The area is smaller than the name. */
const sizeOfLine = ({ size }: Look, line: number): Look['size'] => (line === 0 ? size : 'label');

function textsAt(x: number, y: number, lines: readonly string[], look: Look): SheetText[] {
  const [width, height] = sizeOf(lines, look);
  let down = -(look.isUpright ? width : height) / 2 + BLANK;
  return lines.map((text, i) => {
    const size = sizeOfLine(look, i);
    // Capitals are about three quarters of the type size high, and these lines have few descenders.
    const base = down + 0.85 * TEXT_SIZES[size];
    down += TEXT_SIZES[size] + LEADING;
    const place = look.isUpright ? { x: x + base, y, isUpright: true } : { x, y: y + base };
    return { kind: 'text', size, ...place, text, anchor: 'middle' };
  });
}

/** On one line off the nearest side of the plan, beside those that stand there, with a line to its room. */
function leadOut(
  [x, y]: readonly [number, number, number],
  text: string,
  { minX, minY, maxX, maxY }: Bounds,
  others: readonly PlacedLabel[],
): PlacedLabel {
  const sides = [
    { distance: maxY - y, edge: maxY + LED_OUT, isUpright: false },
    { distance: y - minY, edge: minY - LED_OUT, isUpright: false },
    { distance: x - minX, edge: minX - LED_OUT, isUpright: true },
    { distance: maxX - x, edge: maxX + LED_OUT, isUpright: true },
  ];
  const { edge, isUpright } = sides.reduce((best, each) => (each.distance < best.distance ? each : best));
  const look: Look = { size: 'label', isUpright };
  const [width, height] = sizeOf([text], look);
  for (let i = 0; ; i++) {
    // Where the room is, then to either side, farther and farther.
    const aside = (i % 2 === 0 ? 1 : -1) * Math.ceil(i / 2) * (isUpright ? height : width);
    const [textX, textY] = isUpright ? [edge, y + aside] : [x + aside, edge];
    const box: Bounds = {
      ...{ minX: textX - width / 2, maxX: textX + width / 2 },
      ...{ minY: textY - height / 2, maxY: textY + height / 2 },
    };
    if (others.some((other) => boundsMeet(other.box, box))) continue;
    const end = [
      Math.min(Math.max(x, box.minX + BLANK), box.maxX - BLANK),
      Math.min(Math.max(y, box.minY + BLANK), box.maxY - BLANK),
    ];
    const line: SheetItem = {
      ...{ kind: 'path', style: 'rule', lines: [Float64Array.of(x, y, ...end)], isClosed: false },
    };
    return { items: [line, ...textsAt(textX, textY, [text], look)], box };
  }
}

/** Whether a box lies in a polygon without touching its edges. */
function isClear(rings: readonly Ring[], box: Bounds): boolean {
  const [x, y] = [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2];
  let isInside = false;
  for (const ring of rings) {
    for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      const [ax, ay, bx, by] = [ring[j], ring[j + 1], ring[i], ring[i + 1]];
      if (crosses(ax, ay, bx, by, box)) return false;
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isInside = !isInside;
    }
  }
  return isInside;
}

/** Whether a segment comes into a box: what the sides of the box leave of it [Liang84]. */
function crosses(ax: number, ay: number, bx: number, by: number, box: Bounds): boolean {
  let [low, high] = [0, 1];
  for (const [from, way, least, most] of [
    [ax, bx - ax, box.minX, box.maxX],
    [ay, by - ay, box.minY, box.maxY],
  ]) {
    if (way === 0) {
      if (from <= least || from >= most) return false;
      continue;
    }
    const [first, second] = [(least - from) / way, (most - from) / way];
    low = Math.max(low, Math.min(first, second));
    high = Math.min(high, Math.max(first, second));
  }
  return low < high;
}
