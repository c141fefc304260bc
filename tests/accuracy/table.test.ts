import { describe, expect, it } from 'vitest';
import { simulate } from '../../fixtures/simulator/index.ts';
import { columnRoomBuilding, homeBuilding } from '../../fixtures/simulator/layouts.ts';
import { sceneFacts } from './classes.ts';
import { formatMeans, meansByClass, type SceneResult } from './table.ts';

const scenes: readonly SceneResult[] = [
  { name: 'a', class: 'clean', measures: { footprintIou: 1, roomF1: 1 }, seconds: 1 },
  { name: 'b', class: 'clean', measures: { footprintIou: 0.9, roomF1: 0.5 }, seconds: 2 },
  { name: 'c', class: 'beyond', measures: null, seconds: 6 },
];

describe('means', () => {
  it('are taken over all scenes and over each class that occurs', () => {
    const means = meansByClass(scenes);
    expect(means.map(({ name, scenes, seconds }) => [name, scenes, seconds])).toEqual([
      ['all', 3, 3],
      ['clean', 2, 1.5],
      ['beyond', 1, 6],
    ]);
    expect(means[1].mean.footprintIou).toBeCloseTo(0.95, 12);
    // A scene without a plan counts as 0.
    expect(means[0].mean.roomF1).toBeCloseTo(0.5, 12);
    expect(means[2].mean.roomF1).toBe(0);
  });

  it('stand in a column a class, without names of scenes', () => {
    const lines = formatMeans(meansByClass(scenes)).split('\n');
    expect(lines[0].split(/ {2,}/)).toEqual(['means', 'all', 'clean', 'beyond']);
    expect(lines.find((line) => line.startsWith('footprint IoU'))?.split(/ {2,}/)).toEqual([
      'footprint IoU',
      '0.633',
      '0.950',
      '0.000',
    ]);
  });
});

describe('classes', () => {
  const scan = { mostRays: 60_000, voxel: 0.05 };
  const factsOf = (noise: number, clutter: number) => {
    const spec = { name: 'home', building: homeBuilding(7, { clutter }), scan: { ...scan, noise } };
    return sceneFacts(spec, simulate(spec).truth);
  };

  it('are written down by noise, furniture and hidden walls', () => {
    const spec = { name: 'room', building: columnRoomBuilding(1), scan: { ...scan, noise: 0.01 } };
    const empty = sceneFacts(spec, simulate(spec).truth);
    expect(empty).toMatchObject({ class: 'clean', furnitureShare: 0, noise: 0.01, scanner: 'static' });
    expect(empty.hiddenShare).toBeLessThan(0.06);
    expect(factsOf(0.02, 0).class).not.toBe('clean');
    expect(factsOf(0.03, 0).class).toBe('beyond');
    const furnished = factsOf(0.005, 1);
    expect(furnished.furnitureShare).toBeGreaterThan(0.2);
    expect(furnished.class).not.toBe('clean');
  });
});
