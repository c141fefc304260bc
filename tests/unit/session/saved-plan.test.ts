import fc from 'fast-check';
import { gzipSync, zipSync } from 'fflate';
import { beforeAll, describe, expect, it } from 'vitest';
import { simulate, writePly } from '../../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../../fixtures/simulator/layouts.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { makeNodeCanvas } from '../../../src/cli/node-canvas.ts';
import { FloorPlanError } from '../../../src/core/errors.ts';
import { sourceCoordinates } from '../../../src/core/source-coordinates.ts';
import type { Polygon } from '../../../src/core/types.ts';
import type { ByteSource } from '../../../src/read/bytes/source.ts';
import { makeReport } from '../../../src/session/report.ts';
import { isOfScan } from '../../../src/session/result.ts';
import { Session } from '../../../src/session/session.ts';
import { makeView } from '../../../src/worker/view.ts';
import { WRITE_FORMAT_NAMES } from '../../../src/write/formats.ts';
import { labelPoint } from '../../../src/write/sheet/label-point.ts';
import { memorySource } from '../read/memory-source.ts';

/** Formats that draw what the stages before the plan made. */
const OF_POINTS: readonly string[] = ['slice', 'pictures', 'glb-points'];

const newSession = () => new Session({ strokeTest: createStrokeTest(), makeCanvas: makeNodeCanvas });
const contents = async (session: Session, format: string) =>
  (await session.write(format)).map(({ name, content }) => [name, content]);
const open = async (text: string | Uint8Array, given = {}, name = 'plan.json') => {
  const session = newSession();
  return { session, result: await session.load(memorySource(text, name), given) };
};

/** A place in a room: source units and coordinates, to the millimetre. */
function placeIn(outline: Polygon): number[] {
  const [x, y] = labelPoint(outline);
  const to = sourceCoordinates(scanned.result!.plan.frame);
  return [to.x(x), to.y(y)].map((value) => Number(value.toFixed(3)));
}

let scanned: Session;
let scanFile: ByteSource;
let saved = '';

beforeAll(async () => {
  const pose = { origin: [691_880, 5_336_026, 520], heading: 0.3 } as const;
  const scan = { voxel: 0.08, raysPerStation: 20_000 };
  const { positions } = simulate({ name: 'home', building: homeBuilding(11, { shape: 'L' }), scan, pose });
  scanned = newSession();
  scanFile = memorySource(writePly({ positions }, { type: 'double' }), 'home.ply');
  await scanned.load(scanFile, { unit: 'm' });
  saved = (await scanned.write('json'))[0].content as string;
});

