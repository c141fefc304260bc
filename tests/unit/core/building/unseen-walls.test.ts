import { describe, expect, it } from 'vitest';
import { heightColumns } from '../../../../src/core/building/columns/height-columns.ts';
import { localCeiling } from '../../../../src/core/building/columns/local-ceiling.ts';
import type { SeenSpace } from '../../../../src/core/building/columns/seen-space.ts';
import type { Face } from '../../../../src/core/building/faces/face.ts';
import { type FaceSupport, STEP, WALL_SHARE } from '../../../../src/core/building/faces/face-support.ts';
import { findRooms } from '../../../../src/core/building/space/find-rooms.ts';
import { usualThickness } from '../../../../src/core/building/space/missing-backs.ts';
import { takenSupport } from '../../../../src/core/building/space/taken-walls.ts';
import { withCorners } from '../../../../src/core/building/space/wall-corners.ts';
import type { Ring, Vec2 } from '../../../../src/core/types.ts';
import { makeCloud } from '../made-scan.ts';

/** A face along y = offset (normal up) or x = offset, seen from `from` to `to` of 10 m. */
function wall(normal: 'x' | 'y', offset: number, from: number, to: number) {
  const [nx, ny] = normal === 'x' ? [1, 0] : [0, 1];
  // Places along a line run against x where its normal is y.
  const [low, high] = normal === 'x' ? [from, to] : [-to, -from];
  const face: Face = { nx, ny, offset, from: low, to: high, members: [0], noise: 0.005, support: 100 };
  const begin = normal === 'x' ? 0 : -10;
  const shares = Float64Array.from({ length: Math.round(10 / STEP) }, (_, k) => {
    const along = begin + (k + 0.5) * STEP;
    return along > low && along < high ? 1 : 0;
  });
  const own: FaceSupport = {
    from: begin,
    step: STEP,
    shares,
    isSeen: new Uint8Array(shares.length).fill(1),
    ceiling: new Float64Array(shares.length).fill(Number.NaN),
  };
  return { face, own };
}

/** How far the first wall stands once corners are taken, x or y, m. */
function endOf(walls: ReturnType<typeof wall>[], isOpen: SeenSpace['isOpen'], at = isOpen): number {
  const own = walls.map((each) => each.own);
  const none = new Uint8Array(0);
  const seen: SeenSpace = { isSeen: none, isBetween: none, at, isOpen };
  const [{ from, shares }] = withCorners(
    walls.map(({ face }) => face),
    own,
    own,
    seen,
  );
  const stands = [...shares.keys()].filter((k) => shares[k] >= WALL_SHARE);
  return from < 0 ? -(from + stands[0] * STEP) : from + (stands[stands.length - 1] + 1) * STEP;
}

describe('a wall that ends short of another', () => {
  const outer = wall('x', 6, 0, 8);

  it('goes on to it where nothing was seen', () => {
    expect(endOf([wall('y', 4, 2, 5), outer], () => false)).toBeCloseTo(6, 1);
  });

  it('goes on where space was seen on one side of its line only', () => {
    expect(endOf([wall('y', 4, 2, 5), outer], (_, y) => y < 4.02)).toBeCloseTo(6, 1);
  });

  it('ends where space goes on across its line', () => {
    expect(endOf([wall('y', 4, 2, 5), outer], () => true)).toBeCloseTo(5, 1);
  });

  it('goes on no farther than it is known to stand', () => {
    expect(endOf([wall('y', 4, 4.2, 5), outer], (_, y) => y < 3.8)).toBeCloseTo(5, 1);
  });

  it('goes on farther deep in what is hidden, unless another wall was seen there', () => {
    const [stub, far] = [wall('y', 4, 4.2, 5), wall('x', 7, 0, 8)];
    const betweenCupboards: SeenSpace['at'] = (_, y) => Math.abs(y - 4) > 0.4;
    expect(endOf([stub, far], betweenCupboards)).toBeCloseTo(7, 1);
    expect(endOf([stub, far, wall('y', 4.2, 5.2, 7)], betweenCupboards)).toBeCloseTo(5, 1);
    // What stands over less of it is a cupboard's side, or its front.
    expect(endOf([stub, far, wall('y', 4.2, 6.2, 7)], betweenCupboards)).toBeCloseTo(7, 1);
  });

  it('ends where another passes by on both sides: beyond is a corridor', () => {
    const corridor = wall('x', 5, 0, 8);
    expect(endOf([wall('y', 4, 2, 5), corridor, outer], () => false)).toBeCloseTo(5, 1);
    // One that ends there hides what is behind it.
    expect(endOf([wall('y', 4, 2, 5), wall('x', 5, 0, 3.9), outer], () => false)).toBeCloseTo(6, 1);
  });

  it('that meets one face of a wall does not go on to its other', () => {
    expect(endOf([wall('y', 4, 2, 5.9), wall('x', 5.9, 0, 8), outer], () => false)).toBeCloseTo(5.9, 1);
  });
});

