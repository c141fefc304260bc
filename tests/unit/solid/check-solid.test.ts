import { expect, test } from 'vitest';
import type { Solid } from '../../../src/core/types.ts';
import { checkSolid } from '../../../src/solid/check-solid.ts';
import { extrude } from '../../../src/solid/extrude.ts';
import { disc, rectangle } from './plans.ts';

const box = (): Solid => {
  const { positions, indices } = extrude({ outer: rectangle(10, 20, 2, 3), holes: [] }, 1, 5);
  return {
    positions,
    indices,
    groups: [{ name: 'wall-0', kind: 'wall', storey: 0, start: 0, count: indices.length }],
  };
};

test('a box has the volume and area of a box', () => {
  expect(checkSolid(box())).toEqual({ watertight: true, volume: 24, area: 2 * 6 + 4 * 10, openEdges: 0 });
});

test('a missing triangle opens three edges', () => {
  const solid = box();
  const opened = { ...solid, groups: [{ ...solid.groups[0], count: solid.indices.length - 3 }] };
  expect(checkSolid(opened)).toMatchObject({ watertight: false, openEdges: 3 });
});

test('a solid turned inside out holds no water', () => {
  const solid = box();
  const inverted = { ...solid, indices: solid.indices.toReversed() };
  expect(checkSolid(inverted)).toMatchObject({ watertight: false, volume: -24, openEdges: 0 });
});

test('a triangle facing the wrong way is noticed', () => {
  const solid = box();
  const indices = solid.indices.slice();
  [indices[0], indices[1]] = [indices[1], indices[0]];
  expect(checkSolid({ ...solid, indices }).watertight).toBe(false);
});

test('an outline of tens of thousands of vertices is raised like any other', () => {
  const { positions, indices } = extrude({ outer: disc(0, 0, 50, 25_000), holes: [] }, 0, 2.5);
  const group = { name: 'wall-0', kind: 'wall', storey: 0, start: 0, count: indices.length } as const;
  const { openEdges, volume } = checkSolid({ positions, indices, groups: [group] });
  expect(openEdges).toBe(0);
  expect(volume).toBeCloseTo(Math.PI * 2500 * 2.5, 0);
});
