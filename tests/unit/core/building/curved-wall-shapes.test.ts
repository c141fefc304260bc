import { expect, it } from 'vitest';
import { innerWalls } from '../../../../src/core/building/walls/inner-walls.ts';
import { outerWalls } from '../../../../src/core/building/walls/outer-walls.ts';
import { pairFaces } from '../../../../src/core/building/walls/pair-faces.ts';
import { primaryOutline } from '../../../../src/core/building/walls/primary-outline.ts';
import { edgesOf } from '../../../../src/core/building/walls/room-edges.ts';
import { isValid } from '../../../../src/core/building/walls/valid-parts.ts';
import { sidesOf } from '../../../../src/core/building/walls/wall-sides.ts';
import { areaOf } from '../../../../src/core/geometry/areas.ts';
import { withArcs } from '../../../../src/core/geometry/ring-arcs.ts';
import type { Polygon } from '../../../../src/core/types.ts';
import { disc, ring } from '../../solid/plans.ts';

/** A ring along an arc about (0, 0) and on through other places. */
function alongArc(radius: number, [from, to]: readonly [number, number], ...others: number[]): Polygon {
  const count = Math.ceil(Math.abs(to - from) / 0.06);
  const xy = Array.from({ length: count + 1 }, (_, k) => {
    const angle = from + ((to - from) * k) / count;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
  return withArcs({ outer: ring(...xy.flat(), ...others), holes: [] }, [{ cx: 0, cy: 0, radius }]);
}

/** Vertices of a polygon's arcs are on them. */
function radiiOf({ outer, arcs = [] }: Polygon): number[] {
  for (const { from, to, radius } of arcs) {
    const n = outer.length / 2;
    for (let i = from; i !== (to + 1) % n; i = (i + 1) % n)
      expect(Math.hypot(outer[2 * i], outer[2 * i + 1])).toBeCloseTo(radius, 5);
  }
  return arcs.map(({ radius }) => radius).sort((a, b) => a - b);
}

it('a curved outer wall is one wall between two arcs, mitred with those beside it', () => {
  const quarter = alongArc(4, [0, Math.PI / 2], 0, 0);
  expect(sidesOf([quarter]).map(({ edges }) => edges.length)).toEqual([27, 1, 1]);
  const walls = outerWalls([quarter], [0.3, 0.2, 0.2]);
  expect(walls.map(({ side }) => side)).toEqual([0, 1, 2]);
  expect(walls.every(({ outline }) => isValid(outline))).toBe(true);
  expect(radiiOf(walls[0].outline)).toEqual([4, expect.closeTo(4.3, 9)]);
  // Mitres: a quarter of a ring, two strips, and what is beyond the corners.
  const ringArea = (Math.PI / 4) * (4.3 ** 2 - 16);
  const whole = areaOf(walls.map(({ outline }) => outline));
  expect(whole).toBeGreaterThan(ringArea + 2 * 4 * 0.2);
  expect(whole).toBeLessThan(ringArea + 2 * 4.31 * 0.2 + 0.2 ** 2 + 0.01);
});

it('a wall around a hollow bends inwards', () => {
  const hollow = alongArc(3, [Math.PI / 2, 0], 6, 0, 6, 6, 0, 6);
  const [curved] = outerWalls([hollow], [0.4, 0.4, 0.4, 0.4, 0.4]);
  expect(radiiOf(curved.outline)).toEqual([expect.closeTo(2.6, 9), 3]);
});

it('a round building has two outer walls', () => {
  const round = withArcs({ outer: disc(0, 0, 5, 120), holes: [] }, [{ cx: 0, cy: 0, radius: 5 }]);
  const walls = outerWalls([round], [0.3, 0.3]);
  expect(walls).toHaveLength(2);
  expect(areaOf(walls.map(({ outline }) => outline))).toBeCloseTo(Math.PI * (5.3 ** 2 - 25), 1);
  for (const { outline } of walls) expect(radiiOf(outline)).toEqual([5, expect.closeTo(5.3, 9)]);
});

it.each([1, -1])('a curved wall between two rooms is one wall (%i)', (way) => {
  // One room lies within the curve, the other around it; `way` mirrors them.
  const reach: readonly [number, number] = [-0.7, 0.7];
  const turned: readonly [number, number] = [0.7, -0.7];
  const inside = alongArc(6, reach, 0, 3.865, 0, -3.865);
  const outside = alongArc(6.15, turned, 9, -3.962, 9, 3.962);
  const mirrored = ({ outer }: Polygon, radius: number): Polygon => {
    const xy: number[] = [];
    for (let i = outer.length - 2; i >= 0; i -= 2) xy.push(way * outer[i], outer[i + 1]);
    return withArcs({ outer: way > 0 ? outer : ring(...xy), holes: [] }, [{ cx: 0, cy: 0, radius }]);
  };
  const rooms = [mirrored(inside, 6), mirrored(outside, 6.15)];
  const pairs = pairFaces(edgesOf(rooms));
  expect(pairs.length).toBeGreaterThan(10);
  const walls = innerWalls(rooms, primaryOutline(rooms, 0.2), pairs, [[], []]);
  expect(walls).toHaveLength(1);
  expect(walls[0].thickness).toBeCloseTo(0.15, 9);
  expect(isValid(walls[0].outline)).toBe(true);
  expect(radiiOf(walls[0].outline)).toEqual([6, 6.15]);
  expect(areaOf([walls[0].outline])).toBeCloseTo(0.7 * (6.15 ** 2 - 36), 1);
});