describe('a gap of a wall where a corridor leads off', () => {
  const [begin, end] = [3, 5];
  const before = wall('y', 4, 1, begin);
  const after = wall('y', 4, end, 7);
  const whole = {
    face: { ...before.face, from: after.face.from },
    own: { ...before.own, shares: before.own.shares.map((share, k) => Math.max(share, after.own.shares[k])) },
  };
  const walls = [whole, wall('x', begin, 4, 8), wall('x', end, 4, 8)];

  function isTakenAt(x: number, isOpen: SeenSpace['isOpen']): boolean {
    const none = new Uint8Array(0);
    const [{ from, shares }] = takenSupport(
      walls.map(({ face }) => face),
      walls.map(({ own }) => own),
      { isSeen: none, isBetween: none, at: isOpen, isOpen },
    );
    return shares[Math.floor((-x - from) / STEP)] >= WALL_SHARE;
  }

  /** Rows of a scanner far off: a third of the places. */
  const inRow = (x: number) => Math.floor(10 * x) % 3 === 0;

  it('stays open where as little of its line was seen as of what is beside', () => {
    expect(isTakenAt(4, (x) => inRow(x))).toBe(false);
  });

  it('is a wall where the same rows end at its line', () => {
    expect(isTakenAt(4, (x, y) => inRow(x) && Math.abs(y - 4) > 0.1)).toBe(true);
  });

  it('is a wall where a cupboard hides half of it', () => {
    expect(isTakenAt(4, (x) => inRow(x) && x > 4)).toBe(true);
  });
});

describe('a gap of a wall', () => {
  const bothOf = (a: ReturnType<typeof wall>, b: ReturnType<typeof wall>) => {
    const shares = a.own.shares.map((share, k) => Math.max(share, b.own.shares[k]));
    const own = { ...a.own, shares, isSeen: Uint8Array.from(shares) };
    return { face: { ...a.face, from: b.face.from }, own };
  };

  /** Whether the first wall is taken to stand at x = 4. */
  function isTaken(walls: ReturnType<typeof wall>[], at: SeenSpace['at'], isOpen = at): boolean {
    const none = new Uint8Array(0);
    const [{ from, shares }] = takenSupport(
      walls.map(({ face }) => face),
      walls.map(({ own }) => own),
      { isSeen: none, isBetween: none, at, isOpen },
    );
    return shares[Math.floor((-4 - from) / STEP)] >= WALL_SHARE;
  }

  it('that a corridor crosses stays open where its floor was seen, though no ceiling was on the very line', () => {
    const walls = [
      bothOf(wall('y', 4, 1, 3), wall('y', 4, 5.8, 8)),
      wall('x', 3.3, 0, 8),
      wall('x', 5, 0, 8),
    ];
    const isUnseen = () => false;
    expect(isTaken(walls, isUnseen, (x) => x > 3.3 && x < 5)).toBe(false);
    expect(isTaken(walls, isUnseen, (x) => x > 4.6 && x < 5)).toBe(true);
  });

  it('behind which a wall was seen is no wall, but where a room is behind: one face of a thin one', () => {
    const walls = [bothOf(wall('y', 4, 1, 3), wall('y', 4, 5, 8)), wall('y', 4.06, 3, 5)];
    expect(isTaken(walls, (_, y) => y < 3.95)).toBe(false);
    expect(isTaken(walls, (_, y) => y < 3.95 || y > 4.1)).toBe(true);
  });
});

describe('a wall of which one face was seen', () => {
  // Its other face is one of two lines: one stands near by over much, one far off over little.
  const walls = [wall('y', 4, 0, 1), wall('y', 4.19, 5, 9.5), wall('y', 4.36, 0, 10)];
  const none = new Uint8Array(0);
  const isBeyond: SeenSpace['at'] = (_, y) => y > 4.4;
  const taken = takenSupport(
    walls.map(({ face }) => face),
    walls.map(({ own }) => own),
    { isSeen: none, isBetween: none, at: isBeyond, isOpen: isBeyond },
  );

  it('is as thick as the nearer and longer line tells', () => {
    const standsAt = (i: number, x: number) =>
      taken[i].shares[Math.floor((-x - taken[i].from) / STEP)] >= WALL_SHARE;
    expect([0, 1].map((i) => standsAt(i, 4.5))).toEqual([false, true]);
  });
});

