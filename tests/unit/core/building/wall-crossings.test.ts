import { expect, it } from 'vitest';
import { innerWalls } from '../../../../src/core/building/walls/inner-walls.ts';
import { pairFaces, USUAL_THICKNESS } from '../../../../src/core/building/walls/pair-faces.ts';
import { primaryOutline } from '../../../../src/core/building/walls/primary-outline.ts';
import { edgesOf } from '../../../../src/core/building/walls/room-edges.ts';
import { areaOf } from '../../../../src/core/geometry/areas.ts';
import { rectangle, rotated } from '../../solid/plans.ts';

/** Four rooms around a crossing of two walls, the lower one aside by their thickness. */
const ROOMS = [
  rectangle(0, 0, 3, 4),
  rectangle(3.12, 0, 4, 4),
  rectangle(0, 4.12, 3.12, 3),
  rectangle(3.24, 4.12, 3.88, 3),
];
const WHOLE = 7.12 * 7.12 - 12 - 16 - 9.36 - 11.64;

it.each([0, 0.12, 0.31, 0.44, 0.57, 0.83, 1.05, 1.26, 1.4, 1.5])(
  'where walls cross, turned by %f, no bit is a wall of its own',
  (angle) => {
    const rooms = ROOMS.map((outer) => ({ outer: rotated(outer, angle), holes: [] }));
    const pairs = pairFaces(edgesOf(rooms));
    const walls = innerWalls(
      rooms,
      primaryOutline(rooms, USUAL_THICKNESS),
      pairs,
      rooms.map(() => []),
    );
    expect(areaOf(walls.map(({ outline }) => outline))).toBeCloseTo(WHOLE, 3);
    const lengths = walls.map(({ outline, thickness }) => areaOf([outline]) / thickness);
    expect(Math.min(...lengths)).toBeGreaterThan(1);
  },
);
