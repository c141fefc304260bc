import { describe, expect, test } from 'vitest';
import { uprightRotation } from '../../../src/core/frame/rotation.ts';
import { orient } from '../../../src/core/frame.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { createRandom } from '../../../src/core/random.ts';
import type { Axis, Frame, PointCloud, Scan, Unit } from '../../../src/core/types.ts';
import {
  ASYMMETRIC_L,
  centroidOf,
  codesOf,
  concat,
  listen,
  makeScan,
  makeSliceScan,
  roomPoints,
  strayPoints,
  tiltMatrix,
  transform,
  transpose,
} from './made-scan.ts';

const ROOM = roomPoints();
/** The L twice as large. */
const HALL = roomPoints({ corners: ASYMMETRIC_L.map((value) => 2 * value), spacing: 0.08 });
const AXES: readonly Axis[] = ['z', '-z', 'y', '-y', 'x', '-x'];

function run(scan: Scan, given: Parameters<typeof resolveOptions>[0] = {}) {
  const { context, warnings } = listen();
  const cloud = orient(scan, resolveOptions(given, { isSlice: scan.isSlice }), context);
  return { cloud, warnings, codes: codesOf(warnings) };
}

/** Source coordinates of a plan point, as documented at Frame. */
function sourcePlan({ planOrigin, metresPerUnit }: Frame, x: number, y: number, z: number) {
  return [
    planOrigin[0] + x / metresPerUnit,
    planOrigin[1] + y / metresPerUnit,
    planOrigin[2] + z / metresPerUnit,
  ];
}

function determinant([a, b, c, d, e, f, g, h, i]: readonly number[]): number {
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}

function largestDifference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let most = 0;
  for (let i = 0; i < a.length; i++) most = Math.max(most, Math.abs(a[i] - b[i]));
  return most;
}

/** A wall across the flat, two faces, with openings 0.9 m wide from `sill` to `head`. */
function piercedWall({ at, sill = 0, head }: { at: number; sill?: number; head: number }): number[] {
  const points: number[] = [];
  for (let y = 0; y < 3; y += 0.05) {
    const isPierced = [0.4, 1.7].some((edge) => y > edge && y < edge + 0.9);
    for (let z = 0; z < 2.7; z += 0.05) {
      if (isPierced && z >= sill && z < head) continue;
      for (const x of [at, at + 0.12]) points.push(x, y, z);
    }
  }
  return points;
}

