import { describe, expect, it } from 'vitest';
import { FloorPlanError } from '../../../src/core/errors.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { type ReadStatus, readScan } from '../../../src/read/read-scan.ts';
import { BAD_INPUTS } from '../../bad-inputs.ts';
import { bytesOf, memorySource } from './memory-source.ts';

const OPTIONS = resolveOptions({});

/** Walls, floor and ceiling of a room of 6 × 4 × 2.5 m, in source units. */
function room(count: number, unit = 1, origin = [0, 0, 0]): number[][] {
  return Array.from({ length: count }, (_, i) => {
    const [u, v] = [(i * 0.618034) % 1, (i * 0.754878) % 1];
    const faces = [
      [6 * u, 4 * v, 0],
      [6 * u, 4 * v, 2.5],
      [6 * u, 0, 2.5 * v],
      [6 * u, 4, 2.5 * v],
      [0, 4 * u, 2.5 * v],
      [6, 4 * u, 2.5 * v],
    ];
    return faces[i % 6].map((value, axis) => value * unit + origin[axis]);
  });
}

const csv = (points: readonly (readonly number[])[]) => points.map((point) => point.join()).join('\n');
function ply(points: readonly (readonly number[])[]): Uint8Array {
  const properties = ['x', 'y', 'z'].map((name) => `property double ${name}\n`).join('');
  const header = bytesOf(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${points.length}\n${properties}end_header\n`,
  );
  return Buffer.concat([header, new Uint8Array(Float64Array.from(points.flat()).buffer)]);
}

describe('readScan', () => {
  it('says that longitudes and latitudes are no plane coordinates, whichever comes first', async () => {
    const [lon, lat] = [6.8e4, 1.113e5];
    const degrees = room(3000).map(([x, y, z]) => [13.4 + x / lon, 52.5 + y / lat, 34 + z]);
    const turned = degrees.map(([x, y, z]) => [y, x, z]);
    for (const points of [degrees, turned]) {
      await expect(readScan(memorySource(csv(points), 'a.xyz'), OPTIONS)).rejects.toMatchObject({
        code: 'input/geographic-coordinates',
        hint: expect.stringContaining('UTM'),
      });
    }
  });

  it('takes no small room for degrees, though a stray point is far above it', async () => {
    const points = [...room(3000, 0.1), [0.1, 0.1, 500]];
    const scan = await readScan(memorySource(csv(points), 'a.xyz'), OPTIONS);
    expect(scan.facts.pointsRead).toBe(3001);
  });

  it('warns of coordinates that 32-bit floats have rounded, and of no others', async () => {
    const codesOf = async (points: number[][]) => {
      const scan = await readScan(memorySource(ply(points), 'room.ply'), OPTIONS);
      return scan.warnings.map(({ code }) => code);
    };
    const far = room(2000, 1, [691_871.31, 5_336_019.17, 500]);
    const rounded = (points: number[][]) => points.map((point) => point.map(Math.fround));
    expect(await codesOf(rounded(far))).toEqual(['read/coarse-coordinates']);
    expect(await codesOf(far)).toEqual([]);
    expect(await codesOf(rounded(room(2000)))).toEqual([]);
    expect(await codesOf(rounded([...room(2000), [1e6, 0, 0]]))).toEqual([]);
  });

  it('thins to the largest power of two within the resolution', async () => {
    const scan = await readScan(
      memorySource(ply(room(60_000)), 'room.ply'),
      resolveOptions({ resolution: 0.05 }),
    );
    expect(scan.cellSize).toBe(2 ** -5);
    expect(scan.facts).toMatchObject({
      name: 'room.ply',
      format: 'ply',
      pointsRead: 60_000,
      pointsDropped: 0,
    });
    expect(scan.facts.pointsKept).toBe(scan.positions.length / 3);
    expect(scan.facts.pointsKept).toBeLessThan(60_000);
    expect(scan.bounds).toEqual({ min: [0, 0, 0], max: [6, 4, 2.5] });
    expect(scan.warnings).toEqual([]);
  });

  it.each([
    ['mm', 1000, 8],
    ['cm', 100, 1],
    ['ft', 1 / 0.3048, 2 ** -5],
  ] as const)('takes the resolution in %s', async (unit, perMetre, cell) => {
    const source = memorySource(ply(room(5_000, perMetre)), 'room.ply');
    expect((await readScan(source, resolveOptions({ unit }))).cellSize).toBe(cell);
    if (unit !== 'ft') expect((await readScan(source, OPTIONS)).cellSize).toBe(cell);
  });

  it('keeps millimetres of large coordinates', async () => {
    const points = room(3_000, 1, [691_000.123, 5_334_000.456, 512.789]);
    const scan = await readScan(memorySource(csv(points), 'utm.csv'), resolveOptions({ resolution: 0.001 }));
    const { positions, origin } = scan;
    expect(positions.length).toBeGreaterThan(6_000);
    for (let i = 0; i < positions.length; i += 3) {
      const isOriginal = points.some((point) =>
        point.every((value, axis) => Math.abs(origin[axis] + positions[i + axis] - value) < 1e-6),
      );
      expect(isOriginal).toBe(true);
    }
  });

  it('reads once more where the first points made the cells too coarse', async () => {
    // One wall of 300 shows no storey and is taken for centimetres; the corridor behind it is in metres.
    const wall = Array.from({ length: 1 << 15 }, (_, i) => [
      (i * 0.618034 * 300) % 300,
      0,
      (i * 0.754878 * 2) % 2,
    ]);
    const corridor = room(60_000).map(([x, y, z]) => [50 * x, y, z]);
    const points = [...wall, ...corridor];
    const statuses: ReadStatus[] = [];
    const options = resolveOptions({ resolution: 0.05 });
    const source = memorySource(ply(points), 'room.ply');
    let readings = 0;
    const counted = {
      ...source,
      stream() {
        readings++;
        return source.stream();
      },
    };
    const scan = await readScan(counted, options, { onProgress: (status) => statuses.push(status) });
    expect(readings).toBe(2);
    const reverse = await readScan(memorySource(ply([...points].reverse()), 'room.ply'), options);
    expect(scan.cellSize).toBe(2 ** -5);
    expect(reverse.cellSize).toBe(scan.cellSize);
    expect(scan.positions).toEqual(reverse.positions);
    // Nobody could foresee it: the second reading waits at the whole.
    expect(new Set(statuses.map(({ totalBytes }) => totalBytes))).toEqual(new Set([source.size]));
    expect(statuses.at(-1)?.bytesRead).toBe(source.size);
  });

  it('reads once more where the first points made the cells too fine to be told apart', async () => {
    // A model of the room in metres lies in front of two rooms in millimetres, 2²¹ cells of the model's from each other.
    const rooms = room(20_000, 1000).flatMap(([x, y, z]) => [
      [x, y, z],
      [x + 2 ** 14, y, z],
    ]);
    const source = memorySource(ply([...room(1 << 15), ...rooms]), 'rooms.ply');
    const scan = await readScan(source, OPTIONS);
    const told = await readScan(source, resolveOptions({ unit: 'mm' }));
    expect(scan.cellSize).toBe(8);
    expect(scan.positions).toEqual(told.positions);
  });

  it('warns where the budget coarsens', async () => {
    const options = resolveOptions({ pointBudget: 2_000 });
    const scan = await readScan(memorySource(ply(room(50_000)), 'room.ply'), options);
    expect(scan.facts.pointsKept).toBeLessThanOrEqual(2_000);
    expect(scan.warnings).toMatchObject([{ code: 'read/thinned-to-budget' }]);
    expect(scan.warnings[0].message).toContain(String(scan.cellSize));
  });

  it('does not warn where the budget coarsened no further than the resolution', async () => {
    const options = resolveOptions({ resolution: 0.25, pointBudget: 3_000, unit: 'm' });
    const scan = await readScan(memorySource(ply(room(50_000)), 'room.ply'), options);
    expect(scan).toMatchObject({ cellSize: 0.25, warnings: [] });
  });

  it('keeps every distinct point of a slice', async () => {
    const slice = room(2_000, 0.001).map(([x, y]) => [x, y]);
    const distinct = new Set(slice.map((point) => point.join())).size;
    const scan = await readScan(memorySource(`x,y\n${csv([...slice, ...slice])}`, 'slice.csv'), OPTIONS);
    expect(scan).toMatchObject({ isSlice: true, cellSize: 0, facts: { pointsKept: distinct } });
    expect(scan.positions.filter((_, i) => i % 3 === 2).every((z) => z === 0)).toBe(true);
  });

  it('leaves points without a place out and says so', async () => {
    const points = [...room(2_000), [Number.NaN, 1, 2], [1, Number.POSITIVE_INFINITY, 2]];
    const scan = await readScan(memorySource(ply(points), 'room.ply'), OPTIONS);
    expect(scan.facts).toMatchObject({ pointsRead: 2_002, pointsDropped: 2 });
    expect(scan.warnings).toMatchObject([
      { code: 'read/points-dropped', message: expect.stringContaining('2 of 2,002 points') },
    ]);
  });

  it('survives strays', async () => {
    const strays = [
      [9e11, 0, 0],
      [0, -9e11, 5],
      [-1e6, 1e6, 1e6],
    ];
    const scan = await readScan(
      memorySource(ply([...room(3_000), ...strays]), 'room.ply'),
      resolveOptions({ unit: 'm' }),
    );
    expect(scan.origin.every((value) => Math.abs(value) < 10)).toBe(true);
    expect(scan.facts.pointsKept).toBeGreaterThan(2_900);
  });

  it('shows progress and a preview', async () => {
    const points = room(100_000, 1, [1000, 2000, 0]);
    const source = memorySource(ply(points), 'room.ply');
    const statuses: ReadStatus[] = [];
    const previews: Float32Array[] = [];
    await readScan(source, OPTIONS, {
      onProgress: (status) => statuses.push(status),
      onPreview: (positions) => previews.push(positions),
    });
    expect(statuses.at(-1)).toEqual({ bytesRead: source.size, totalBytes: source.size, points: 100_000 });
    expect(statuses.every(({ bytesRead }, i) => i === 0 || bytesRead >= statuses[i - 1].bytesRead)).toBe(
      true,
    );
    const shown = previews.reduce((sum, { length }) => sum + length / 3, 0);
    expect(shown).toBeGreaterThan(4_000);
    expect(previews.every((positions) => positions.length <= 3 * 4096)).toBe(true);
    expect([...previews[0].subarray(0, 3)]).toEqual([0, 0, 0]);
    expect(previews.every((positions) => positions.every((value) => Math.abs(value) <= 6))).toBe(true);
  });

  it('stops when cancelled and closes the source', async () => {
    const controller = new AbortController();
    let isClosed = false;
    const memory = memorySource(ply(room(50_000)), 'room.ply', [10_000]);
    const source = {
      ...memory,
      async *stream() {
        try {
          yield* memory.stream();
        } finally {
          isClosed = true;
        }
      },
    };
    const reading = readScan(source, OPTIONS, {
      signal: controller.signal,
      onProgress: ({ bytesRead }) => bytesRead > 100_000 && controller.abort(),
    });
    await expect(reading).rejects.toMatchObject({ code: 'cancelled' });
    expect(isClosed).toBe(true);
  });
});

describe('bad input', () => {
  it.each(BAD_INPUTS)('$name: $code', async ({ name, bytes, code, says }) => {
    const error = await readScan(memorySource(bytes, name), OPTIONS).catch((reason: unknown) => reason);
    expect(error).toBeInstanceOf(FloorPlanError);
    expect(error).toMatchObject({ code, message: expect.stringMatching(says) });
    expect((error as FloorPlanError).hint).not.toBe('');
  });
});
