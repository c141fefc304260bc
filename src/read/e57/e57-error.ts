import { FloorPlanError } from '../../core/errors.ts';

const HINT = 'Export the scan again, or copy it once more.';

/** @param place where: `page`, `offset`, … */
export function malformedE57(
  name: string,
  message: string,
  place: Readonly<Record<string, string | number>> = {},
): FloorPlanError {
  return new FloorPlanError('input/malformed', `${name}: ${message}`, { hint: HINT, detail: place });
}

/** @param expected what the file should still hold @param offset byte at which it ends */
export function truncatedE57(name: string, expected: string, offset: number): FloorPlanError {
  return new FloorPlanError(
    'input/truncated',
    `${name}: expected ${expected}, found the end of the file at byte ${offset}`,
    { hint: 'The file seems cut off; copy or export it again.', detail: { offset } },
  );
}
