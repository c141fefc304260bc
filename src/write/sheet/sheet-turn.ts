import { turnToSquare } from '../../core/geometry/square-turn.ts';
import type { Storey } from '../../core/types.ts';

/** How far a plan is turned to stand square on its sheet, radians counter-clockwise: by outlines and rooms of all storeys. */
export function sheetTurn(storeys: readonly Pick<Storey, 'primary' | 'rooms'>[]): number {
  return turnToSquare(
    storeys.flatMap(({ primary, rooms }) => [...primary, ...rooms.map(({ outline }) => outline)]),
  );
}
