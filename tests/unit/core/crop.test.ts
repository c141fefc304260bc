import { describe, expect, it, test } from 'vitest';
import { cropCloud } from '../../../src/core/crop.ts';
import { formatCrop, parseCrop } from '../../../src/core/crop-box.ts';
import { FloorPlanError } from '../../../src/core/errors.ts';
import { orient } from '../../../src/core/frame.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import type { PointCloud, Scan } from '../../../src/core/types.ts';
import { concat, listen, makeScan, makeSliceScan, roomPoints, transform } from './made-scan.ts';

/** An L of 7 × 5 m, 2.7 m high. */
const ROOM = roomPoints();

function orientedScan(scan: Scan, given: Parameters<typeof resolveOptions>[0] = {}): PointCloud {
  return orient(scan, resolveOptions(given, { isSlice: scan.isSlice }), listen().context);
}

function errorOf(act: () => unknown): FloorPlanError {
  try {
    act();
  } catch (error) {
    if (error instanceof FloorPlanError) return error;
    throw error;
  }
  throw new Error('Nothing was thrown.');
}

/** Least and greatest along an axis. */
function range({ positions }: PointCloud, axis: 0 | 1 | 2): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (let i = axis; i < positions.length; i += 3) {
    low = Math.min(low, positions[i]);
    high = Math.max(high, positions[i]);
  }
  return [low, high];
}

describe('the parameter', () => {
  it.each(['none', '0,0,4,3', '-1.5,2,3,1e3', '0,0,4,3,-0.2,2.8', '0,0,4,3@12.5', '0,0,4,3,1,2@-90'])(
    '%s comes back as it was',
    (text) => {
      const box = parseCrop(text);
      expect(parseCrop(formatCrop(box))).toEqual(box);
    },
  );

  it.each([
    '',
    '0,0,4',
    '0,0,4,3,1',
    '0,0,4,3,1,2,3',
    '4,0,0,3',
    '0,3,4,3',
    '0,0,4,3,2,1',
    '0,0,4,x',
    '0,,4,3',
    '0,0,Infinity,3',
    '0,0,4,3@',
    '0,0,4,3@x',
    '0,0,4,3@181',
    '0,0,4,3@1@2',
    '@5',
  ])('refuses "%s"', (text) => {
    expect(errorOf(() => resolveOptions({ crop: text })).code).toBe('option/invalid');
  });
});

