import { describe, expect, it } from 'vitest';
import { type HeightColumns, heightColumns } from '../../../../src/core/building/columns/height-columns.ts';
import { localCeiling } from '../../../../src/core/building/columns/local-ceiling.ts';
import type { SeenSpace } from '../../../../src/core/building/columns/seen-space.ts';
import { ceilingAcross } from '../../../../src/core/building/faces/ceiling-across.ts';
import { ceilingBehind } from '../../../../src/core/building/faces/ceiling-behind.ts';
import type { Face } from '../../../../src/core/building/faces/face.ts';
import { type FaceSupport, STEP, WALL_SHARE } from '../../../../src/core/building/faces/face-support.ts';
import { blindSide } from '../../../../src/core/building/space/blind-side.ts';
import { findRooms } from '../../../../src/core/building/space/find-rooms.ts';
import { takenSupport } from '../../../../src/core/building/space/taken-walls.ts';
import type { PointCloud, Ring, Vec2 } from '../../../../src/core/types.ts';
import { makeCloud } from '../made-scan.ts';

const [HEIGHT, GRID] = [2.6, 0.025];

/** Points of floors and ceilings over rectangles, and of walls from one place to another. */
class Scan {
  readonly #xyz: number[] = [];

  room(minX: number, minY: number, maxX: number, maxY: number): this {
    for (let x = minX + GRID / 2; x < maxX; x += GRID)
      for (let y = minY + GRID / 2; y < maxY; y += GRID) this.#xyz.push(x, y, 0, x, y, HEIGHT);
    return this;
  }

  wall([ax, ay]: Vec2, [bx, by]: Vec2): this {
    const steps = Math.round(Math.hypot(bx - ax, by - ay) / GRID);
    for (let k = 0; k < steps; k++) {
      const share = (k + 0.5) / steps;
      for (let z = GRID / 2; z < HEIGHT; z += GRID)
        this.#xyz.push(ax + share * (bx - ax), ay + share * (by - ay), z);
    }
    return this;
  }

  walls(...corners: readonly Vec2[]): this {
    for (let k = 1; k < corners.length; k++) this.wall(corners[k - 1], corners[k]);
    return this;
  }

