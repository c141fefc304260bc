import { decimal } from '../decimals.ts';
import type { Product } from '../plan-writer.ts';
import { roomLines } from './room-schedule.ts';

const DIGITS = 4;
/** Columns stay where they are: new ones come at the end. */
const NUMBERS = [
  'storey',
  'areaM2',
  'heightM',
  'confidence',
  'number',
  'perimeterM',
  'volumeM3',
  'doors',
  'windows',
  'passages',
] as const;

/**
 * Writes rooms.csv: one line a room, lowest storey first; the header alone where no rooms are known. Without totals, so that
 * every line is a room: those are in rooms.xlsx.
 */
export function writeRoomsCsv({ plan }: Pick<Product, 'plan'>): string {
  const lines = roomLines(plan).map((room) =>
    [quoted(room.name), ...NUMBERS.map((key) => decimal(room[key], DIGITS))].join(','),
  );
  return `${[['name', ...NUMBERS].join(','), ...lines].join('\n')}\n`;
}

/** Quotes where RFC 4180 asks for it; an apostrophe keeps spreadsheets from taking a name for a formula. */
function quoted(text: string): string {
  const plain = /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return /[",\r\n]/.test(plain) ? `"${plain.replaceAll('"', '""')}"` : plain;
}
