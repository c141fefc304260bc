import { areaOf } from '../core/geometry/areas.ts';
import { decimal } from './decimals.ts';
import type { Product } from './plan-writer.ts';

const DIGITS = 4;

/** Writes rooms.csv: one line a room, lowest storey first; the header alone where no rooms are known. */
export function writeRoomsCsv({ plan }: Product): string {
  const lines = ['name,storey,areaM2,heightM,confidence'];
  for (const { index, rooms } of plan.storeys) {
    for (const { name, outline, height, confidence } of rooms) {
      const numbers = [index, areaOf([outline]), height, confidence].map((value) => decimal(value, DIGITS));
      lines.push([quoted(name), ...numbers].join(','));
    }
  }
  return `${lines.join('\n')}\n`;
}

/** Quotes where RFC 4180 asks for it; an apostrophe keeps spreadsheets from taking a name for a formula. */
function quoted(text: string): string {
  const plain = /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return /[",\r\n]/.test(plain) ? `"${plain.replaceAll('"', '""')}"` : plain;
}