  cloud(): PointCloud {
    return makeCloud(this.#xyz);
  }
}

function columnsOf(cloud: PointCloud): HeightColumns {
  const kept = Uint32Array.from({ length: cloud.positions.length / 3 }, (_, i) => i);
  return heightColumns(cloud, kept, { floor: 0, ceiling: HEIGHT });
}

function roomsOf(scan: Scan): Ring[] {
  const cloud = scan.cloud();
  const columns = columnsOf(cloud);
  const { rooms } = findRooms(cloud, columns, localCeiling(columns));
  return rooms.map(({ outline }) => outline.outer);
}

/** A face along y = 2, its normal up, seen from x = `from` to `to`. */
const faceAlong = (from: number, to: number, noise = 0.004): Face => ({
  nx: 0,
  ny: 1,
  offset: 2,
  from: -to,
  to: -from,
  members: [],
  noise,
  support: 100,
});

function cornersNear(ring: Ring, places: readonly Vec2[]): void {
  for (const [x, y] of places) {
    let least = Infinity;
    for (let i = 0; i < ring.length; i += 2)
      least = Math.min(least, Math.hypot(ring[i] - x, ring[i + 1] - y));
    expect(least).toBeLessThan(0.03);
  }
  expect(ring.length / 2).toBe(places.length);
}

describe('the blind side of a face', () => {
  it('is told across a wall that is hardly thicker than a column', () => {
    const cloud = new Scan().room(0, 0, 4, 2).room(0, 2.07, 4, 4).wall([0, 2], [4, 2]).cloud();
    const site = { cloud, columns: columnsOf(cloud) };
    expect(blindSide(site, faceAlong(0, 4), -3, -1)).toBe(1);
  });

  it('is none where the ceiling goes on', () => {
    const cloud = new Scan().room(0, 0, 4, 4).cloud();
    expect(blindSide({ cloud, columns: columnsOf(cloud) }, faceAlong(0, 4), -3, -1)).toBe(0);
  });
});

describe('the ceiling behind a face', () => {
  const cloud = new Scan().room(0, 0, 4, 2).room(0, 2.15, 4, 4).wall([0, 2], [4, 2]).cloud();
  const columns = columnsOf(cloud);
  const stretch = { from: -3, to: -1, side: 1 } as const;

  it('begins at the other face of its wall', () => {
    const thickest = ceilingBehind(cloud, columns, faceAlong(0, 4), stretch);
    expect(thickest).toBeGreaterThan(0.12);
    expect(thickest).toBeLessThan(0.18);
  });

  it('is not known of a face whose own points reach there, nor where there is none', () => {
    expect(ceilingBehind(cloud, columns, faceAlong(0, 4, 0.03), stretch)).toBe(Infinity);
    const alone = new Scan().room(0, 0, 4, 2).wall([0, 2], [4, 2]).cloud();
    expect(ceilingBehind(alone, columnsOf(alone), faceAlong(0, 4), stretch)).toBe(Infinity);
  });
});

it('the ceiling ends at a pilaster, though it goes on past both its ends', () => {
  const scan = new Scan().room(0, 0, 1.8, 4).room(2.1, 0, 4, 4).room(1.8, 0, 2.1, 2);
  const cloud = scan.wall([1.8, 2], [2.1, 2]).cloud();
  const bits = { from: -4, step: 0.05, count: 80 };
  const across = ceilingAcross(cloud, columnsOf(cloud), faceAlong(1.8, 2.1), bits);
  const [first, last] = [-2.1, -1.8].map((along) => Math.round((along + 4) / 0.05));
  for (let k = first; k < last; k++) expect(across[k]).toBe(0);
  expect(across[first - 8]).toBe(1);
  expect(across[last + 8]).toBe(1);
});

describe('a wall of which one side was seen in part', () => {
  // Two rooms 0.3 m apart, and below them a long one 0.1 m off: the usual wall.
  const storey = () =>
    new Scan()
      .room(0, 0, 4, 5)
      .room(4.3, 0, 8.3, 5)
      .room(0, -3.1, 8.3, -0.1)
      .walls([4, 0], [4, 5], [0, 5], [0, 0], [4, 0])
      .walls([4.3, 0], [8.3, 0], [8.3, 5], [4.3, 5])
      .walls([0, -3.1], [8.3, -3.1], [8.3, -0.1], [0, -0.1], [0, -3.1]);
  const right: Vec2[] = [
    [4.3, 0],
    [8.3, 0],
    [8.3, 5],
    [4.3, 5],
  ];

  it('is as thick where it was not as where it was', () => {
    const rings = roomsOf(storey().wall([4.3, 0], [4.3, 2]));
    expect(rings).toHaveLength(3);
    const ring = rings.find((own) =>
      own.some((x, i) => i % 2 === 0 && Math.abs(x - 8.3) < 0.05 && own[i + 1] > 4),
    );
    cornersNear(ring ?? new Float64Array(0), right);
  });

  it('is no thicker than where the ceiling behind it begins', () => {
    // All inner walls that were seen on both sides are 0.3 m thick, this one 0.1 m.
    const scan = new Scan()
      .room(0, 0, 4, 5)
      .room(4.1, 0, 8.1, 5)
      .room(0, -3.3, 8.1, -0.3)
      .walls([4, 0], [4, 5], [0, 5], [0, 0], [4, 0])
      .walls([4.1, 0], [8.1, 0], [8.1, 5], [4.1, 5])
      .walls([0, -3.3], [8.1, -3.3], [8.1, -0.3], [0, -0.3], [0, -3.3]);
    const rings = roomsOf(scan);
    expect(rings).toHaveLength(3);
    const ring = rings.find((own) =>
      own.some((x, i) => i % 2 === 0 && Math.abs(x - 8.1) < 0.05 && own[i + 1] > 4),
    );
    cornersNear(ring ?? new Float64Array(0), [
      [4.1, 0],
      [8.1, 0],
      [8.1, 5],
      [4.1, 5],
    ]);
  });
});

describe('a face within a room', () => {
  const room: Vec2[] = [
    [0, 0],
    [5, 0],
    [5, 4],
    [0, 4],
    [0, 0],
  ];

  it('that is short is no wall', () => {
    const [ring, ...others] = roomsOf(
      new Scan()
        .room(0, 0, 5, 4)
        .walls(...room)
        .wall([2, 0], [2, 0.5]),
    );
    expect(others).toHaveLength(0);
    cornersNear(ring, room.slice(1));
  });

  it('that is long, and where the ceiling ends, is a stub of wall', () => {
    const scan = new Scan().room(0, 0, 2, 4).room(2.12, 0, 5, 4).room(2, 1.3, 2.12, 4);
    const [ring, ...others] = roomsOf(scan.walls(...room).wall([2, 0], [2, 1.3]));
    expect(others).toHaveLength(0);
    cornersNear(ring, [...room.slice(1), [2, 0], [2, 1.3], [2.12, 1.3], [2.12, 0]]);
  });
});

describe('a gap in a wall', () => {
  /** A face along y = offset that stands where asked, told by x. */
  const standing = (offset: number, stands: (x: number) => boolean) => {
    const face = { ...faceAlong(0, 6), offset };
    const shares = Float64Array.from({ length: 6 / STEP }, (_, k) => (stands(6 - (k + 0.5) * STEP) ? 1 : 0));
    const support: FaceSupport = {
      from: -6,
      step: STEP,
      shares,
      isSeen: new Uint8Array(shares.length).fill(1),
      ceiling: new Float64Array(shares.length).fill(Number.NaN),
    };
    return { face, support };
  };
  const front = standing(2, (x) => x < 2 || x > 3.6);
  const space: SeenSpace = {
    isSeen: new Uint8Array(0),
    isBetween: new Uint8Array(0),
    at: () => true,
    isOpen: () => true,
  };
  const shareInGap = (...walls: readonly ReturnType<typeof standing>[]) => {
    const faces = walls.map(({ face }) => face);
    const supports = walls.map(({ support }) => support);
    const [{ shares }] = takenSupport(faces, supports, space);
    return shares[Math.round((6 - 2.8) / STEP)];
  };

  it('is a passage where nothing stands behind it', () => {
    expect(shareInGap(front)).toBeGreaterThanOrEqual(WALL_SHARE);
    expect(
      shareInGap(
        front,
        standing(2.3, (x) => x < 2 || x > 3.6),
      ),
    ).toBeGreaterThanOrEqual(WALL_SHARE);
  });

  it('is the mouth of a niche where a wall does, with a window in it or none', () => {
    expect(
      shareInGap(
        front,
        standing(2.3, (x) => x > 2 && x < 3.6),
      ),
    ).toBeLessThan(WALL_SHARE);
    const windowed = standing(2.3, (x) => (x > 2 && x < 2.4) || (x > 3.2 && x < 3.6));
    expect(shareInGap(front, windowed)).toBeLessThan(WALL_SHARE);
  });
});
