import { describe, expect, it } from 'vitest';
import { findBoundary } from '../../../../src/core/boundary.ts';
import { takeOffNoise } from '../../../../src/core/regularise/take-off-noise.ts';
import type { Ring } from '../../../../src/core/types.ts';
import { expectValidPolygon } from '../../../invariants.ts';
import { areaError, intersectionOverUnion, ringOf } from '../boundary/measures.ts';
import {
  asSlice,
  closed,
  ELL,
  listeningContext,
  optionsWith,
  type Path,
  scanWalls,
} from '../boundary/wall-slices.ts';

const ROUND: Path = Array.from({ length: 180 }, (_, k) => [
  3 * Math.cos((Math.PI * k) / 90),
  3 * Math.sin((Math.PI * k) / 90),
]);
const SQUARE: Path = [
  [0, 0],
  [5, 0],
  [5, 4],
  [0, 4],
];

/** The hull of scanned walls and what is left of it without noise. */
function hullOf(slice: ReturnType<typeof asSlice>): { readonly hull: Ring; readonly found: Ring } {
  const { polygons } = findBoundary(slice, optionsWith(), listeningContext());
  const [found] = takeOffNoise([polygons[0].outer], slice);
  expectValidPolygon({ outer: found, holes: [] });
  expect(found.length).toBe(polygons[0].outer.length);
  return { hull: polygons[0].outer, found };
}

describe('a hull without its noise', () => {
  it.each([
    ['an L', ELL, 0.005],
    ['an L', ELL, 0.01],
    ['an L', ELL, 0.02],
    ['a round wall', ROUND, 0.01],
  ])('of %s keeps an eighth of its error of area and a third of what is not common', (_, path, noise) => {
    const slice = asSlice(scanWalls({ walls: [closed(path)], perMetre: 250, noise, seed: 3 }));
    const { hull, found } = hullOf(slice);
    const truth = ringOf(path);
    expect(areaError(found, truth)).toBeLessThan(areaError(hull, truth) / 8);
    expect(1 - intersectionOverUnion(found, truth)).toBeLessThan(
      (1 - intersectionOverUnion(hull, truth)) / 3,
    );
  });

  it('stands on the outer face where both faces of a wall were seen', () => {
    const outer = SQUARE.map(([x, y]): [number, number] => [
      x + Math.sign(x - 1) * 0.1,
      y + Math.sign(y - 1) * 0.1,
    ]);
    const slice = asSlice(
      scanWalls({ walls: [closed(SQUARE), closed(outer)], perMetre: 250, noise: 0.01, seed: 3 }),
    );
    expect(areaError(hullOf(slice).found, ringOf(outer))).toBeLessThan(0.002);
  });

  it('is the hull where there is no noise, but within millimetres of corners', () => {
    const slice = asSlice(scanWalls({ walls: [closed(SQUARE)], perMetre: 250, noise: 0, seed: 1 }));
    const { hull, found } = hullOf(slice);
    expect(areaError(found, hull)).toBeLessThan(1e-4);
  });

  it('is the hull where there are no points, or none beside it', () => {
    const ring = ringOf(SQUARE);
    const far = { xy: ringOf(SQUARE).map((value) => value + 100), spacing: 0.1 };
    expect(takeOffNoise([ring], { ...far, xy: new Float64Array(0) })).toEqual([ring]);
    expect(takeOffNoise([ring], far)).toEqual([ring]);
  });

  it('leaves the ends of a bridged gap on their walls', () => {
    const gaps = [{ wall: 0, from: 2, to: 3 }];
    const slice = asSlice(scanWalls({ walls: [closed(SQUARE)], perMetre: 250, noise: 0.01, seed: 5, gaps }));
    const { hull, found } = hullOf(slice);
    const truth = ringOf(SQUARE);
    expect(areaError(found, truth)).toBeLessThan(areaError(hull, truth) / 4);
  });
});
