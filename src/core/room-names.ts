import { quoteText } from './cut-text.ts';
import { FloorPlanError } from './errors.ts';

/** What a person calls the room at a place. */
export interface RoomName {
  /** A place in the room: plan frame, source units and source coordinates, as in plan.geojson. */
  readonly x: number;
  readonly y: number;
  /** 0 is the lowest. */
  readonly storey: number;
  readonly name: string;
}

/** In UTF-16 units. */
export const LONGEST_ROOM_NAME = 200;
/** What {@link parseRoomNames} reads, in words. */
export const ROOM_NAME_WORDS = 'x,y[,storey]=Name';

/** Entries end at a semicolon that is not doubled. */
const ENTRY = /((?:;;|[^;])*)(;|$)/g;
/** Line ends and tabs, which no line of a drawing or a table holds. */
const BREAKS = /[\t-\r\u0085\u2028\u2029]+/g;

/** What a room is called until a person names it. @param index among the rooms of its storey, from 0 */
export function automaticName(index: number): string {
  return `Room ${index + 1}`;
}

/**
 * Reads `none`, or names `x,y[,storey]=Name` separated by semicolons; a semicolon in a name is doubled. The inverse of
 * {@link formatRoomNames}. Blanks around a name go, line ends in it become blanks.
 *
 * @throws option/invalid naming the entry
 */
export function parseRoomNames(text: string): readonly RoomName[] {
  if (text.trim() === 'none') return [];
  const names: RoomName[] = [];
  for (const [, entry, end] of text.matchAll(ENTRY)) {
    names.push(parseEntry(entry, names.length + 1));
    if (end === '') break;
  }
  return names;
}

/** Writes what {@link parseRoomNames} reads: `none`, `3.2,1.5=Kitchen;3.2,1.5,1=Bath`. */
export function formatRoomNames(names: readonly RoomName[]): string {
  const entries = names.map(({ x, y, storey, name }) => {
    const place = storey === 0 ? [x, y] : [x, y, storey];
    return `${place.join(',')}=${name.replaceAll(';', ';;')}`;
  });
  return entries.length === 0 ? 'none' : entries.join(';');
}

/** A name on one line, without blanks around it. */
export function tidyName(text: string): string {
  return text.replace(BREAKS, ' ').trim();
}

function parseEntry(entry: string, number: number): RoomName {
  const [place] = entry.split('=', 1);
  const fields = place.split(',').map((field) => (field.trim() === '' ? Number.NaN : Number(field)));
  const [x, y, storey = 0] = fields;
  const name = tidyName(entry.slice(place.length + 1).replaceAll(';;', ';'));
  const isPlace = fields.length <= 3 && [x, y].every(Number.isFinite) && Number.isInteger(storey);
  if (!isPlace || storey < 0 || name === '') throw badEntry(number, ROOM_NAME_WORDS, quoteText(entry));
  if (name.length <= LONGEST_ROOM_NAME) return { x, y, storey, name };
  throw badEntry(number, `a name of at most ${LONGEST_ROOM_NAME} letters`, `${name.length}`);
}

function badEntry(number: number, expected: string, found: string): FloorPlanError {
  const message = `roomNames: expected entry ${number} to be ${expected}, found ${found}`;
  return new FloorPlanError('option/invalid', message, {
    hint: 'x and y are a place in the room in source coordinates, as in plan.geojson; storey 0 is the lowest; entries are joined by semicolons, and one in a name is doubled: 3.2,1.5=Kitchen;7,1.5=Bath;; laundry.',
    detail: { option: 'roomNames', entry: number },
  });
}