describe('a plan.json opened again', () => {
  it('is written as the same bytes, in every format that needs no points', async () => {
    const { session, result } = await open(saved);
    expect(result.plan.storeys[0].rooms.length).toBeGreaterThan(2);
    // Nor has the scan a way to WGS 84; a ZIP holds the slice too.
    const others = [...OF_POINTS, 'geojson-wgs84', 'zip'];
    const formats = WRITE_FORMAT_NAMES.filter((name) => !others.includes(name));
    for (const format of formats) {
      expect(await contents(session, format), format).toEqual(await contents(scanned, format));
    }
    expect(isOfScan(result)).toBe(false);
    expect(isOfScan(scanned.result!)).toBe(true);
    expect(result.warnings).toEqual(result.plan.warnings);
  });

  it('keeps what was changed after the plan was made', async () => {
    const before = newSession();
    const points = memorySource(saved, 'plan.json');
    await before.load(points);
    await before.update({ floorSlab: false, ceilingSlab: true });
    const text = (await before.write('json'))[0].content as string;
    const { session } = await open(text);
    expect(await contents(session, 'glb')).toEqual(await contents(before, 'glb'));
    expect(await contents(session, 'json')).toEqual(await contents(before, 'json'));
    expect(await contents(session, 'glb')).not.toEqual(await contents(scanned, 'glb'));
  });

  it('so does a scan', async () => {
    const positions = Float64Array.from({ length: 3 * 4000 }, (_, i) => {
      const [along, side] = [Math.floor(i / 3) % 50, Math.floor(i / 150) % 4];
      const [x, y] = [
        [along, 0],
        [50, along],
        [50 - along, 50],
        [0, 50 - along],
      ][side];
      return [x / 10, y / 10, ((i / 600) % 20) / 8][i % 3];
    });
    const session = newSession();
    await session.load(memorySource(writePly({ positions }), 'box.ply'), { unit: 'm', up: 'z' });
    await session.update({ unit: 'm', up: 'z', floorSlab: false });
    expect(session.result!.plan.options.floorSlab).toBe(false);
  });

  it('takes the parameters of the model, and a height of its walls', async () => {
    const { session, result } = await open(saved, { wallHeight: 3.5 });
    expect(result.plan.storeys.map(({ height }) => height)).toEqual([3.5]);
    expect(result.plan.options.wallHeight).toBe(3.5);
    const again = await session.update({ floorSlab: false });
    expect(again.plan.storeys[0].height).toBe(scanned.result!.plan.storeys[0].height);
    expect(again.solid.groups.some(({ kind }) => kind === 'floor')).toBe(false);
  });

  it('takes names of its rooms, and keeps those it came with', async () => {
    const rooms = scanned.result!.plan.storeys[0].rooms.slice(0, 2).map(({ outline }) => placeIn(outline));
    const [hall, bath] = rooms.map(([x, y], i) => `${x},${y}=${['Hall', 'Bath 🛁'][i]}`);
    const { session, result } = await open(saved, { roomNames: `${hall};0,0=Nowhere` });
    const named = (run: typeof result) => run.plan.storeys[0].rooms.slice(0, 3).map(({ name }) => name);
    expect(named(result)).toEqual(['Hall', 'Room 2', 'Room 3']);
    expect(result.warnings.map(({ code }) => code)).toEqual([
      ...scanned.result!.warnings.map(({ code }) => code),
      'plan/no-such-room',
    ]);
    expect(result.plan.warnings).toEqual(result.warnings);
    const text = (await session.write('json'))[0].content as string;
    const again = await open(text);
    expect(named(again.result)).toEqual(['Hall', 'Room 2', 'Room 3']);
    expect(again.result.plan.warnings.map(({ code }) => code)).toContain('plan/no-such-room');
    const other = await again.session.update({ roomNames: bath });
    expect(named(other)).toEqual(['Hall', 'Bath 🛁', 'Room 3']);
    // Names given before are given still.
    expect(other.options.roomNames).toBe(`${hall};0,0=Nowhere;${bath}`);
    expect(other.plan.warnings).toEqual(result.warnings);
    const unseen = other.plan.storeys[0].gaps.map(({ room }) => room);
    expect(unseen).not.toContain('Room 1');
    expect(named(await again.session.update({}))).toEqual(['Hall', 'Room 2', 'Room 3']);
  });

  it('is named as the scan is', async () => {
    const [x, y] = placeIn(scanned.result!.plan.storeys[0].rooms[1].outline);
    const given = { roomNames: `${x},${y}=Küche; "a" <b>`.replace(';', ';;') };
    const { session } = await open(saved, given);
    const fromScan = newSession();
    await fromScan.load(scanFile, { unit: 'm', ...given });
    expect(fromScan.result!.plan.storeys[0].rooms[1].name).toBe('Küche; "a" <b>');
    for (const format of ['svg', 'dxf', 'ifc', 'geojson', 'rooms', 'rooms-xlsx', 'glb', 'json']) {
      expect(await contents(session, format), format).toEqual(await contents(fromScan, format));
    }
    const [, csv] = (await contents(session, 'rooms'))[0];
    expect(csv).toContain('"Küche; ""a"" <b>"');
  });

  it('of outlines says that it has no rooms to name', async () => {
    const outlines = await scanned.compare({ unit: 'm', planMethod: 'outline', roomNames: '0,0=Hall' });
    expect(outlines.plan.warnings.map(({ code }) => code)).toContain('plan/no-such-room');
  });

  it('says which parameters need the scan', async () => {
    const { session, result } = await open(saved, { openingLength: 1, unit: 'm', floorSlab: false });
    expect(result.warnings.map(({ code }) => code)).toContain('plan/needs-scan');
    const { message } = result.warnings.find(({ code }) => code === 'plan/needs-scan')!;
    expect(message).toContain('openingLength');
    expect(message).not.toContain('unit');
    expect(result.plan.warnings).toEqual(scanned.result!.plan.warnings);
    const { warnings } = await session.update({});
    expect(warnings.map(({ code }) => code)).not.toContain('plan/needs-scan');
    await expect(session.update({ wallHeight: -1 })).rejects.toMatchObject({ code: 'option/invalid' });
  });

  it('says that it has no points to write or to compare with', async () => {
    const { session } = await open(saved);
    const slice = (async () => session.write('slice'))();
    await expect(slice).rejects.toMatchObject({ code: 'result/cannot-write' });
    expect((await session.write('pictures')).map(({ name }) => name)).toEqual([
      'picture-14-plan.svg',
      'picture-15-model.svg',
    ]);
    await expect(session.compare({ boundary: 'convex' })).rejects.toMatchObject({ code: 'input/empty' });
  });

  it('is reported and shown as the plan of its scan', async () => {
    const { session, result } = await open(saved);
    const [own, first] = [makeReport(result, 0), makeReport(scanned.result!, 0)];
    expect(own).toMatchObject({ rooms: first.rooms, mesh: first.mesh, secondary: first.secondary });
    const { bounds, ...input } = own.input;
    const { bounds: wanted, stations: _, ...facts } = first.input;
    expect(input).toEqual({ ...facts, stations: [] });
    for (let axis = 0; axis < 3; axis++) {
      expect(bounds.min[axis]).toBeCloseTo(wanted.min[axis], -1);
      expect(bounds.max[axis]).toBeCloseTo(wanted.max[axis], -1);
    }
    const { view, transfer } = makeView(session, [], 0);
    expect(() => structuredClone(view, { transfer })).not.toThrow();
    expect(view).toMatchObject({ isSavedPlan: true, isSlice: false, levels: [] });
    expect(view.surroundings.max[0]).toBeGreaterThan(view.surroundings.min[0]);
    expect(result.stages.map(({ name }) => name).slice(0, 2)).toEqual(['plan', 'solid']);
  });

  it.each<[string, (text: string) => string | Uint8Array]>([
    ['with a byte order mark', (text) => `\uFEFF${text}`],
    ['laid out by an editor', (text) => JSON.stringify(JSON.parse(text), null, 4)],
    ['gzipped', (text) => gzipSync(new TextEncoder().encode(text))],
    ['alone in a ZIP', (text) => zipSync({ 'out/plan.json': new TextEncoder().encode(text) })],
    [
      'in a ZIP of all that was written',
      (text) => {
        const others = { 'slice.csv': 'x,y\n1,2\n', 'plan.frame.json': '{"version":1}' };
        const entries = Object.entries({ ...others, 'plan.json': text });
        return zipSync(
          Object.fromEntries(entries.map(([name, file]) => [name, new TextEncoder().encode(file)])),
        );
      },
    ],
  ])('is known %s', async (_, packed) => {
    const { session } = await open(packed(saved), {}, 'upload');
    expect(await contents(session, 'json')).toEqual(await contents(scanned, 'json'));
  });

  it('keeps a name that was changed in it', async () => {
    const name = '<script>"&]]> 🏠 غرفة';
    const draft = JSON.parse(saved);
    draft.storeys[0].rooms[0].name = name;
    const { session } = await open(JSON.stringify(draft));
    const [{ content }] = await session.write('geojson');
    const { features } = JSON.parse(content as string);
    expect(
      features.some((feature: { properties: { name?: string } }) => feature.properties.name === name),
    ).toBe(true);
  });

  it('says which of its outlines are none, and which names are cut', async () => {
    const plan = JSON.parse(saved);
    const [storey] = plan.storeys;
    storey.rooms[0].outline.outer = [
      [0, 0],
      [1, 0],
      [2, 0],
    ];
    storey.rooms[1].name = 'x'.repeat(10_000);
    const { result } = await open(JSON.stringify(plan));
    const codes = result.warnings.map(({ code }) => code);
    expect(codes).toEqual(expect.arrayContaining(['sheet/name-cut', 'plan/unsound-outline']));
    const { message } = result.warnings.find(({ code }) => code === 'plan/unsound-outline')!;
    expect(message).toContain('storeys[0].rooms[0]');
    expect((await open(saved)).result.warnings.map(({ code }) => code)).not.toContain('plan/unsound-outline');
  });

  it('is no part of a scan', async () => {
    const plan = () => memorySource(saved, 'plan.json');
    await expect(newSession().load([plan(), plan()])).rejects.toMatchObject({
      code: 'input/unknown-format',
      hint: expect.stringContaining('by itself'),
    });
  });

  it('leaves the plan before where it is damaged', async () => {
    const { session, result } = await open(saved);
    const half = memorySource(saved.slice(0, saved.length / 2), 'plan.json');
    await expect(session.load(half)).rejects.toMatchObject({ code: 'input/malformed' });
    const bytes = new TextEncoder().encode(saved);
    bytes[bytes.length - 9] = 0xff;
    await expect(session.load(memorySource(bytes, 'plan.json'))).rejects.toMatchObject({
      code: 'input/malformed',
      message: expect.stringContaining('UTF-8'),
    });
    expect(session.result).toBe(result);
  });
});

