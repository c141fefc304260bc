import { describe, expect, it } from 'vitest';
import { powerOfTwoBelow, Thinning } from '../../../src/read/thin/thinning.ts';

function thin(points: readonly (readonly number[])[], cell: number, budget = 1e6): Thinning {
  const thinning = new Thinning({ cell, budget });
  thinning.add({ count: points.length, xyz: Float64Array.from(points.flat()) });
  return thinning;
}

const keptBy = (thinning: Thinning) => thinning.inOrder([0, 0, 0], (length) => new Float64Array(length));

const pointsOf = (thinning: Thinning) => {
  const { positions, count } = keptBy(thinning);
  return Array.from({ length: count }, (_, i) => [...positions.subarray(3 * i, 3 * i + 3)].join()).sort();
};

/** A slanted plane with some depth, far from 0. */
const cloud = (count: number) =>
  Array.from({ length: count }, (_, i) => {
    const [u, v, w] = [(i * 0.618034) % 1, (i * 0.754878) % 1, (i * 0.569841) % 1];
    return [5e5 + 10 * u, 4e6 + 8 * v, u + v + 0.02 * w];
  });

describe('Thinning', () => {
  it('keeps one of the points of every cell', () => {
    const points = cloud(20_000);
    const thinning = thin(points, 0.25);
    const cells = new Set(points.map((point) => point.map((value) => Math.floor(value / 0.25)).join()));
    expect(thinning.count).toBe(cells.size);
    const kept = pointsOf(thinning);
    const all = new Set(points.map((point) => point.join()));
    expect(kept.every((point) => all.has(point))).toBe(true);
    const ofCells = new Set(
      kept.map((point) =>
        point
          .split(',')
          .map((value) => Math.floor(Number(value) / 0.25))
          .join(),
      ),
    );
    expect(ofCells).toEqual(cells);
  });

  it('doubles the cells until the budget is kept', () => {
    const points = cloud(50_000);
    const thinning = thin(points, 2 ** -10, 2_000);
    expect(thinning).toMatchObject({ isOverBudget: true, read: 50_000 });
    expect(thinning.count).toBeLessThanOrEqual(2_000);
    expect(thin(points, thinning.cell / 2).count).toBeGreaterThan(2_000);
    expect(pointsOf(thinning)).toEqual(pointsOf(thin(points, thinning.cell)));
  });

  it('grows', () => {
    const points = cloud(300_000);
    const expected = new Set(points.map((point) => point.map((value) => Math.floor(value * 1024)).join()))
      .size;
    expect(thin(points, 1 / 1024).count).toBe(expected);
  });

  it('keeps every distinct point where there are no cells', () => {
    const points = cloud(1_000);
    expect(pointsOf(thin([...points, ...points], 0))).toEqual(points.map((point) => point.join()).sort());
  });

  it('takes −0 for 0', () => {
    expect(
      thin(
        [
          [-0, 0, 1],
          [0, -0, 1],
        ],
        0,
      ).count,
    ).toBe(1);
  });

  it('finds cells for a cloud without them that is over budget', () => {
    const thinning = thin(cloud(5_000), 0, 1_000);
    expect(thinning.count).toBeLessThanOrEqual(1_000);
    expect(thinning.count).toBeGreaterThan(200);
    expect(Number.isInteger(Math.log2(thinning.cell))).toBe(true);
  });

  it('drops and counts what is no place', () => {
    const bad = [
      [Number.NaN, 0, 0],
      [0, Number.POSITIVE_INFINITY, 0],
      [0, 0, -1e30],
    ];
    const thinning = thin([[1, 2, 3], ...bad, [4, 5, 6]], 1);
    expect(thinning).toMatchObject({
      read: 5,
      dropped: 3,
      count: 2,
      bounds: { min: [1, 2, 3], max: [4, 5, 6] },
    });
  });

  it('keeps attributes beside their points, and of equal points the smaller ones', () => {
    const chunk = (intensities: number[]) => ({
      count: 3,
      xyz: Float64Array.of(1, 1, 1, 1, 1, 1, 9, 9, 9),
      intensity: Float32Array.from(intensities),
      colour: Uint8Array.from([9, 8, 7, 9, 8, 7, 1, 2, 3]),
    });
    for (const intensities of [
      [0.5, 0.25, 1],
      [0.25, 0.5, 1],
    ]) {
      const thinning = new Thinning({ cell: 1, budget: 10 });
      thinning.add(chunk(intensities));
      const { intensity, colour } = keptBy(thinning).attributes;
      expect([...intensity!]).toEqual([0.25, 1]);
      expect([...colour!]).toEqual([9, 8, 7, 1, 2, 3]);
    }
  });

  it('prefers no corner of a cell', () => {
    const inCell = thin(cloud(200_000), 0.5);
    const offset = [0, 0, 0];
    const { positions } = keptBy(inCell);
    for (let i = 0; i < 3 * inCell.count; i++) offset[i % 3] += ((positions[i] / 0.5) % 1) / inCell.count;
    // The mean of n uniform values strays by 0.29 / √n.
    const slack = (4 * 0.29) / Math.sqrt(inCell.count);
    expect(Math.abs(offset[0] - 0.5)).toBeLessThan(slack);
    expect(Math.abs(offset[1] - 0.5)).toBeLessThan(slack);
  });
});

