import { describe, expect, it } from 'vitest';
import { type HeightColumns, heightColumns } from '../../../../src/core/building/columns/height-columns.ts';
import { localCeiling } from '../../../../src/core/building/columns/local-ceiling.ts';
import { isClearColumn, seenSpace } from '../../../../src/core/building/columns/seen-space.ts';
import { wallColumns } from '../../../../src/core/building/columns/wall-columns.ts';
import { ceilingAcross } from '../../../../src/core/building/faces/ceiling-across.ts';
import type { Face } from '../../../../src/core/building/faces/face.ts';
import { gapAbove } from '../../../../src/core/building/faces/gap-above.ts';
import type { StoreyHeights } from '../../../../src/core/building/find-storeys.ts';
import { findStoreys } from '../../../../src/core/building/find-storeys.ts';
import type { PointCloud } from '../../../../src/core/types.ts';
import { makeCloud } from '../made-scan.ts';

const STEP = 0.04;

/** Points of level rectangles and upright walls along x, z each its own; metres. */
class Scan {
  readonly #xyz: number[] = [];

  level(z: number, [minX, minY, maxX, maxY]: readonly [number, number, number, number]): this {
    for (let x = minX + STEP / 2; x < maxX; x += STEP)
      for (let y = minY + STEP / 2; y < maxY; y += STEP) this.#xyz.push(x, y, z);
    return this;
  }

  /** A wall along y = `y`. */
  wall(y: number, [minX, maxX]: readonly [number, number], [low, high]: readonly [number, number]): this {
    for (let x = minX + STEP / 2; x < maxX; x += STEP)
      for (let z = low + STEP / 2; z < high; z += STEP) this.#xyz.push(x, y, z);
    return this;
  }

