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
