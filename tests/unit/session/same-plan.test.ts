import { gzipSync, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { simulate, writePly } from '../../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../../fixtures/simulator/layouts.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { createRandom } from '../../../src/core/random.ts';
import type { Polygon } from '../../../src/core/types.ts';
import type { ByteSource } from '../../../src/read/bytes/source.ts';
import { READ_FORMATS } from '../../../src/read/formats.ts';
import { makeReport } from '../../../src/session/report.ts';
import { Session } from '../../../src/session/session.ts';
import { cartesianFields, e57Bytes } from '../read/e57-bytes.ts';
import { lasBytes } from '../read/las/las-bytes.ts';
import { memorySource } from '../read/memory-source.ts';
import { pcdBytes } from '../read/pcd-bytes.ts';
import { ptxHeader } from '../read/ptx-text.ts';

/** A step that every format holds exactly: about a millimetre, a power of two. */
const STEP = 2 ** -10;
/** Each point has a companion, often in the same cell, so that there is one to be chosen. */
const COMPANION = 6;

/** A home of some ten thousand points, a third of them to be thinned out. */
function homePoints(): number[][] {
  const scan = { voxel: 0.08, raysPerStation: 20_000 };
  const { positions } = simulate({ name: 'home', building: homeBuilding(11, { shape: 'L' }), scan });
  const random = createRandom(5);
  const points: number[][] = [];
  for (let i = 0; i < positions.length; i += 3) {
    const place = [...positions.subarray(i, i + 3)].map((value) => Math.round(value / STEP));
    const beside = place.map((value) => value + Math.floor(COMPANION * random()));
    for (const steps of [place, beside]) points.push(steps.map((value) => value * STEP));
  }
  return points;
}

const points = homePoints();
const positions = Float64Array.from(points.flat());
/** The second half first: scans of one file, tiles, and another order. */
const halves = [points.slice(points.length / 2), points.slice(0, points.length / 2)];
const backwards = points.toReversed();
const flat = (some: readonly number[][]) => Float64Array.from(some.flat());
const rows = (some: readonly number[][], more = '', separator = ' ') =>
  some.map((point) => `${point.join(separator)}${more}\n`).join('');
const pose = '<pose type="Structure"/>';
const XYZ = ['x', 'y', 'z'] as const;

const las = (some: readonly number[][], format: number) =>
  lasBytes({
    format,
    minor: format < 6 ? 2 : 4,
    points: some.map(([x, y, z]) => ({ at: [x / STEP, y / STEP, z / STEP] })),
    scale: [STEP, STEP, STEP],
  });
const pcd = (data: 'ascii' | 'binary' | 'binary_compressed', size: 4 | 8) =>
  pcdBytes({ fields: XYZ.map((name) => [name, size, 'F'] as const), points: backwards }, { data });
const packet = { packets: Math.ceil(points.length / 1000) };

const FILES: Readonly<Record<string, string | Uint8Array>> = {
  'float.ply': writePly({ positions: flat(backwards) }),
  'big.ply': writePly({ positions }, { format: 'binary_big_endian', type: 'double' }),
  'ascii.ply': writePly({ positions }, { format: 'ascii', type: 'double' }),
  'old.las': las(backwards, 0),
  'new.las': las(halves.flat(), 6),
  'home.e57': e57Bytes(
    halves.map((half) => ({ fields: cartesianFields(half), xml: pose })),
    packet,
  ),
  'home.ptx': halves
    .map((half) => `${ptxHeader(half.length + 1, 1)}0 0 0 0.5\n${rows(half, ' 0.5')}`)
    .join(''),
  'home.pts': halves.map((half) => `${half.length}\n${rows(half)}`).join(''),
  'ascii.pcd': pcd('ascii', 4),
  'binary.pcd': pcd('binary', 8),
  'packed.pcd': pcd('binary_compressed', 4),
  'home.csv': `x,y,z\n${rows(backwards, '', ',')}`,
  'home.xyz': rows(halves.flat()),
  'home.tsv': `X\tY\tZ\n${rows(points, '', '\t')}`,
  'points.obj': rows(backwards).replaceAll(/^/gm, 'v ').slice(0, -2),
  'home.csv.gz': gzipSync(new TextEncoder().encode(rows(points, '', ','))),
  'tiles.zip': zipSync({
    'a.las': las(halves[0], 3),
    'b.ply': writePly({ positions: flat(halves[1]) }, { type: 'double' }),
  }),
};

async function run(source: ByteSource | readonly ByteSource[]) {
  const session = new Session({ strokeTest: createStrokeTest() });
  const result = await session.load(source, { unit: 'm' });
  const { storeys, frame } = result.plan;
  return { plan: { storeys, frame }, report: makeReport(result, 0) };
}

const source = (name: string) => memorySource(FILES[name], name);

describe('one cloud becomes one plan', async () => {
  const { plan, report } = await run(memorySource(writePly({ positions }, { type: 'double' }), 'home.ply'));

  it('from a cloud that was thinned', () => {
    const { pointsRead, pointsKept, stations } = report.input;
    expect(pointsRead).toBe(points.length);
    expect(pointsKept).toBeLessThan(0.9 * pointsRead);
    expect(plan.storeys[0].primary.length).toBeGreaterThan(0);
    expect(stations).toEqual([]);
  });

  it.each(Object.keys(FILES))('%s', async (name) => {
    const other = await run(source(name));
    expect(other.plan).toEqual(plan);
    const hasStations = /e57|ptx/.test(name);
    expect(other.report.input).toMatchObject({
      pointsRead: points.length,
      pointsKept: report.input.pointsKept,
      stations: hasStations
        ? [
            [0, 0, 0],
            [0, 0, 0],
          ]
        : [],
    });
  });

  it('as tiles of several formats, in any order of the files', async () => {
    const thirds = [0, 1, 2].map((k) => points.filter((_, i) => i % 3 === k));
    const tiles = [
      memorySource(las(thirds[0], 1), 'a.las'),
      memorySource(
        pcdBytes(
          { fields: XYZ.map((name) => [name, 4, 'F'] as const), points: thirds[1] },
          { data: 'binary' },
        ),
        'b.pcd',
      ),
      memorySource(rows(thirds[2]), 'c.xyz'),
    ];
    expect((await run(tiles)).plan).toEqual(plan);
    expect((await run(tiles.toReversed())).plan).toEqual(plan);
  });

  it('with every format that this test can write', () => {
    const written = Object.keys(FILES).map((name) => name.replace(/\.gz$/, '').split('.').pop());
    // LAZ and COPC: tests/unit/read/las/same-plan.test.ts, from files that laspy wrote; glTF is y up and sampled: mesh-plan.test.ts.
    const elsewhere = ['laz', 'copc', 'glb'];
    const missing = Object.entries(READ_FORMATS).filter(
      ([name, { extensions }]) =>
        !elsewhere.includes(name) && !extensions.some((extension) => written.includes(extension)),
    );
    expect(missing).toEqual([]);
  });

  it('to 2 mm where 32-bit floats rounded the coordinates', async () => {
    const shift = 1234.567;
    const moved = positions.map((value) => value + shift / 7);
    const exact = await run(memorySource(writePly({ positions: moved }, { type: 'double' }), 'a.ply'));
    const rounded = await run(memorySource(writePly({ positions: moved }), 'a.ply'));
    expect(largestStep(outline(exact), outline(rounded))).toBeLessThan(0.002);
  });
});

type Run = Awaited<ReturnType<typeof run>>;

/** The outline in source coordinates. */
function outline({ plan: { storeys, frame } }: Run): Polygon[] {
  const place = (ring: Float64Array) =>
    ring.map((value, i) => frame.planOrigin[i % 2] + value / frame.metresPerUnit);
  return storeys.flatMap(({ primary }) =>
    primary.map(({ outer, holes }) => ({ outer: place(outer), holes: holes.map(place) })),
  );
}

/** How far a vertex of either lies from the nearest of the other, at most. */
function largestStep(a: readonly Polygon[], b: readonly Polygon[]): number {
  const vertices = (polygons: readonly Polygon[]) =>
    polygons.flatMap(({ outer, holes }) =>
      [outer, ...holes].flatMap((ring) =>
        Array.from({ length: ring.length / 2 }, (_, i) => [ring[2 * i], ring[2 * i + 1]]),
      ),
    );
  const [u, v] = [vertices(a), vertices(b)];
  const reach = (from: number[][], to: number[][]) =>
    Math.max(...from.map(([x, y]) => Math.min(...to.map(([p, q]) => Math.hypot(p - x, q - y)))));
  return Math.max(reach(u, v), reach(v, u));
}
