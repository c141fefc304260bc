import { existsSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { nodeSource } from '../../../src/cli/node-source.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { readAll } from './memory-source.ts';

const pathOf = (relative: string) => fileURLToPath(new URL(`../../../${relative}`, import.meta.url));
const CORNERS = [
  [0, 0, 0],
  [4, 0, 0],
  [4, 3, 0],
  [0, 3, 0],
  [0, 0, 2.5],
  [4, 0, 2.5],
  [4, 3, 2.5],
  [0, 3, 2.5],
];

describe('files as other programs write them', () => {
  it('cloudcompare.txt', async () => {
    const { xyz, colour } = await readAll(await nodeSource(pathOf('fixtures/clouds/cloudcompare.txt')));
    expect(xyz).toEqual(CORNERS);
    expect(colour).toEqual(CORNERS.map((_, i) => [10 * i, 20 * i, 30 * i]));
  });

  it('mesh-tool.ply', async () => {
    const { xyz, colour } = await readAll(await nodeSource(pathOf('fixtures/clouds/mesh-tool.ply')));
    // Its two triangles are the floor; the colours run from corner to corner.
    expect(xyz.length).toBeGreaterThan(1000);
    expect(
      xyz.every(([x, y, z]) => x > -1e-9 && x < 4 + 1e-9 && y > -1e-9 && y < 3 + 1e-9 && Math.abs(z) < 1e-9),
    ).toBe(true);
    expect(
      colour?.every(([r, g, b]) => r <= 30 && Math.abs(g - 2 * r) <= 2 && Math.abs(b - 3 * r) <= 3),
    ).toBe(true);
  });

  it('spreadsheet.csv', async () => {
    const { xyz } = await readAll(await nodeSource(pathOf('fixtures/clouds/spreadsheet.csv')));
    expect(xyz).toEqual(CORNERS);
  });

  it('paper-slice.csv', async () => {
    const { xyz, isSlice } = await readAll(await nodeSource(pathOf('fixtures/clouds/paper-slice.csv')));
    expect(isSlice).toBe(true);
    expect(xyz).toEqual(CORNERS.slice(0, 4).map(([x, y]) => [100 * x, 100 * y, 0]));
  });
});

const SCANS = pathOf('../shared/scans');
const SCENES = pathOf('../shared/scenes');

function filesOf(folder: string): string[] {
  if (!existsSync(folder)) return [];
  return readdirSync(folder)
    .filter((name) => /\.(ply|pcd)$/.test(name))
    .map((name) => `${folder}/${name}`);
}

describe('real scans and scenes', () => {
  const files = [...filesOf(SCANS), ...filesOf(SCENES)];
  if (files.length === 0) it.skip('../shared/scans and ../shared/scenes are not here', () => {});
  it.each(files)('%s', async (path) => {
    const scan = await readScan(await nodeSource(path), resolveOptions({}));
    // All are in metres and hold no bad points; the largest power of two below 1 cm is 7.8 mm.
    expect(scan).toMatchObject({ cellSize: 2 ** -7, isSlice: false, warnings: [] });
    // A single station sees its surroundings far more densely than the working resolution.
    expect(scan.facts.pointsKept).toBeGreaterThan(0.4 * scan.facts.pointsRead);
    expect(scan.positions.every((value) => Math.abs(value) < 60)).toBe(true);
  });
});
