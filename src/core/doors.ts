import { FloorPlanError } from './errors.ts';
import { readQuantity, unitWords } from './quantity.ts';

/** A door a person cuts by hand ([Stojanovic19] §3). */
export interface DoorCut {
  /** A place on or near the wall: plan frame, source units and source coordinates, as in slice.csv. */
  readonly x: number;
  readonly y: number;
  /** Metres. */
  readonly width: number;
  /** Metres; {@link DOOR_HEIGHT} where none is given. */
  readonly height?: number;
}

/** What the parameter `doors` says. */
export interface Doors {
  /** Every bridged gap as wide as a door or a double door becomes one. */
  readonly gaps: boolean;
  readonly cuts: readonly DoorCut[];
}

/** Clear height of a usual door, m. */
export const DOOR_HEIGHT = 2;
/** Nothing narrower or lower lets anyone through, nothing larger is one door, m. */
const LEAST_SIZE = 0.1;
const MOST_SIZE = 20;

/**
 * Reads `none`, or `gaps` and doors `x,y,width[,height]` in any order, separated by semicolons; the inverse of
 * {@link formatDoors}. Widths and heights are metres, or have a unit: `3.2,0,90cm`.
 *
 * @param pixelsPerMetre null where it is not known: then no size may be in pixels
 * @throws option/invalid naming the entry
 */
export function parseDoors(text: string, pixelsPerMetre: number | null = null): Doors {
  if (text.trim() === 'none') return { gaps: false, cuts: [] };
  let gaps = false;
  const cuts: DoorCut[] = [];
  text.split(';').forEach((entry, i) => {
    if (entry.trim() === 'gaps') gaps = true;
    else cuts.push(parseCut(entry.trim(), i + 1, pixelsPerMetre));
  });
  return { gaps, cuts };
}

/** Writes what {@link parseDoors} reads: `none`, `gaps`, `gaps;3.2,0,0.9`. */
export function formatDoors({ gaps, cuts }: Doors): string {
  const entries = cuts.map(({ x, y, width, height }) =>
    [x, y, width, ...(height === undefined ? [] : [height])].join(','),
  );
  if (gaps) entries.unshift('gaps');
  return entries.length === 0 ? 'none' : entries.join(';');
}

function parseCut(entry: string, number: number, pixelsPerMetre: number | null): DoorCut {
  const fields = entry
    .split(',')
    .map((field, i) => (i < 2 ? readPlace(field) : readSize(field, pixelsPerMetre)));
  const [x, y, width, height] = fields;
  const isComplete = fields.length === 3 || fields.length === 4;
  const isSound = fields.every(Number.isFinite) && fields.slice(2).every(isDoorSize);
  if (!isComplete || !isSound) {
    throw new FloorPlanError(
      'option/invalid',
      `doors: expected entry ${number} to be none, gaps or x,y,width[,height], width and height ${LEAST_SIZE} to ${MOST_SIZE} m, found "${entry}"`,
      {
        hint: `A door is x,y in source coordinates, width and height in metres or with a unit (${unitWords(1)}): 3.2,0,0.9 or 3.2,0,90cm; several are joined by semicolons.`,
        detail: { option: 'doors', entry: number },
      },
    );
  }
  return height === undefined ? { x, y, width } : { x, y, width, height };
}

function readPlace(text: string): number {
  return text.trim() === '' ? Number.NaN : Number(text);
}

function readSize(text: string, pixelsPerMetre: number | null): number {
  const size = readQuantity(text, 1, pixelsPerMetre);
  return size === 'pixels' ? Number.NaN : size;
}

/** Whether a door may be so wide or high. @param size m */
export const isDoorSize = (size: number): boolean => size >= LEAST_SIZE && size <= MOST_SIZE;
