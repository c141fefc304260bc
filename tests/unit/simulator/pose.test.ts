import { describe, expect, it } from 'vitest';
import { type Scene, simulate } from '../../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../../fixtures/simulator/layouts.ts';
import { UP_AXES } from '../../../fixtures/simulator/pose.ts';
import type { Axis, Vec3 } from '../../../src/core/types.ts';

const building = homeBuilding(12, { shape: 'L' });
const scan = { raysPerStation: 4000, voxel: 0.1, strays: 0 };
const plain = simulate({ name: 'plain', building, scan });

const point = ({ positions }: Scene, i: number): Vec3 => [
  positions[i * 3],
  positions[i * 3 + 1],
  positions[i * 3 + 2],
];
const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Signed volume of four points far from each other: mirrored clouds change its sign. */
function volume(scene: Scene): number {
  const last = scene.scan.kinds.length - 1;
  const [a, b, c, d] = [0, Math.floor(last / 3), Math.floor((2 * last) / 3), last].map((i) =>
    point(scene, i),
  );
  return dot(minus(b, a), cross(minus(c, a), minus(d, a)));
}

const FOOT = 0.3048;
const poses = [
  { heading: 0.3, unit: 'ft', perMetre: 1 / FOOT, up: 'z' },
  { heading: -1, unit: 'mm', perMetre: 1000, up: 'y' },
  { heading: 2, unit: 'cm', perMetre: 100, up: '-x' },
  { heading: 0, unit: 'm', perMetre: 1, up: 'x', tilt: 0.05, tiltTowards: 2 },
  { heading: 0.1, unit: 'm', perMetre: 1, up: '-z', offset: [691_870, 5_336_020, 519] as Vec3 },
  { heading: 0.1, unit: 'us-ft', perMetre: 3937 / 1200, up: '-y' },
] as const;

describe('poses', () => {
  it.each(poses)('$up up, $unit: the same cloud, moved and scaled, never mirrored', (given) => {
    const { perMetre, ...pose } = given;
    const posed = simulate({ name: 'posed', building, scan, pose });
    const count = posed.scan.kinds.length;
    expect(count).toBe(plain.scan.kinds.length);
    const [origin, plainOrigin] = [point(posed, 0), point(plain, 0)];
    for (let i = 1; i < count; i += 97) {
      const length = Math.hypot(...minus(point(posed, i), origin));
      expect(length).toBeCloseTo(perMetre * Math.hypot(...minus(point(plain, i), plainOrigin)), 5);
    }
    expect(volume(posed) / perMetre ** 3 / volume(plain)).toBeCloseTo(1, 6);
    expect(posed.truth.unit).toBeCloseTo(perMetre, 12);
    expect(posed.truth.plan_axes).toBe(UP_AXES[pose.up].planAxes);
  });

  it.each(poses)(
    '$up up, $unit: points seen along the plan axes lie in the true outline',
    ({ perMetre: k, ...pose }) => {
      const posed = simulate({ name: 'posed', building, scan, pose });
      if ('storeys' in posed.truth) throw new Error('expected one storey');
      const axes = posed.truth.plan_axes.split(',').map((text) => ({
        sign: text.startsWith('-') ? -1 : 1,
        axis: 'xyz'.indexOf(text.at(-1)!),
      }));
      const outline = posed.truth.outer[0];
      const slack = 0.35 * k;
      axes.forEach(({ sign, axis }, side) => {
        const wanted = outline.map((position) => position[side]);
        const found = Array.from(posed.scan.kinds, (_, i) => sign * posed.positions[i * 3 + axis]);
        expect(Math.min(...found)).toBeGreaterThan(Math.min(...wanted) - slack);
        expect(Math.max(...found)).toBeLessThan(Math.max(...wanted) + slack);
      });
    },
  );

  it('names right-handed plan axes: their cross product is up', () => {
    for (const up of Object.keys(UP_AXES) as Axis[]) {
      const [x, y, z] = [
        UP_AXES[up].toSource(1, 0, 0),
        UP_AXES[up].toSource(0, 1, 0),
        UP_AXES[up].toSource(0, 0, 1),
      ];
      expect(cross(x, y).map((value) => value + 0)).toEqual(z.map((value) => value + 0));
      const axis = 'xyz'.indexOf(up.at(-1)!);
      expect(z[axis]).toBe(up.startsWith('-') ? -1 : 1);
    }
  });

  it('tilts about the centroid', () => {
    const tilted = simulate({ name: 'tilted', building, scan, pose: { tilt: 0.1, tiltTowards: 0.7 } });
    const centre = ({ positions }: Scene, axis: number): number => {
      let sum = 0;
      for (let i = axis; i < positions.length; i += 3) sum += positions[i];
      return sum / (positions.length / 3);
    };
    for (const axis of [0, 1, 2]) expect(centre(tilted, axis)).toBeCloseTo(centre(plain, axis), 9);
    expect(tilted.truth).toEqual({ ...plain.truth, name: 'tilted' });
  });
});
