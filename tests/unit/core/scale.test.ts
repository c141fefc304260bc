import { describe, expect, it } from 'vitest';
import { judgeUnit } from '../../../src/core/frame/judge-unit.ts';
import { orient } from '../../../src/core/frame.ts';
import { parseParam, resolveOptions } from '../../../src/core/options.ts';
import type { Scan } from '../../../src/core/types.ts';
import { blobSource } from '../../../src/read/bytes/blob-source.ts';
import { Session } from '../../../src/session/session.ts';
import { listen, makeScan, makeSliceScan, roomPoints } from './made-scan.ts';

/** A unit of photogrammetry: 0.37 m. */
const SCALE = 0.37;
const ROOM = roomPoints();
const SCALED = ROOM.map((value) => value / SCALE);

function run(scan: Scan, given: Parameters<typeof resolveOptions>[0]) {
  const { context, warnings } = listen();
  return { cloud: orient(scan, resolveOptions(given, { isSlice: scan.isSlice }), context), warnings };
}

describe('metresPerUnit', () => {
  it('makes metres, is a unit without a name, and no guess', () => {
    const { cloud, warnings } = run(makeScan(SCALED), { metresPerUnit: SCALE });
    expect(cloud.frame).toMatchObject({ unit: 'custom', metresPerUnit: SCALE });
    expect(cloud.reasons.unit).toBe('1 unit = 0.37 m: the scale was given.');
    expect(warnings.map(({ code }) => code)).not.toContain('frame/unit-guessed');
    const off = cloud.positions.reduce((most, value, i) => Math.max(most, Math.abs(value - ROOM[i])), 0);
    expect(off).toBeLessThan(1e-5);
    expect(cloud.ceiling! - cloud.floor!).toBeCloseTo(2.7, 2);
  });

  it.each([[{ unit: 'mm' as const }], [{ unit: 'px' as const }]])('takes the place of %j', (given) => {
    expect(run(makeScan(SCALED), { ...given, metresPerUnit: SCALE }).cloud.frame.metresPerUnit).toBe(SCALE);
  });

  it('takes the place of what the file states, and scales ready slices', () => {
    const stated = run(makeScan(SCALED, { unit: 'mm' }), { metresPerUnit: SCALE });
    expect(stated.cloud.frame.unit).toBe('custom');
    const slice = run(makeSliceScan([0, 0, 400, 0, 400, 300, 0, 300]), { metresPerUnit: 0.02 });
    expect(slice.cloud.positions[3]).toBeCloseTo(8, 5);
  });

  it('decides how finely a scan is read', () => {
    const options = resolveOptions({ metresPerUnit: SCALE });
    expect(judgeUnit(makeScan(SCALED), options).metresPerUnit).toBe(SCALE);
  });

  it('may be written with a unit', () => {
    expect(parseParam('metresPerUnit', '24mm')).toEqual({ metresPerUnit: 0.024 });
    expect(parseParam('metresPerUnit', 'auto')).toEqual({ metresPerUnit: 'auto' });
    expect(() => resolveOptions({ metresPerUnit: 0 })).toThrow(/metresPerUnit/);
  });
});

describe('a plan of a scan scaled by hand', () => {
  it('has the true area, and every format keeps the source coordinates', async () => {
    const session = new Session();
    const source = Array.from(SCALED, (value, i) => value + [1000, 2000, 30][i % 3]);
    const rows = Array.from({ length: source.length / 3 }, (_, i) => source.slice(3 * i, 3 * i + 3).join());
    const blob = new Blob([`x,y,z\n${rows.join('\n')}\n`]);
    const { plan } = await session.load(blobSource(blob, 'photos.csv'), { metresPerUnit: SCALE });
    const text = async (format: string) => String((await session.write(format))[0].content);

    const geojson = JSON.parse(await text('geojson'));
    expect(geojson.frame).toEqual({ unit: 'custom', metresPerUnit: SCALE });
    const [primary] = geojson.features;
    // The L of 7 × 5 m less 3 × 2 m.
    expect(primary.properties.areaM2).toBeGreaterThan(28);
    expect(primary.properties.areaM2).toBeLessThan(30);
    const xs = primary.geometry.coordinates[0].map(([x]: number[]) => x);
    expect(Math.min(...xs)).toBeCloseTo(1000, 0);
    expect(Math.max(...xs)).toBeCloseTo(1000 + 7 / SCALE, 0);

    expect(await text('dxf')).toMatch(/\$INSUNITS\s+70\s+0\s/);
    expect(JSON.parse(await text('frame'))).toMatchObject({ unit: 'custom', metresPerUnit: SCALE });
    expect(plan.frame.unit).toBe('custom');
    expect(session.result!.stages.find(({ name }) => name === 'frame')!.outcome).toBe(
      'z up, 1 unit = 0.37 m',
    );
  });
});