  cloud(): PointCloud {
    return makeCloud(this.#xyz);
  }
}

const all = ({ positions }: PointCloud) => Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
const columnsOf = (cloud: PointCloud, heights: StoreyHeights) => heightColumns(cloud, all(cloud), heights);
const columnAt = ({ table, size }: HeightColumns, x: number, y: number) =>
  table.find(Math.floor(x / size), Math.floor(y / size), 0);

describe('storeys', () => {
  it('are as high as their highest ceiling, however little of it is left above lowered ones', () => {
    const cloud = new Scan().level(0, [0, 0, 6, 6]).level(2.4, [0, 0, 6, 5]).level(2.9, [0, 5, 6, 6]).cloud();
    const [{ floor, ceiling, isOpenAbove }] = findStoreys(cloud, all(cloud));
    expect(floor).toBeCloseTo(0, 2);
    expect(ceiling).toBeCloseTo(2.9, 2);
    expect(isOpenAbove).toBeUndefined();
  });

  it('without a ceiling are as high as their walls', () => {
    const cloud = new Scan()
      .level(0, [0, 0, 6, 6])
      .wall(0, [0, 6], [0, 2.7])
      .wall(6, [0, 6], [0, 2.7])
      .cloud();
    const [storey] = findStoreys(cloud, all(cloud));
    expect(storey).toMatchObject({ isOpenAbove: true });
    expect(storey.ceiling - storey.floor).toBeGreaterThan(2.6);
    expect(storey.ceiling - storey.floor).toBeLessThan(2.8);
  });

  it('are none where nothing stands on the floor, or only furniture', () => {
    const bare = new Scan().level(0, [0, 0, 6, 6]).cloud();
    expect(findStoreys(bare, all(bare))).toEqual([]);
    const low = new Scan().level(0, [0, 0, 6, 6]).wall(0, [0, 6], [0, 1.1]).cloud();
    expect(findStoreys(low, all(low))).toEqual([]);
  });
});

describe('what hangs over a column', () => {
  const heights = { floor: 0, ceiling: 3 };
  const cloud = new Scan()
    .level(0, [0, 0, 8, 4])
    .level(3, [0, 0, 4, 4])
    .level(2.3, [4, 0, 8, 4])
    .level(2.1, [6, 1, 6.6, 1.6])
    .wall(2, [0, 4], [0, 3])
    .cloud();
  const columns = columnsOf(cloud, heights);

  it('is the ceiling of the storey, or a lowered one', () => {
    expect(columns.overhead[columnAt(columns, 2, 1)]).toBeCloseTo(3, 2);
    expect(columns.overhead[columnAt(columns, 5, 3)]).toBeCloseTo(2.3, 2);
    expect(isClearColumn(columns, columnAt(columns, 5, 3))).toBe(true);
  });

  it('is no small surface, as a door head is', () => {
    const small = new Scan().level(0, [0, 0, 4, 4]).level(2.1, [1, 1, 2, 1.3]).cloud();
    const own = columnsOf(small, heights);
    expect(own.overhead[columnAt(own, 1.5, 1.15)]).toBeNaN();
  });

  it('is that of the storey where hardly any of it was seen', () => {
    const far = new Scan().level(0, [0, 0, 4, 4]).level(3, [0, 0, 2, 4]);
    for (let x = 2.1; x < 4; x += 0.2)
      for (let y = 0.1; y < 4; y += 0.2) far.level(3, [x, y, x + 0.03, y + 0.03]);
    const own = columnsOf(far.cloud(), heights);
    expect(own.overhead[columnAt(own, 3.12, 2.12)]).toBe(3);
  });

  it('is none just beside a surface that ends there: a stray point in a wall', () => {
    const room = new Scan().level(0, [0, 0, 4, 4]).level(3, [0, 0, 2, 4]).level(3, [2.1, 2, 2.13, 2.03]);
    const own = columnsOf(room.cloud(), heights);
    expect(own.overhead[columnAt(own, 1.9, 2.02)]).toBe(3);
    expect(own.overhead[columnAt(own, 2.12, 2.02)]).toBeNaN();
  });

  it('is a lowered ceiling over what stands under that, but not over what ends elsewhere', () => {
    const low = new Scan()
      .level(0, [0, 0, 4, 4])
      .level(2.3, [0, 0, 4, 4])
      .wall(1.01, [1, 2], [0, 2.15])
      .wall(2.01, [1, 2], [0, 3])
      .cloud();
    const own = columnsOf(low, heights);
    expect(own.overhead[columnAt(own, 1.5, 1.01)]).toBeCloseTo(2.3, 2);
    expect(own.overhead[columnAt(own, 1.5, 2.01)]).toBeNaN();
  });

  it('is not the top of a wall seen from above, under which there is no space either', () => {
    const model = new Scan()
      .level(0, [0, 0, 14, 4])
      .wall(2, [0, 14], [0, 2.7])
      .wall(2.24, [0, 14], [0, 2.7])
      .level(2.7, [0, 2, 14, 2.24])
      .cloud();
    const own = columnsOf(model, { floor: 0, ceiling: 2.71, isOpenAbove: true });
    const inWall = columnAt(own, 7, 2.12);
    expect(own.overhead[inWall]).toBeNaN();
    expect(isClearColumn(own, inWall)).toBe(false);
    expect(seenSpace(own).isOpen(7, 2.12)).toBe(false);
    expect(seenSpace(own).isOpen(7, 1)).toBe(true);
  });

  it('is no top of a wall where a few points are as high', () => {
    const room = new Scan().level(0, [0, 0, 6, 4]).wall(0, [0, 6], [0, 2.7]).level(2.68, [3, 2, 3.5, 2.5]);
    const own = columnsOf(room.cloud(), { floor: 0, ceiling: 2.71, isOpenAbove: true });
    expect(isClearColumn(own, columnAt(own, 3.2, 2.2))).toBe(true);
  });

  it('does not make a wall of a lowered ceiling, nor hide one that stands below it', () => {
    const isWall = wallColumns(columns, localCeiling(columns));
    expect(isWall[columnAt(columns, 5, 3)]).toBe(0);
    expect(isWall[columnAt(columns, 2, 2)]).toBe(1);
  });
});

describe('the gap above a face', () => {
  const heights = { floor: 0, ceiling: 2.6 };
  const face: Face = { nx: 0, ny: 1, offset: 2, from: -4, to: 0, members: [], noise: 0.005, support: 1 };
  const bits = { from: -4, step: 0.05, count: 80 };
  const gaps = (scan: Scan) => {
    const cloud = scan.cloud();
    const columns = columnsOf(cloud, heights);
    return [...gapAbove({ cloud, columns, ceiling: localCeiling(columns) }, face, bits)];
  };
  const room = () => new Scan().level(0, [0, 0, 4, 4]);

  it('tells a wardrobe from a wall where hardly any of the ceiling behind was seen', () => {
    const ceiled = () => room().level(2.6, [0, 0, 4, 2.05]);
    expect(gaps(ceiled().wall(2, [0, 4], [0, 2.48])).every((gap) => gap === 1)).toBe(true);
    expect(gaps(ceiled().wall(2, [0, 4], [0, 2.6])).every((gap) => gap === 0)).toBe(true);
  });

  it('changes along a wall with a wardrobe in line', () => {
    const found = gaps(
      room().level(2.6, [0, 0, 4, 2.05]).wall(2, [0, 2], [0, 2.6]).wall(2, [2, 4], [0, 2.4]),
    );
    // Along the face is against x.
    expect(found.slice(0, 30).every((gap) => gap === 1)).toBe(true);
    expect(found.slice(50).every((gap) => gap === 0)).toBe(true);
  });

  it('is that below a lowered ceiling too', () => {
    const low = room().level(2.3, [0, 0, 4, 4]).wall(2, [0, 4], [0, 2.15]);
    expect(gaps(low).every((gap) => gap === 1)).toBe(true);
  });

  it('is none where the wall alone was seen, and not known where its points lie in rows as far apart', () => {
    expect(gaps(room().wall(2, [0, 4], [0, 2.4])).every((gap) => gap === 0)).toBe(true);
    const rows = room().level(2.6, [0, 0, 4, 2.05]);
    for (let z = 0; z < 2.5; z += 0.1) rows.wall(2, [0, 4], [z, z + 0.03]);
    expect(gaps(rows).every(Number.isNaN)).toBe(true);
  });
});

describe('the ceiling across a face', () => {
  const heights = { floor: 0, ceiling: 2.6 };
  const face: Face = { nx: 0, ny: 1, offset: 2, from: -4, to: 0, members: [], noise: 0.005, support: 1 };
  const bits = { from: -4, step: 0.05, count: 80 };
  const across = (scan: Scan) => {
    const cloud = scan.cloud();
    return ceilingAcross(cloud, columnsOf(cloud, heights), face, bits);
  };

  it('goes on over a cupboard', () => {
    const scan = new Scan().level(0, [0, 0, 4, 2]).level(2.6, [0, 0, 4, 4]).wall(2, [0, 4], [0, 2.3]);
    for (const share of across(scan)) expect(share).toBe(1);
  });

  it('ends at a wall, whether there is a room behind it or not', () => {
    const before = new Scan().level(0, [0, 0, 4, 2]).level(2.6, [0, 0, 4, 2]).wall(2, [0, 4], [0, 2.6]);
    for (const share of across(before)) expect(share).toBe(0);
    before.level(2.6, [0, 2.12, 4, 4]);
    for (const share of across(before)) expect(share).toBe(0);
  });

  it('is not known where none was seen', () => {
    const scan = new Scan().level(0, [0, 0, 4, 2]).wall(2, [0, 4], [0, 2.6]);
    for (const share of across(scan)) expect(share).toBeNaN();
  });
});

describe('seen space', () => {
  it('marks what lies unseen between places that were seen: a wall, not the outside', () => {
    const cloud = new Scan()
      .level(0, [0, 0, 4, 2])
      .level(0, [0, 2.2, 4, 4])
      .level(2.6, [0, 0, 4, 2])
      .level(2.6, [0, 2.2, 4, 4])
      .wall(2, [0, 4], [0, 2.6])
      .wall(2.2, [0, 4], [0, 2.6])
      .wall(4, [0, 4], [0, 2.6])
      .cloud();
    const columns = columnsOf(cloud, { floor: 0, ceiling: 2.6 });
    const seen = seenSpace(columns);
    expect(seen.isBetween[columnAt(columns, 2, 2)]).toBe(1);
    expect(seen.isBetween[columnAt(columns, 2, 4)]).toBe(0);
    expect(seen.isSeen[columnAt(columns, 2, 1)]).toBe(1);
    expect(seen.isOpen(2, 1)).toBe(true);
    expect(seen.isOpen(2, 2)).toBe(false);
  });
});

it('space beside a thin wall is not in it, though a column reaches that far', () => {
  const rooms = new Scan().level(2.6, [0, 0, 4, 1.96]).level(2.6, [0, 2.028, 4, 4]).level(0, [0, 0, 4, 4]);
  const seen = seenSpace(columnsOf(rooms.cloud(), { floor: 0, ceiling: 2.6 }));
  expect(seen.at(2, 2.02)).toBe(true);
  expect(seen.at(2, 2.02, 0.02)).toBe(false);
  expect(seen.at(2.02, 2.07, 0.03)).toBe(true);
});

describe('the level top of furniture', () => {
  const floor = [
    [0, 0, 6, 1],
    [0, 1, 2, 3],
    [4, 1, 6, 3],
    [0, 3, 6, 4],
  ] as const;
  const room = floor.reduce((scan, part) => scan.level(0, part), new Scan());
  const cloud = room
    .level(0.75, [2, 1, 4, 2.4])
    .level(0.9, [2, 2.7, 4, 2.8])
    .wall(0, [0, 6], [0, 2.7])
    .cloud();
  const seen = seenSpace(columnsOf(cloud, { floor: 0, ceiling: 2.71, isOpenAbove: true }));

  it('shows that no wall stands there, whatever of the floor it hides', () => {
    expect(seen.isOpen(3, 1.7)).toBe(true);
  });

  it('is larger than a sill', () => {
    expect(seen.isOpen(3, 2.75)).toBe(false);
    expect(seen.isOpen(3, 2.55)).toBe(false);
  });
});