/** Every place in a document, as the keys that lead there. */
function placesOf(value: unknown, keys: readonly string[] = []): (readonly string[])[] {
  if (typeof value !== 'object' || value === null) return [keys];
  return [keys, ...Object.entries(value).flatMap(([key, item]) => placesOf(item, [...keys, key]))];
}

const HOSTILE = [
  null,
  true,
  -1,
  0,
  0.5,
  1e-300,
  1e6,
  1e308,
  '',
  'door',
  '__proto__',
  [],
  {},
  [[0, 0]],
  [null],
];

it('a hostile plan is shown, written, or refused by name', async () => {
  const small = JSON.parse(saved);
  for (const storey of small.storeys) {
    for (const key of ['walls', 'rooms', 'openings', 'gaps']) storey[key] = storey[key].slice(0, 3);
  }
  const places = placesOf(small).filter((keys) => keys.length > 0);
  const change = fc.record({ place: fc.nat(places.length - 1), value: fc.constantFrom(...HOSTILE) });
  let refused = 0;
  let runs = 0;
  await fc.assert(
    fc.asyncProperty(fc.array(change, { minLength: 1, maxLength: 3 }), async (changes) => {
      const draft = structuredClone(small);
      for (const { place, value } of changes) {
        const keys = places[place];
        const parent = keys.slice(0, -1).reduce((at, key) => at?.[key], draft);
        if (typeof parent === 'object' && parent !== null) parent[keys.at(-1)!] = value;
      }
      runs++;
      try {
        const { session } = await open(JSON.stringify(draft).replaceAll('1e+308', '1e999'));
        for (const format of ['svg', 'geojson', 'glb', 'dxf', 'rooms', 'json']) await session.write(format);
      } catch (error) {
        if (!(error instanceof FloorPlanError)) throw error;
        refused++;
      }
    }),
    { numRuns: 150 },
  );
  expect(refused).toBeGreaterThan(runs / 4);
  expect(refused).toBeLessThan(runs);
});