it('finds powers of two', () => {
  expect([1, 1.5, 0.01, 0.0078125, 1000].map(powerOfTwoBelow)).toEqual([1, 1, 2 ** -7, 2 ** -7, 512]);
});

describe('the order of the points kept', () => {
  const cell = 0.25;
  const cellOf = (point: readonly number[]) => point.map((value) => Math.floor(value / cell));
  const byCell = (a: readonly number[], b: readonly number[]) => {
    const [cellA, cellB] = [cellOf(a), cellOf(b)];
    return cellA[2] - cellB[2] || cellA[1] - cellB[1] || cellA[0] - cellB[0];
  };
  const rowsOf = ({ positions, count }: ReturnType<typeof keptBy>) =>
    Array.from({ length: count }, (_, i) => [...positions.subarray(3 * i, 3 * i + 3)]);

  it('is by cell, x fastest, over all blocks and on both sides of zero', () => {
    const points = Array.from({ length: 30_000 }, (_, i) =>
      [0.618034, 0.754878, 0.569841].map((step, axis) => (((i * step) % 1) - 0.4) * [60, 30, 20][axis]),
    );
    const rows = rowsOf(keptBy(thin(points, cell)));
    expect(rows.length).toBeGreaterThan(20_000);
    expect(rows).toEqual(rows.toSorted(byCell));
    expect(new Set(rows.map((row) => cellOf(row).join())).size).toBe(rows.length);
  });

  it('holds far strays, one a block, and carries attributes along', () => {
    const places = Array.from({ length: 3_000 }, (_, i) => [((i * 7919) % 3_000) * 1e6, 1 - i, i % 5]);
    const thinning = new Thinning({ cell, budget: 1e4 });
    thinning.add({
      count: places.length,
      xyz: Float64Array.from(places.flat()),
      station: Uint16Array.from(places, ([x]) => x / 1e6),
      classification: Uint8Array.from(places, ([, , z]) => 250 + z),
    });
    const kept = keptBy(thinning);
    const rows = rowsOf(kept);
    expect(rows).toEqual(places.toSorted(byCell));
    expect([...kept.attributes.station!]).toEqual(rows.map(([x]) => x / 1e6));
    expect([...kept.attributes.classification!]).toEqual(rows.map(([, , z]) => 250 + z));
  });

  it('leaves out what has no place together with its attributes', () => {
    const thinning = new Thinning({ cell, budget: 10 });
    thinning.add({
      count: 3,
      xyz: Float64Array.of(0, 0, 0, Number.NaN, 0, 0, 1, 0, 0),
      intensity: Float32Array.of(0.25, 0.5, 0.75),
    });
    expect([...keptBy(thinning).attributes.intensity!]).toEqual([0.25, 0.75]);
  });
});