describe('up', () => {
  test.each(AXES)('%s is found and the asymmetric L is not mirrored', (up) => {
    // x up is trusted so little that a floor must be much larger than a wall.
    const room = up.endsWith('x') ? HALL : ROOM;
    const source = transform(room, transpose(uprightRotation(up)));
    const { cloud, codes } = run(makeScan(source));
    expect(cloud.frame.up).toBe(up);
    expect(determinant(cloud.frame.rotation)).toBeCloseTo(1, 12);
    expect(largestDifference(cloud.positions, room)).toBeLessThan(1e-5);
    expect(codes).toEqual([]);
  });

  test('an empty flat is not turned over by the lintels of its doors', () => {
    const lintels: number[] = [];
    for (const x of [0.5, 2, 3.5, 5]) {
      for (let u = 0; u < 0.9; u += 0.03) {
        for (let v = 0; v < 0.24; v += 0.03) lintels.push(x + u, v, 2.2);
        for (let z = 2.2; z < 2.7; z += 0.03) lintels.push(x + u, 0.24, z);
      }
    }
    const flat = concat(roomPoints({ hasTable: false }), Float64Array.from(lintels));
    expect(run(makeScan(flat)).cloud.frame.up).toBe('z');
  });

  test('an empty flat is not turned over by the lamps that hang in it', () => {
    const lamps: number[] = [];
    for (const x of [0.8, 2.8, 4.8])
      for (let u = 0; u < 1.2; u += 0.03) for (let v = 0; v < 0.3; v += 0.03) lamps.push(x + u, 1.5 + v, 2.2);
    const flat = concat(roomPoints({ hasTable: false }), Float64Array.from(lamps));
    expect(run(makeScan(flat)).cloud.frame.up).toBe('z');
  });

  test('the doorways of an empty flat tell its floor, whichever axis is up', () => {
    const flat = concat(roomPoints({ hasTable: false }), piercedWall({ at: 4, head: 2.05 }));
    for (const up of AXES.filter((axis) => !axis.endsWith('x'))) {
      const { cloud, codes } = run(makeScan(transform(flat, transpose(uprightRotation(up)))));
      expect([cloud.frame.up, codes]).toEqual([up, []]);
    }
  });

  test('parapets below windows up to the ceiling are no doorways turned over', () => {
    const wall = piercedWall({ at: 8, sill: 0.9, head: 2.7 });
    const { cloud, codes } = run(makeScan(concat(roomPoints({ hasTable: false }), wall)));
    expect([cloud.frame.up, codes]).toEqual(['z', ['frame/up-guessed']]);
  });

  test('an empty room stands as in the file, with a warning that says what to try', () => {
    for (const up of ['z', 'y'] as const) {
      const room = transform(roomPoints({ hasTable: false }), transpose(uprightRotation(up)));
      const { cloud, warnings } = run(makeScan(room));
      expect(cloud.frame.up).toBe(up);
      const [{ code, message, hint }] = warnings;
      expect(code).toBe('frame/up-guessed');
      expect(message).toContain('neither furniture nor doorways');
      expect(hint).toContain(`the up axis to -${up}`);
    }
  });

  test('tables that hang above doorways leave the scan as in the file, with a warning', () => {
    const hung = roomPoints().map((value, i) => (i % 3 === 2 ? 2.7 - value : value));
    const { cloud, warnings } = run(makeScan(concat(hung, piercedWall({ at: 4, head: 2.05 }))));
    expect(cloud.frame.up).toBe('z');
    expect(warnings.map(({ message }) => message).join()).toContain('disagree');
  });

  test('furniture shows the side of a floor without a ceiling', () => {
    const open = ROOM.filter((_, i) => ROOM[i - (i % 3) + 2] < 2.65);
    expect(run(makeScan(open)).cloud.frame.up).toBe('z');
    const turned = transform(open, transpose(uprightRotation('-z')));
    expect(run(makeScan(turned)).cloud.frame.up).toBe('-z');
  });

  test('a model that stands by its format is not turned over by lamps, and keeps its own axis where that is wrong', () => {
    const source = transform(ROOM, transpose(uprightRotation('-y')));
    expect(run(makeScan(source)).cloud.frame.up).toBe('-y');
    expect(run(makeScan(source, { up: 'y' })).cloud.frame.up).toBe('y');
    expect(run(makeScan(ROOM, { up: 'y' })).cloud.frame.up).toBe('z');
  });

  test('y up gives the plan (x, −z)', () => {
    const source = transform(ROOM, transpose(uprightRotation('y')));
    const { cloud } = run(makeScan(source, { origin: [10, 20, 30] }));
    const [x, y, z] = sourcePlan(cloud.frame, cloud.positions[0], cloud.positions[1], cloud.positions[2]);
    expect(x).toBeCloseTo(source[0], 4);
    expect(y).toBeCloseTo(-source[2], 4);
    expect(z).toBeCloseTo(source[1], 4);
  });

  test('a corridor narrower than high stands on its floor', () => {
    const corridor = roomPoints({ corners: [0, 0, 14, 0, 14, 2.2, 0, 2.2], height: 2.7 });
    expect(run(makeScan(corridor)).cloud.frame.up).toBe('z');
  });

  test('what a person names is taken', () => {
    const { cloud } = run(makeScan(ROOM), { up: 'x' });
    expect(cloud.frame.up).toBe('x');
    expect(cloud.reasons.up).toContain('given');
  });

  test('a dense wall does not outweigh a sparse floor', () => {
    const wall: number[] = [];
    for (let x = 0; x < 7; x += 0.01) for (let z = 0; z < 2.7; z += 0.01) wall.push(x, 0, z);
    expect(run(makeScan(concat(ROOM, wall))).cloud.frame.up).toBe('z');
  });

  test('a handful of points is upright by convention, with a warning', () => {
    const { cloud, codes } = run(makeScan([0, 0, 0, 4, 0, 0, 4, 3, 0, 0, 3, 2.5]));
    expect(cloud.frame.up).toBe('z');
    expect(codes).toContain('frame/up-guessed');
  });
});

describe('floor and ceiling', () => {
  test('are found to a few millimetres', () => {
    const { cloud } = run(makeScan(roomPoints({ floor: 12.3, height: 3.1, noise: 0.01 })));
    expect(cloud.floor).toBeCloseTo(12.3, 2);
    expect(cloud.ceiling).toBeCloseTo(15.4, 2);
  });

  test.each([0.002, 0.01])('%f of stray points move nothing', (share) => {
    const strays = strayPoints((share * ROOM.length) / 3, 4, createRandom(7));
    const { cloud } = run(makeScan(concat(ROOM, strays)));
    expect(cloud.frame.up).toBe('z');
    expect(cloud.frame.tilt).toBe(0);
    expect(cloud.floor).toBeCloseTo(0, 2);
    expect(cloud.ceiling).toBeCloseTo(2.7, 2);
  });

  test('a ceiling that was not scanned is null', () => {
    const open = ROOM.filter((_, i) => ROOM[i - (i % 3) + 2] < 2.65);
    const { cloud } = run(makeScan(open));
    expect(cloud.floor).toBeCloseTo(0, 2);
    expect(cloud.ceiling).toBeNull();
  });

  test('a floor that was not scanned is null', () => {
    const upper = ROOM.filter((_, i) => ROOM[i - (i % 3) + 2] > 1);
    const { cloud } = run(makeScan(upper), { up: 'z' });
    expect(cloud.floor).toBeNull();
    expect(cloud.ceiling).toBeCloseTo(2.7, 2);
  });
});

