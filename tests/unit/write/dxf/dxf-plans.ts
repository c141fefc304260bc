import type { Opening, Room, Storey, Wall } from '../../../../src/core/types.ts';
import { rectangle, rotated } from '../../solid/plans.ts';

/** Plans for the tests of DXF. */

const THICKNESS = 0.2;

/** Two rooms side by side, 4 m and 3 m wide and 3 m deep, with a door, a window and a passage, turned about the origin. */
export function twoRooms(turn = 0, names: readonly [string, string] = ['Kitchen', 'Bath']): Partial<Storey> {
  const area = (x: number, y: number, width: number, depth: number) => ({
    outer: rotated(rectangle(x, y, width, depth), turn),
    holes: [],
  });
  const wall = (x: number, y: number, width: number, depth: number): Wall => ({
    ...{ outline: area(x, y, width, depth), thickness: THICKNESS, confidence: 0.9 },
  });
  const at = (x: number, y: number): readonly [number, number] => {
    const [px, py] = rotated(Float64Array.of(x, y), turn);
    return [px, py];
  };
  const rooms: Room[] = [
    { name: names[0], outline: area(0, 0, 4, 3), height: 2.5, confidence: 1 },
    { name: names[1], outline: area(4.2, 0, 3, 3), height: 2.5, confidence: 1 },
  ];
  const openings: Opening[] = [
    { type: 'door', from: at(4.1, 1), to: at(4.1, 1.9), sill: 0, head: 2, confidence: 0.8 },
    { type: 'window', from: at(1, -0.1), to: at(2.5, -0.1), sill: 0.9, head: 2.1, confidence: 0.7 },
    { type: 'passage', from: at(5, 3.1), to: at(6.2, 3.1), sill: 0, head: 2.3, confidence: 1 },
  ];
  return {
    primary: rooms.map(({ outline }) => outline),
    rooms,
    openings,
    walls: [
      wall(-0.2, -0.2, 7.6, 0.2),
      wall(-0.2, 3, 7.6, 0.2),
      ...[-0.2, 4, 7.2].map((x) => wall(x, 0, 0.2, 3)),
    ],
  };
}
