import fc from 'fast-check';
import { expect, test } from 'vitest';
import { uprightRotation } from '../../src/core/frame/rotation.ts';
import { orient } from '../../src/core/frame.ts';
import { resolveOptions } from '../../src/core/options.ts';
import { createRandom } from '../../src/core/random.ts';
import type { Axis, PointCloud, Scan } from '../../src/core/types.ts';
import {
  listen,
  makeScan,
  roomPoints,
  shuffled,
  tiltMatrix,
  transform,
  transpose,
} from '../unit/core/made-scan.ts';

const RUNS = { numRuns: 25 };
const METRES = { m: 1, cm: 0.01, mm: 0.001, ft: 0.3048 } as const;

/** A furnished L with a floor larger than its walls, of random size, storey height and heading. */
const rooms = fc
  .record({
    width: fc.double({ min: 7, max: 11, noNaN: true }),
    depth: fc.double({ min: 6, max: 9, noNaN: true }),
    notch: fc.double({ min: 0.55, max: 0.7, noNaN: true }),
    height: fc.double({ min: 2.3, max: 3.2, noNaN: true }),
    heading: fc.double({ min: 0, max: 6.28, noNaN: true }),
    seed: fc.nat(1000),
  })
  .map(({ width, depth, notch, height, heading, seed }) => {
    const [w, d] = [width * notch, depth * notch];
    const corners = [0, 0, width, 0, width, d, w, d, w, depth, 0, depth];
    const points = roomPoints({ corners, height, seed, spacing: 0.09, noise: 0.006 });
    const [c, s] = [Math.cos(heading), Math.sin(heading)];
    return { points: transform(points, [c, -s, 0, s, c, 0, 0, 0, 1]), height };
  });

function run(scan: Scan, given: Parameters<typeof resolveOptions>[0] = {}): PointCloud {
  return orient(scan, resolveOptions(given), listen().context);
}

function largestDifference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let most = 0;
  for (let i = 0; i < a.length; i++) most = Math.max(most, Math.abs(a[i] - b[i]));
  return most;
}

test('however the axes are named, the plan is the same', () => {
  const axes = fc.constantFrom<Axis>('z', '-z', 'y', '-y');
  fc.assert(
    fc.property(rooms, axes, ({ points, height }, up) => {
      const cloud = run(makeScan(transform(points, transpose(uprightRotation(up)))));
      expect(cloud.frame.up).toBe(up);
      expect(largestDifference(cloud.positions, points)).toBeLessThan(1e-5);
      expect(cloud.ceiling! - cloud.floor!).toBeCloseTo(height, 1);
    }),
    RUNS,
  );
});

test('whatever the unit and the place, the plan is the same in metres and the frame leads back', () => {
  const places = fc.tuple(fc.integer({ min: -1e6, max: 1e6 }), fc.integer({ min: -6e6, max: 6e6 }));
  fc.assert(
    fc.property(
      rooms,
      fc.constantFrom<keyof typeof METRES>('m', 'cm', 'mm', 'ft'),
      places,
      ({ points }, unit, [x, y]) => {
        const origin = [x, y, 100] as const;
        const source = points.map((value, i) => value / METRES[unit] + origin[i % 3]);
        const { frame, positions } = run(makeScan(source, { origin }));
        expect(frame.unit).toBe(unit);
        expect(largestDifference(positions, points)).toBeLessThan(1e-5);
        for (const i of [0, 3 * Math.floor(points.length / 6)]) {
          for (let k = 0; k < 3; k++) {
            const back = frame.planOrigin[k] + positions[i + k] / frame.metresPerUnit;
            expect(Math.abs(back - source[i + k]) * METRES[unit]).toBeLessThan(1e-5);
          }
        }
      },
    ),
    RUNS,
  );
});

test('the order of the points does not change the frame', () => {
  fc.assert(
    fc.property(rooms, fc.nat(100), ({ points }, seed) => {
      const [a, b] = [run(makeScan(points)), run(makeScan(shuffled(points, 3, createRandom(seed))))];
      expect(b.frame).toEqual(a.frame);
      expect(b.floor).toBeCloseTo(a.floor!, 6);
      expect(b.ceiling).toBeCloseTo(a.ceiling!, 6);
    }),
    RUNS,
  );
});

test('a tilted scan is levelled to a twentieth of a degree; a level one is left alone', () => {
  const tilts = fc.double({ min: 0.5, max: 14, noNaN: true });
  const headings = fc.double({ min: 0, max: 6.28, noNaN: true });
  fc.assert(
    fc.property(rooms, tilts, headings, ({ points }, degrees, heading) => {
      const matrix = tiltMatrix((degrees * Math.PI) / 180, heading);
      const { frame } = run(makeScan(transform(points, matrix)), { up: 'z' });
      // Where the plan's up was before the tilt: the last row of rotation · tilt should be (0, 0, 1).
      const [x, y] = transform(
        [matrix[0], matrix[3], matrix[6], matrix[1], matrix[4], matrix[7]],
        frame.rotation,
      ).filter((_, i) => i % 3 === 2);
      expect((Math.hypot(x, y) * 180) / Math.PI).toBeLessThan(0.05);
      expect(run(makeScan(points)).frame.tilt).toBe(0);
    }),
    RUNS,
  );
});
