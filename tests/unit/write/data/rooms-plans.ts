import type { Opening, Room } from '../../../../src/core/types.ts';
import { type PlanFacts, rectangle, wallAround } from '../../solid/plans.ts';

/** Names that break a careless writer of CSV, XML or a spreadsheet. */
export const HOSTILE_NAMES = [
  '<script>"&]]> 🏠 غرفة',
  '=1+1',
  '@SUM(A1)',
  'a,"b"\nc',
  '_x0041_ \u0007',
  `${'long '.repeat(7000)}🏠`,
] as const;

const opening = (type: Opening['type'], from: Opening['from'], to: Opening['to']): Opening => ({
  ...{ type, from, to, sill: type === 'window' ? 0.9 : 0, head: 2.1, confidence: 1 },
});

const room = (name: string, x: number, height: number): Room => ({
  ...{ name, outline: { outer: rectangle(x, 0, 3, 4), holes: [] }, height, confidence: 0.875 },
});

/**
 * Two rooms of 3 m × 4 m with a wall of 0.2 m between them, a door in it, a window in the first and a passage out of the
 * second; outer walls of 0.3 m, inferred. As many storeys as pairs of names.
 */
export function twoRooms(...names: readonly (readonly [string, string])[]): PlanFacts {
  const inside = rectangle(0, 0, 6.2, 4);
  const storeys = names.map(([first, second]) => ({
    primary: [{ outer: inside, holes: [] }],
    rooms: [room(first, 0, 2.5), room(second, 3.2, 2.4)],
    walls: [
      { outline: wallAround(inside, 0.3), thickness: 0.3, confidence: 1, isThicknessInferred: true as const },
      { outline: { outer: rectangle(3, 0, 0.2, 4), holes: [] }, thickness: 0.2, confidence: 1 },
    ],
    openings: [
      opening('door', [3.1, 1], [3.1, 1.9]),
      opening('window', [-0.15, 1], [-0.15, 2]),
      opening('passage', [5, 4.15], [5.8, 4.15]),
    ],
  }));
  return { storeys };
}
