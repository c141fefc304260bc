import { expect, it } from 'vitest';
import { seededRandom } from '../../../../fixtures/simulator/random.ts';
import { type HeightColumns, heightColumns } from '../../../../src/core/building/columns/height-columns.ts';
import { fitArc } from '../../../../src/core/building/faces/fit-arc.ts';
import { fitLine } from '../../../../src/core/building/faces/fit-line.ts';
import { circleThrough } from '../../../../src/core/geometry/circle.ts';
import type { PointCloud } from '../../../../src/core/types.ts';
import { UPRIGHT_FRAME } from '../made-scan.ts';

const NOISE = 0.01;

/** Points from floor to ceiling over places of a curve, with noise across it and one in ten astray by 5 cm. */
function wallOver(count: number, place: (share: number, across: number) => readonly [number, number]) {
  const random = seededRandom(7, 'wall');
  const positions = new Float32Array(3 * count);
  for (let i = 0; i < count; i++) {
    const across = random.chance(0.1) ? 0.05 : NOISE * random.normal();
    const [x, y] = place(random.between(0, 1), across);
    positions.set([x, y, random.between(0, 2.5)], 3 * i);
  }
  const cloud: PointCloud = {
    frame: UPRIGHT_FRAME,
    positions,
    attributes: {},
    stations: [],
    floor: 0,
    ceiling: 2.5,
    reasons: { unit: '', up: '' },
    isFlat: false,
  };
  const columns = heightColumns(
    cloud,
    Uint32Array.from({ length: count }, (_, i) => i),
    { floor: 0, ceiling: 2.5 },
  );
  return { cloud, columns, members: membersOf(columns) };
}

const membersOf = ({ count, hits }: HeightColumns) =>
  Array.from({ length: count }, (_, c) => c).filter((c) => hits[c] > 2);

it('a line runs through the middle of its noise, past what stands before it', () => {
  const angle = 0.3;
  const [nx, ny] = [-Math.sin(angle), Math.cos(angle)];
  const { cloud, columns, members } = wallOver(20_000, (share, across) => {
    const along = 4 * share;
    return [1 + along * Math.cos(angle) + across * nx, 2 + along * Math.sin(angle) + across * ny];
  });
  const guess = {
    nx: -Math.sin(0.31),
    ny: Math.cos(0.31),
    offset: nx + 2 * ny + 0.02,
    from: 0,
    to: 4,
    members,
  };
  const face = fitLine(cloud, columns, guess)!;
  expect(Math.abs(Math.atan2(face.ny, face.nx) - Math.atan2(ny, nx))).toBeLessThan(0.0005);
  expect(
    Math.abs(
      3 * face.nx * 0 +
        (1 + 2 * Math.cos(angle)) * face.nx +
        (2 + 2 * Math.sin(angle)) * face.ny -
        face.offset,
    ),
  ).toBeLessThan(0.001);
  expect(face.noise).toBeGreaterThan(0.8 * NOISE);
  expect(face.noise).toBeLessThan(1.5 * NOISE);
});

it('an arc has the radius of its wall', () => {
  const { cloud, columns, members } = wallOver(20_000, (share, across) => {
    const angle = 0.4 + 1.2 * share;
    return [(5 + across) * Math.cos(angle), (5 + across) * Math.sin(angle)];
  });
  const face = fitArc(cloud, columns, { cx: 0.1, cy: -0.1, radius: 5.1, from: 0.4, to: 1.6, members })!;
  expect(Math.hypot(face.cx, face.cy)).toBeLessThan(0.02);
  expect(Math.abs(face.radius - 5)).toBeLessThan(0.02);
});

it('three points lie on one circle, and points of a line on none', () => {
  const circle = circleThrough([1, 0, 0, 1, -1, 0], [1, 1, 1])!;
  expect(circle.cx).toBeCloseTo(0, 12);
  expect(circle.cy).toBeCloseTo(0, 12);
  expect(circle.radius).toBeCloseTo(1, 12);
  expect(circleThrough([0, 0, 1, 1, 2, 2], [1, 1, 1])).toBeNull();
});
