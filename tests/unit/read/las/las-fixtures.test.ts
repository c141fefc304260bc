import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { nodeSource } from '../../../../src/cli/node-source.ts';
import { resolveOptions } from '../../../../src/core/options.ts';
import { openScan } from '../../../../src/read/open-scan.ts';
import { readScan } from '../../../../src/read/read-scan.ts';
import { readAll } from '../memory-source.ts';

const pathOf = (relative: string) => fileURLToPath(new URL(`../../../../${relative}`, import.meta.url));
const fixture = (name: string) => nodeSource(pathOf(`fixtures/foreign/${name}`));

/** The points of make-las.py that are not withheld. */
const INDICES = Array.from({ length: 500 }, (_, i) => i).filter((i) => i % 100 !== 99);
const PLACES = INDICES.map((i) => [
  ((i * 7919) % 4001) * 0.001 + 691_000,
  ((i * 104_729) % 3001) * 0.001 + 5_334_000,
  ((i * 1_299_709) % 2501) * 0.001 + 500,
]);

describe('files of laspy and lazrs', () => {
  it.each([
    ...[0, 3, 8].map((format) => [`format-${format}.las`, format] as const),
    ...[0, 1, 2, 3, 6, 7, 8].map((format) => [`format-${format}.laz`, format] as const),
    ...([1, 6, 9, 10] as const).map((format) => [`chunks-${format}.laz`, format] as const),
    ...([3, 7] as const).map((format) => [`variable-${format}.laz`, format] as const),
  ])('%s', async (name, format) => {
    const all = await readAll(await fixture(name));
    expect(all.xyz).toEqual(PLACES);
    expect(all.classification).toEqual(INDICES.map((i) => i % (format < 6 ? 7 : 40)));
    expect(all.intensity).toEqual(INDICES.map((i) => Math.fround((i * 131) / 65_535)));
    const colour = INDICES.map((i) => [100, 110, 120].map((k) => Math.floor((i * k * 255) / 65_535 + 0.5)));
    expect(all.colour).toEqual([2, 3, 7, 8, 10].includes(format) ? colour : undefined);
  });

  it('tells unit and CRS', async () => {
    const feet = (await openScan([await fixture('format-3.laz')])).cloud;
    expect(feet).toMatchObject({ unit: 'us-ft', crs: 'EPSG:2263', pointsAnnounced: 500, warnings: [] });
    const metres = (await openScan([await fixture('format-7.laz')])).cloud;
    expect(metres).toMatchObject({ unit: 'm', crs: 'EPSG:25832', warnings: [] });
  });
});

describe('indoor.laz', () => {
  const path = pathOf('../shared/scans/indoor.laz');
  it.skipIf(!existsSync(path))('is read whole (skipped where ../shared/scans is not here)', async () => {
    const scan = await readScan(await nodeSource(path), resolveOptions({ unit: 'm' }));
    expect(scan.facts).toMatchObject({ format: 'laz', pointsRead: 808_042, pointsDropped: 0 });
    // The header's own box, in steps of a centimetre.
    const box = [...scan.bounds.min, ...scan.bounds.max];
    [-22.99, -1.97, -7.9, 5.63, 7.55, 12.36].forEach((value, i) => void expect(box[i]).toBeCloseTo(value, 9));
  });
});
