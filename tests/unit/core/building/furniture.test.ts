import { beforeAll, describe, expect, it } from 'vitest';
import { simulate, writePly } from '../../../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../../../fixtures/simulator/layouts.ts';
import { createStrokeTest } from '../../../../src/cli/canvas-stroke.ts';
import { areaOf, combine } from '../../../../src/core/geometry/areas.ts';
import { boundsOf } from '../../../../src/core/geometry/rings.ts';
import type { Polygon } from '../../../../src/core/types.ts';
import { blobSource } from '../../../../src/read/bytes/blob-source.ts';
import { Session } from '../../../../src/session/session.ts';
import { expectValidPolygons } from '../../../invariants.ts';
import { FurnishedRoom } from './furnished-room.ts';

const boundsOfOutlines = (found: readonly { readonly outline: Polygon }[]) =>
  found.map(({ outline }) => {
    const { minX, minY, maxX, maxY } = boundsOf(outline.outer);
    return [minX, minY, maxX, maxY];
  });

/** To 4 cm: less than a column. */
function expectBounds(actual: readonly number[], expected: readonly number[]): void {
  expected.forEach((value, i) => {
    expect(Math.abs(actual[i] - value)).toBeLessThan(0.04);
  });
}

describe('what stands in a room', () => {
  it('is a table and a chair, by their tops', () => {
    const { found } = new FurnishedRoom()
      .table([1.5, 1.2, 3.1, 2], 0.74)
      .table([2, 2.6, 2.45, 3.05], 0.45)
      .face([2, 3.04], [2.45, 3.04], [0.45, 0.9])
      .furniture();
    const [chair, table] = [...found].sort((a, b) => areaOf([a.outline]) - areaOf([b.outline]));
    expect(found).toHaveLength(2);
    expectBounds(boundsOfOutlines([table])[0], [1.5, 1.2, 3.1, 2]);
    expectBounds(boundsOfOutlines([chair])[0], [2, 2.6, 2.45, 3.05]);
    expect(table.outline.outer).toHaveLength(8);
    expect(table.height).toBeCloseTo(0.74, 2);
    expect(chair.height).toBeGreaterThan(0.8);
    for (const { confidence, room } of found) {
      expect(confidence).toBeGreaterThan(0.9);
      expect(room).toBe('Room 1');
    }
  });

  it('is a tall cupboard up to the wall behind it, whose top and back nobody saw', () => {
    const { found } = new FurnishedRoom()
      .face([1, 3.4], [2.8, 3.4], [0, 2.1])
      .face([1, 3.4], [1, 3.98], [0, 2.1])
      .face([2.8, 3.4], [2.8, 3.98], [0, 2.1])
      .hide([1, 3.4, 2.8, 4])
      .furniture();
    expect(found).toHaveLength(1);
    expectBounds(boundsOfOutlines(found)[0], [1, 3.4, 2.8, 4]);
    expect(found[0].height).toBeCloseTo(2.1, 1);
    expect(found[0].confidence).toBeGreaterThan(0.5);
    expect(found[0].confidence).toBeLessThan(1);
  });

  it('keeps its right angles where it is no box', () => {
    const { found } = new FurnishedRoom()
      .level(0.9, [1, 1, 3.4, 1.6])
      .level(0.9, [1, 1.6, 1.6, 2.8])
      .furniture();
    expect(found).toHaveLength(1);
    expect(found[0].outline.outer).toHaveLength(12);
    expect(Math.abs(areaOf([found[0].outline]) - 2.16)).toBeLessThan(0.15);
  });

  it('leaves the floor within a ring of tables', () => {
    const { found } = new FurnishedRoom()
      .level(0.74, [1, 1, 4, 1.6])
      .level(0.74, [1, 2.6, 4, 3.2])
      .level(0.74, [1, 1.6, 1.6, 2.6])
      .level(0.74, [3.4, 1.6, 4, 2.6])
      .furniture();
    expect(found).toHaveLength(1);
    expect(found[0].outline.holes).toHaveLength(1);
    expect(Math.abs(areaOf([found[0].outline]) - 4.8)).toBeLessThan(0.2);
  });

  it('stands askew where it does', () => {
    const { found } = new FurnishedRoom().table([1.5, 1.2, 3.1, 2], 0.74).furniture(0.3);
    expect(found).toHaveLength(1);
    expect(areaOf([found[0].outline])).toBeCloseTo(1.28, 1);
  });

  it('is no wall, no carpet, no lamp, no door leaf, no piece of wall', () => {
    const { found } = new FurnishedRoom()
      .level(0.03, [1, 1, 3, 3])
      .level(2, [2, 2, 2.4, 2.4])
      .sides([4.2, 0.3, 4.24, 1.1], [0, 2])
      .sides([3.2, 3.2, 3.3, 4], [0, FurnishedRoom.HEIGHT])
      .furniture();
    expect(found).toEqual([]);
  });
});

describe('the furniture of a plan', () => {
  const building = homeBuilding(42);
  let session: Session;
  beforeAll(async () => {
    const { positions } = simulate({ name: 'home', building, scan: { voxel: 0.04, raysPerStation: 60_000 } });
    session = new Session({ strokeTest: createStrokeTest() });
    await session.load(blobSource(new Blob([writePly({ positions })]), 'home.ply'));
  });

  it('is absent unless asked for', async () => {
    const { plan } = await session.update({});
    for (const storey of plan.storeys) expect('furniture' in storey).toBe(false);
  });

  it('is what was put into the rooms, each thing in its own', async () => {
    const { plan } = await session.update({ furniture: true });
    const [{ furniture = [], rooms }] = plan.storeys;
    expectValidPolygons(furniture.map(({ outline }) => outline));
    for (const { outline, room } of furniture) {
      const own = rooms.find(({ name }) => name === room)!;
      expect(areaOf(combine('difference', [outline], [own.outline]))).toBeLessThan(1e-5);
    }
    const [dx, dy] = plan.frame.planOrigin;
    const truth = building.storeys[0].furniture.map(
      ({ ring }): Polygon => ({
        outer: Float64Array.from(ring.flatMap(([x, y]) => [x - dx, y - dy])),
        holes: [],
      }),
    );
    const found = furniture.map(({ outline }) => outline);
    const right = areaOf(combine('intersection', found, truth));
    expect(right / areaOf(combine('union', found))).toBeGreaterThan(0.8);
    expect(right / areaOf(combine('union', truth))).toBeGreaterThan(0.7);
  });
});
