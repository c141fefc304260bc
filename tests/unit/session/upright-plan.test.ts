import { existsSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Building } from '../../../fixtures/simulator/building.ts';
import { writePly } from '../../../fixtures/simulator/index.ts';
import {
  corridorBuilding,
  homeBuilding,
  officeBuilding,
  roundHallBuilding,
} from '../../../fixtures/simulator/layouts.ts';
import { DEFAULT_POSE, type Pose, toSource } from '../../../fixtures/simulator/pose.ts';
import { DEFAULT_SCAN, scanBuilding } from '../../../fixtures/simulator/scan.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { areaOf, combine } from '../../../src/core/geometry/areas.ts';
import { perimeter } from '../../../src/core/geometry/rings.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import type { Axis, Polygon } from '../../../src/core/types.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { Session } from '../../../src/session/session.ts';
import { SCENES } from '../../scenes.ts';
import { memorySource } from '../read/memory-source.ts';

/** How the same building may lie in a file: with its axes named otherwise, and tilted. */
const AXES: readonly Partial<Pose>[] = (['y', '-y', 'x', '-z'] as const).map((up) => ({ up }));
const TILTS: readonly Partial<Pose>[] = [
  { tilt: degrees(3), tiltTowards: 0.7 },
  { tilt: degrees(10), tiltTowards: -1 },
  { tilt: degrees(10), tiltTowards: 2, up: 'y' },
];
const BUILDINGS = {
  'an L-shaped home': homeBuilding(21, { shape: 'L' }),
  'a T-shaped home': homeBuilding(33, { shape: 'T' }),
  'an office': officeBuilding(5, { width: 16, depth: 10 }),
  'a round hall': roundHallBuilding(4),
};
/** Where only the axes differ, m. */
const SAME = 0.002;
/** Of the simulated scanner, one standard deviation along the ray, m. */
const NOISE = 0.006;
const SCAN = { raysPerStation: 80_000, voxel: 0.03, noise: NOISE };
const LYING = { heading: 0.2, offset: [3, 4, 0] } as const;

/** Points in the building's own frame. */
function scanOf(building: Building, seed = DEFAULT_SCAN.seed): Float64Array {
  return scanBuilding(building, { ...DEFAULT_SCAN, ...SCAN, seed }).positions;
}

function degrees(angle: number): number {
  return (angle * Math.PI) / 180;
}

async function planOf(positions: Float64Array) {
  const session = new Session({ strokeTest: createStrokeTest() });
  const bytes = writePly({ positions }, { type: 'double' });
  const { plan } = await session.load(memorySource(bytes, 'scan.ply'));
  const { planOrigin, metresPerUnit, up, tilt } = plan.frame;
  const place = (ring: Float64Array) => ring.map((value, i) => planOrigin[i % 2] * metresPerUnit + value);
  const outline = plan.storeys.flatMap(({ primary }) =>
    primary.map(({ outer, holes }): Polygon => ({ outer: place(outer), holes: holes.map(place) })),
  );
  return { outline, up, tilt };
}

/** Mean distance between two outlines, m: the area that only one of them holds, by length. */
function distanceBetween(a: readonly Polygon[], b: readonly Polygon[]): number {
  const length = a.reduce(
    (sum, { outer, holes }) => [outer, ...holes].reduce((all, ring) => all + perimeter(ring), sum),
    0,
  );
  return (areaOf(combine('difference', a, b)) + areaOf(combine('difference', b, a))) / length;
}

describe.each(Object.entries(BUILDINGS))('%s', async (_, building) => {
  const points = scanOf(building);
  const lying = (pose: Partial<Pose>) => planOf(toSource(points, { ...DEFAULT_POSE, ...LYING, ...pose }));
  const upright = await lying({});

  it.each(AXES)('has one plan, whichever axis is up: $up', async (pose) => {
    const { up, tilt, outline } = await lying(pose);
    expect({ up, tilt }).toEqual({ up: pose.up, tilt: 0 });
    expect(distanceBetween(upright.outline, outline)).toBeLessThan(SAME);
  });

  it.each(TILTS)('is levelled: $tilt towards $tiltTowards', async (pose) => {
    const { up, tilt, outline } = await lying(pose);
    expect(up).toBe(pose.up ?? 'z');
    expect(Math.abs(tilt - (pose.tilt ?? 0))).toBeLessThan(degrees(0.05));
    expect(distanceBetween(upright.outline, outline)).toBeLessThan(NOISE);
  });
});

it('an empty corridor, which nothing tells from one turned over, is not turned over', async () => {
  for (const seed of [1, 2, 3]) {
    const points = toSource(scanOf(corridorBuilding(seed), seed), DEFAULT_POSE);
    expect((await planOf(points)).up).toBe('z');
  }
});

describe.skipIf(!existsSync(SCENES))(`scenes of ${SCENES} (skipped when absent)`, () => {
  it.each(['home_l', 'home_rect', 'floor_office'])('%s has one plan, whichever axis is up', async (name) => {
    const source = memorySource(readFileSync(`${SCENES}/${name}.ply`), `${name}.ply`);
    const { positions, origin } = await readScan(source, resolveOptions({}));
    const upright = Float64Array.from(positions, (value, i) => value + origin[i % 3]);
    const expected = await planOf(upright);
    expect(expected.up).toBe('z');
    for (const up of ['y', '-z'] as const) {
      const { outline, ...found } = await planOf(turned(upright, up));
      expect(found).toEqual({ up, tilt: expected.tilt });
      expect(distanceBetween(expected.outline, outline)).toBeLessThan(SAME);
    }
  });
});

/** The same cloud with another axis up. */
function turned(points: Float64Array, up: Axis): Float64Array {
  const out = new Float64Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = points.subarray(i, i + 3);
    out.set(up === 'y' ? [x, z, -y] : [x, -y, -z], i);
  }
  return out;
}