describe('the stage', () => {
  it('is the cloud itself without a box, and with one around all of it', () => {
    const cloud = orientedScan(makeScan(ROOM));
    expect(cropCloud(cloud, { crop: 'none' })).toBe(cloud);
    expect(cropCloud(cloud, { crop: '-1,-1,8,6' })).toBe(cloud);
  });

  it('keeps exactly the points in the box, and what is known of each', () => {
    const count = ROOM.length / 3;
    const attributes = {
      colour: Uint8Array.from({ length: 3 * count }, (_, i) => (i / 3) % 251),
      intensity: Float32Array.from({ length: count }, (_, i) => i),
      classification: Uint8Array.from({ length: count }, (_, i) => i % 7),
      station: Uint16Array.from({ length: count }, (_, i) => i % 1000),
    };
    const cloud = orientedScan(makeScan(ROOM, { attributes }));
    const cropped = cropCloud(cloud, { crop: '1,0.5,4,3,0.4,2' });
    const kept: number[] = [];
    for (let i = 0; i < count; i++) {
      const [x, y, z] = cloud.positions.subarray(3 * i, 3 * i + 3);
      if (x >= 1 && x <= 4 && y >= 0.5 && y <= 3 && z >= 0.4 && z <= 2) kept.push(i);
    }
    expect(kept.length).toBeGreaterThan(100);
    expect([...cropped.attributes.intensity!]).toEqual(kept);
    expect([...cropped.attributes.station!]).toEqual(kept.map((i) => i % 1000));
    expect([...cropped.attributes.classification!]).toEqual(kept.map((i) => i % 7));
    expect([...cropped.attributes.colour!]).toEqual(
      kept.flatMap((i) => [3 * i, 3 * i + 1, 3 * i + 2].map((entry) => attributes.colour[entry])),
    );
    expect([...cropped.positions]).toEqual(
      kept.flatMap((i) => [...cloud.positions.subarray(3 * i, 3 * i + 3)]),
    );
  });

  it.each([
    [1, 0],
    [0.001, 5_000_000],
  ])('keeps exactly the points in a turned box: units of %d m, %d from the origin', (metres, far) => {
    const scan = makeScan(
      ROOM.map((value) => value / metres + far),
      { origin: [far, far, far] },
    );
    const cloud = orientedScan(scan, { up: 'z', metresPerUnit: metres });
    const sides = [1, 0.5, 4, 3].map((value) => value / metres + far);
    const cropped = cropCloud(cloud, { crop: `${sides.join(',')}@30` });
    // In the box's own axes through its middle: 30° counter-clockwise.
    const [c, s] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
    let expected = 0;
    for (let i = 0; i < cloud.positions.length; i += 3) {
      const [dx, dy] = [cloud.positions[i] - 2.5, cloud.positions[i + 1] - 1.75];
      if (Math.abs(c * dx + s * dy) <= 1.5 && Math.abs(-s * dx + c * dy) <= 1.25) expected++;
    }
    expect(cropped.positions.length / 3).toBe(expected);
    expect(range(cropped, 0)[1]).toBeGreaterThan(4.2);
  });

  it('takes the box in source units and coordinates: millimetres, y up, far from the origin', () => {
    const [east, height, south] = [691_000_000, 520_000, -5_336_000_000];
    const source = Float64Array.from(
      transform(ROOM, [1000, 0, 0, 0, 0, 1000, 0, -1000, 0]),
      (value, i) => value + [east, height, south][i % 3],
    );
    const scan = makeScan(source, { origin: [east, height, south] });
    const cloud = orientedScan(scan, { up: 'y', unit: 'mm' });
    // Seen from above: (x, −z).
    const crop = `${east + 500},${-south + 1000},${east + 5000},${-south + 4000}`;
    const cropped = cropCloud(cloud, { crop });
    for (const [axis, low, high] of [
      [0, 0.5, 5],
      [1, 1, 4],
    ] as const) {
      const [from, to] = range(cropped, axis);
      expect(from).toBeGreaterThanOrEqual(low - 1e-6);
      expect(from).toBeLessThan(low + 0.06);
      expect(to).toBeLessThanOrEqual(high + 1e-6);
      expect(to).toBeGreaterThan(high - 0.06);
    }
    expect(range(cropCloud(cloud, { crop: `${crop},${height},${height + 1500}` }), 2)[1]).toBeLessThanOrEqual(
      1.5,
    );
  });

  it('finds floor and ceiling of the storey in the box', () => {
    const upper = roomPoints({ floor: 3 });
    const cloud = orientedScan(makeScan(concat(ROOM, upper)));
    const cropped = cropCloud(cloud, { crop: '-1,-1,8,6,2.85,6' });
    expect(cropped.floor).toBeCloseTo(3, 1);
    expect(cropped.ceiling).toBeCloseTo(5.7, 1);
    const lower = cropCloud(cloud, { crop: '-1,-1,8,6,-1,2.85' });
    expect(lower.floor).toBeCloseTo(0, 1);
    expect(lower.ceiling).toBeCloseTo(2.7, 1);
  });

  it('takes what it leaves of one height for a slice', () => {
    const flat = Array.from({ length: 100 }, (_, i) => [i % 10, Math.floor(i / 10), 0]).flat();
    const cloud = orientedScan(makeScan(concat(Float64Array.from(flat), roomPoints({ floor: 1 }))), {
      up: 'z',
    });
    const cropped = cropCloud(cloud, { crop: '-1,-1,20,20,-0.1,0.1' });
    expect(cropped.positions).toHaveLength(300);
    expect(cropped).toMatchObject({ isFlat: true, floor: null, ceiling: null });
  });

  test('a ready slice is cropped too', () => {
    const slice = orientedScan(makeSliceScan([0, 0, 400, 0, 400, 200, 400, 300, 0, 300]), { unit: 'px' });
    expect(cropCloud(slice, { crop: '-1,-1,401,250' }).positions).toHaveLength(9);
  });
});

test.each(['100,100,101,101', '-1,-1,8,6,50,60'])('a box beside the scan, %s, says so', (crop) => {
  const cloud = orientedScan(makeScan(ROOM));
  const error = errorOf(() => cropCloud(cloud, { crop }));
  expect(error.code).toBe('input/too-few-points');
  expect(error.message).toContain(crop);
  expect(error.hint).not.toBe('');
});

test('a box that leaves but a line is refused with a hint at the box', () => {
  const slice = orientedScan(makeSliceScan([0, 0, 1, 0, 2, 0, 3, 0, 3, 3, 0, 3]), { unit: 'm' });
  const error = errorOf(() => cropCloud(slice, { crop: '-1,-1,4,1' }));
  expect(error.code).toBe('input/degenerate');
  expect(error.hint).toMatch(/box/);
});