describe('a column in line with a wall', () => {
  const long = wall('y', 4, 1, 4);

  /** Whether a wall is taken to go on from x = 4 to something that stands from x = 5 on. */
  function isJoined(
    to: number,
    isOpen: SeenSpace['isOpen'],
    others: ReturnType<typeof wall>[] = [],
  ): boolean {
    const short = wall('y', 4, 5, to);
    const face = { ...long.face, from: short.face.from };
    const shares = long.own.shares.map((share, k) => Math.max(share, short.own.shares[k]));
    const none = new Uint8Array(0);
    const seen: SeenSpace = { isSeen: none, isBetween: none, at: isOpen, isOpen };
    const [support] = takenSupport(
      [face, ...others.map((other) => other.face)],
      [{ ...long.own, shares }, ...others.map(({ own }) => own)],
      seen,
    );
    return support.shares[Math.floor((-4.5 - support.from) / STEP)] >= WALL_SHARE;
  }

  /** Space all around, but for what stands. */
  const around = (to: number) => (x: number, y: number) =>
    Math.abs(y - 4) > 0.05 || x > to || (x > 4 && x < 5);

  it('stands by itself where space was seen around it', () => {
    expect(isJoined(5.4, around(5.4))).toBe(false);
  });

  it('stands by itself where the line runs along its rim, as a round one', () => {
    const besideWall = (x: number, y: number) =>
      Math.abs(x - 4.7) > 0.05 && Math.hypot(x - 5.1, y - 4.15) > 0.2;
    expect(isJoined(5.2, besideWall)).toBe(false);
  });

  it('is the end of the wall where it goes on, or nothing shows that it does not', () => {
    expect(isJoined(6, around(6))).toBe(true);
    expect(isJoined(5.4, (x, y) => around(5.4)(x, y) && x < 5.5)).toBe(true);
    expect(isJoined(5.4, around(5.4), [wall('x', 5.45, 1, 7)])).toBe(true);
  });
});

const [WIDTH, DEPTH, HEIGHT, GRID] = [5, 4, 2.6, 0.025];

/** Points of a room of 5 m × 4 m, but for what a box holds, and of upright faces. */
function roomWith(solid: readonly number[], faces: readonly (readonly [Vec2, Vec2])[]) {
  const xyz: number[] = [];
  const [minX, minY, maxX, maxY] = solid;
  for (let x = GRID / 2; x < WIDTH; x += GRID)
    for (let y = GRID / 2; y < DEPTH; y += GRID)
      if (!(x > minX && x < maxX && y > minY && y < maxY)) xyz.push(x, y, 0, x, y, HEIGHT);
  for (const [[ax, ay], [bx, by]] of faces) {
    const steps = Math.round(Math.hypot(bx - ax, by - ay) / GRID);
    for (let k = 0; k < steps; k++)
      for (let z = GRID / 2; z < HEIGHT; z += GRID)
        xyz.push(ax + ((k + 0.5) / steps) * (bx - ax), ay + ((k + 0.5) / steps) * (by - ay), z);
  }
  return makeCloud(xyz);
}

function outlineOf(cloud: ReturnType<typeof makeCloud>): Ring {
  const kept = Uint32Array.from({ length: cloud.positions.length / 3 }, (_, i) => i);
  const columns = heightColumns(cloud, kept, { floor: 0, ceiling: HEIGHT });
  const { rooms } = findRooms(cloud, columns, localCeiling(columns));
  expect(rooms).toHaveLength(1);
  return rooms[0].outline.outer;
}

function distanceTo(ring: Ring, [x, y]: Vec2): number {
  let least = Infinity;
  for (let i = 0; i < ring.length; i += 2) least = Math.min(least, Math.hypot(ring[i] - x, ring[i + 1] - y));
  return least;
}

describe('a wall that steps', () => {
  const rest: [Vec2, Vec2][] = [
    [
      [WIDTH, 0],
      [WIDTH, DEPTH],
    ],
    [
      [WIDTH, DEPTH],
      [0, DEPTH],
    ],
    [
      [0, DEPTH],
      [0, 0],
    ],
  ];
  const [from, to, front] = [2, 2.5, 0.3];

  it.each([0, 0.4])(
    'has the corners of a pilaster of which only the front was seen, and of the wall past it what begins %d m on',
    (hidden) => {
      const faces: [Vec2, Vec2][] = [
        ...rest,
        [
          [0, 0],
          [from, 0],
        ],
        [
          [from, front],
          [to, front],
        ],
        [
          [to + hidden, 0],
          [WIDTH, 0],
        ],
      ];
      const ring = outlineOf(roomWith([from, 0, to, front], faces));
      for (const corner of [
        [from, 0],
        [from, front],
        [to, front],
        [to, 0],
      ] as const)
        expect(distanceTo(ring, corner)).toBeLessThan(0.03);
    },
  );

  it('has no corners where it does not', () => {
    const ring = outlineOf(
      roomWith(
        [0, 0, 0, 0],
        [
          ...rest,
          [
            [0, 0],
            [WIDTH, 0],
          ],
        ],
      ),
    );
    expect(ring).toHaveLength(8);
  });
});

it('the usual wall is that of the most length, not of the most pieces', () => {
  // Below, a room as long as the storey; above, 0.1 m off it, one of 6 m, and 0.3 m off it three of 1 m.
  const box = (minX: number, minY: number, maxX: number, maxY: number) => ({
    outer: Float64Array.of(minX, minY, maxX, minY, maxX, maxY, minX, maxY),
    holes: [],
  });
  const small = [0, 2, 4].map((x) => box(7 + x, 2.3, 8 + x, 4));
  expect(usualThickness([box(0, 0, 12, 2), box(0, 2.1, 6, 4), ...small])).toBeCloseTo(0.1, 6);
});