describe('levelling', () => {
  test('a level scan keeps its coordinates to the last bit', () => {
    const scan = makeScan(ROOM, { origin: [3, 4, 5] });
    const { cloud } = run(scan);
    expect(cloud.frame.tilt).toBe(0);
    expect(cloud.frame.origin).toEqual([3, 4, 5]);
    expect(cloud.positions).toEqual(scan.positions);
  });

  test.each([0.5, 3, 8, 14])('a tilt of %f° is taken out about the centroid', (degrees) => {
    const angle = (degrees * Math.PI) / 180;
    const pivot = centroidOf(ROOM);
    const centred = ROOM.map((value, i) => value - pivot[i % 3]);
    const source = transform(centred, tiltMatrix(angle, 0.6)).map((value, i) => value + pivot[i % 3]);
    const { cloud, codes } = run(makeScan(source));
    expect(codes).toEqual(['frame/levelled']);
    expect((cloud.frame.tilt * 180) / Math.PI).toBeCloseTo(degrees, 1);
    expect(determinant(cloud.frame.rotation)).toBeCloseTo(1, 12);
    const back = new Float64Array(ROOM.length);
    for (let i = 0; i < back.length; i += 3) {
      back.set(
        sourcePlan(cloud.frame, cloud.positions[i], cloud.positions[i + 1], cloud.positions[i + 2]),
        i,
      );
    }
    expect(largestDifference(back, ROOM)).toBeLessThan(0.003);
    expect(cloud.ceiling! - cloud.floor!).toBeCloseTo(2.7, 2);
  });

  test('a tilt past 15° is left, with a warning', () => {
    const source = transform(ROOM, tiltMatrix((17 * Math.PI) / 180, 0.6));
    const { cloud, codes } = run(makeScan(source));
    expect(cloud.frame.tilt).toBe(0);
    expect(codes).toContain('frame/tilt-too-large');
  });

  test('can be switched off', () => {
    const source = transform(ROOM, tiltMatrix(0.05, 0.6));
    expect(run(makeScan(source), { levelling: false }).cloud.frame.tilt).toBe(0);
  });

  test('a ramp between upright walls stays a ramp', () => {
    const ramp = ROOM.map((value, i) => (i % 3 === 2 ? value + 0.05 * ROOM[i - 2] : value));
    expect(run(makeScan(ramp)).cloud.frame.tilt).toBe(0);
  });
});

