import type { Opening, Polygon, Storey } from '../../../../src/core/types.ts';
import { type PlanFacts, rectangle, ring, secondary } from '../../solid/plans.ts';

/** A building made by hand, for the tests of IFC: every number is known from its drawing. */

const bar = (x: number, y: number, width: number, depth: number): Polygon => ({
  outer: rectangle(x, y, width, depth),
  holes: [],
});

const wall = (outline: Polygon, thickness: number) => ({ outline, thickness, confidence: 0.9 });

const opening = (
  type: Opening['type'],
  [from, to]: readonly [Opening['from'], Opening['to']],
  [sill, head]: readonly [number, number],
): Opening => ({ type, from, to, sill, head, confidence: 0.8 });

/** Two rooms of 4 m × 5 m and 3.8 m × 5 m in walls of 0.3 m, a wall of 0.2 m between them; 2.5 m high. */
export const RECTANGLES = {
  walls: [
    bar(-0.3, -0.3, 8.6, 0.3),
    bar(-0.3, 5, 8.6, 0.3),
    bar(-0.3, 0, 0.3, 5),
    bar(8, 0, 0.3, 5),
    bar(4, 0, 0.2, 2.5),
    bar(4, 2.5, 0.2, 2.5),
  ],
  thicknesses: [0.3, 0.3, 0.3, 0.3, 0.2, 0.2],
} as const;

/**
 * A door through both halves of the wall between the rooms, a window and a passage outwards, a column and a shaft in the rooms.
 *
 * @param names of the two rooms
 */
export function flat(names: readonly [string, string] = ['Kitchen', 'Hall']): Partial<Storey> {
  return {
    primary: [{ outer: rectangle(0, 0, 8, 5), holes: [] }],
    walls: RECTANGLES.walls.map((outline, i) => wall(outline, RECTANGLES.thicknesses[i])),
    rooms: [
      { name: names[0], outline: bar(0, 0, 4, 5), height: 2.4, confidence: 0.75 },
      { name: names[1], outline: bar(4.2, 0, 3.8, 5), height: 2.5, confidence: 1 },
    ],
    openings: [
      opening(
        'door',
        [
          [4.1, 2],
          [4.1, 2.9],
        ],
        [0, 2],
      ),
      opening(
        'window',
        [
          [1, -0.15],
          [2.2, -0.15],
        ],
        [0.9, 2.1],
      ),
      opening(
        'passage',
        [
          [8.15, 1],
          [8.15, 2],
        ],
        [0, 2.5],
      ),
    ],
    secondary: [
      { ...secondary(rectangle(2, 3, 0.4, 0.4), 'independent'), type: 'column' },
      { ...secondary(rectangle(6, 3, 1, 0.5), 'subtract'), type: 'shaft' },
    ],
    gaps: [{ from: [0, 1], to: [0, 1.5], width: 0.5, room: names[0] }],
    furniture: [{ outline: bar(1, 1, 1.2, 0.8), height: 0.75, confidence: 0.6, room: names[0] }],
  };
}

/** At UTM coordinates, with the system's code. */
export const UTM = {
  origin: [691880.1234, 5336026.4321, 520.0007],
  planOrigin: [691880.1234, 5336026.4321, 520.0007],
  crs: 'EPSG:25832',
} as const satisfies PlanFacts['frame'];

/** A ring without area. */
export const FLAT_RING: Polygon = { outer: ring(0, 0, 2, 0, 1, 0), holes: [] };
