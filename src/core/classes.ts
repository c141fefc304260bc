import { FloorPlanError } from './errors.ts';

/** ASPRS class codes take a byte. */
export const CLASS_CODES = 256;

/**
 * Reads `all`, or class codes and ranges of them, separated by commas: `2,6`, `1-6`.
 *
 * @returns 1 for each code to keep; null for all
 * @throws option/invalid
 */
export function parseClasses(text: string): Uint8Array | null {
  if (text.trim() === 'all') return null;
  const kept = new Uint8Array(CLASS_CODES);
  for (const entry of text.split(',')) {
    const [, first, last = first] = /^\s*(\d{1,3})\s*(?:-\s*(\d{1,3})\s*)?$/.exec(entry) ?? [];
    if (first === undefined || Number(first) > Number(last) || Number(last) >= CLASS_CODES)
      throw badClasses(entry);
    kept.fill(1, Number(first), Number(last) + 1);
  }
  return kept;
}

function badClasses(entry: string): FloorPlanError {
  return new FloorPlanError(
    'option/invalid',
    `classes: expected all, or class codes from 0 to ${CLASS_CODES - 1} and ranges of them, found "${entry}"`,
    { hint: 'Codes are separated by commas: 2,6 or 1-6.', detail: { option: 'classes' } },
  );
}