describe('unit', () => {
  const scales: [Unit, number][] = [
    ['m', 1],
    ['cm', 100],
    ['mm', 1000],
    ['ft', 1 / 0.3048],
  ];

  test.each(scales)('%s is judged from the storey height', (unit, perMetre) => {
    const { cloud, codes } = run(makeScan(ROOM.map((value) => value * perMetre)));
    expect(cloud.frame.unit).toBe(unit);
    expect(largestDifference(cloud.positions, ROOM)).toBeLessThan(1e-5);
    expect(codes).toEqual(unit === 'm' ? [] : ['frame/unit-guessed']);
    expect(cloud.reasons.unit).toContain(unit);
  });

  test('two high storeys in metres are not one in feet, though its floor and ceiling show best', () => {
    // Heights 0, 4.2, 4.6 and 8.7: the outer two are 2.65 m apart in feet. Between them only a part was seen.
    const storeys = [roomPoints({ height: 4.2 }), roomPoints({ floor: 4.6, height: 4.1, hasTable: false })];
    const seen = Array.from(concat(...storeys)).filter((_, i, all) => {
      const [x, z] = [all[i - (i % 3)], all[i - (i % 3) + 2]];
      return x < 4 || z < 4 || z > 5;
    });
    expect(run(makeScan(seen)).cloud.frame.unit).toBe('m');
    const corners = ASYMMETRIC_L.map((value) => 4 * value);
    const feet = roomPoints({ corners, height: 8.7, spacing: 0.2 });
    expect(run(makeScan(feet)).cloud.frame.unit).toBe('ft');
  });

  test('what the file states counts, and what a person gives counts more', () => {
    expect(run(makeScan(ROOM, { unit: 'us-ft' })).cloud.frame.metresPerUnit).toBe(1200 / 3937);
    expect(run(makeScan(ROOM, { unit: 'us-ft' }), { unit: 'cm' }).cloud.frame.metresPerUnit).toBe(0.01);
  });

  test('scanners stand where their points do, with whatever unit, axes and tilt', () => {
    const seen = [1.5, 2, 1.25];
    const offset = [5e6, 100, -7e5] as const;
    const yUp = [1, 0, 0, 0, 0, 1, 0, -1, 0];
    const place = (points: ArrayLike<number>) =>
      transform(transform(points, tiltMatrix(0.06, 0.7)), yUp).map(
        (value, i) => 1000 * value + offset[i % 3],
      );
    const scan = makeScan(place([...ROOM, ...seen]), { origin: offset, unit: 'mm' });
    const [x, y, z] = place(seen);
    const { cloud, codes } = run({ ...scan, stations: [[x, y, z]] });
    const point = cloud.positions.subarray(-3);
    cloud.stations[0].forEach((value, axis) => {
      expect(value).toBeCloseTo(point[axis], 5);
    });
    expect([cloud.frame.up, codes]).toEqual(['y', ['frame/levelled']]);
  });

  test('UTM coordinates come back to the millimetre', () => {
    const origin = [691_234, 5_334_567, 519] as const;
    const utm = ROOM.map((value, i) => value + origin[i % 3] + 0.125);
    const { cloud } = run(makeScan(utm, { origin }));
    for (const i of [0, 300, ROOM.length - 3]) {
      const [x, y, z] = sourcePlan(
        cloud.frame,
        cloud.positions[i],
        cloud.positions[i + 1],
        cloud.positions[i + 2],
      );
      expect(Math.abs(x - utm[i])).toBeLessThan(1e-5);
      expect(Math.abs(y - utm[i + 1])).toBeLessThan(1e-5);
      expect(Math.abs(z - utm[i + 2])).toBeLessThan(1e-5);
    }
  });
});

describe('clouds without height', () => {
  const SLICE = [0, 0, 700, 0, 700, 300, 400, 300, 400, 500, 0, 500];

  test('a ready slice is in the plan frame and in pixels', () => {
    const { cloud, codes } = run(makeSliceScan(SLICE));
    expect(cloud.isFlat).toBe(true);
    expect(cloud.frame.unit).toBe('px');
    expect(cloud.frame.metresPerUnit).toBe(0.01);
    expect(cloud.frame.rotation).toEqual([1, 0, 0, 0, 1, 0, 0, 0, 1]);
    expect([...cloud.positions.slice(3, 6)]).toEqual([7, 0, 0]);
    expect(codes).toEqual([]);
  });

  test('a slice that is tiny in pixels is taken for metres, with a warning', () => {
    const { cloud, codes } = run(makeSliceScan(SLICE.map((value) => value / 100)));
    expect(cloud.frame).toMatchObject({ unit: 'm', metresPerUnit: 1 });
    expect(codes).toEqual(['frame/unit-guessed']);
  });

  test('a slice larger than any canvas is taken for millimetres, with a warning', () => {
    const { cloud, codes } = run(makeSliceScan(SLICE.map((value) => value * 10)));
    expect(cloud.frame).toMatchObject({ unit: 'mm', metresPerUnit: 0.001 });
    expect(codes).toEqual(['frame/unit-guessed']);
  });

  test.each(['x', 'y', 'z'] as const)('a cloud flat along %s is seen along it', (up) => {
    const flat = ROOM.map((value, i) => (i % 3 === 2 ? 1.5 : value));
    const { cloud, codes } = run(makeScan(transform(flat, transpose(uprightRotation(up)))));
    expect(cloud.frame.up).toBe(up);
    expect(cloud.isFlat).toBe(true);
    expect(largestDifference(cloud.positions, flat)).toBeLessThan(1e-5);
    expect(codes).toContain('frame/flat-cloud');
  });
});

describe('clouds that enclose nothing', () => {
  const refused: [string, number[], string][] = [
    ['no point', [], 'input/too-few-points'],
    ['two points', [0, 0, 0, 1, 1, 1], 'input/too-few-points'],
    ['equal points', [1, 2, 3, 1, 2, 3, 1, 2, 3], 'input/degenerate'],
    ['points on a line', [0, 0, 0, 1, 2, 3, 2, 4, 6, 3, 6, 9], 'input/degenerate'],
  ];

  test.each(refused)('%s: refused', (_, points, code) => {
    expect(() => run(makeScan(points))).toThrow(expect.objectContaining({ code }));
  });
});

test('one cloud, one result', () => {
  const results: PointCloud[] = [run(makeScan(ROOM)).cloud, run(makeScan(ROOM)).cloud];
  expect(results[0]).toEqual(results[1]);
});
