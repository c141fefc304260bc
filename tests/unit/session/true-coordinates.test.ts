import { describe, expect, it } from 'vitest';
import { writePly } from '../../../fixtures/simulator/index.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import type { GivenValues } from '../../../src/core/params.ts';
import type { ByteSource } from '../../../src/read/bytes/source.ts';
import { makeReport } from '../../../src/session/report.ts';
import { Session } from '../../../src/session/session.ts';
import { roomPoints } from '../core/made-scan.ts';
import { cartesianFields, e57Bytes } from '../read/e57-bytes.ts';
import { geoKeys, type LasContent, type LasPoint, lasBytes, wktRecord } from '../read/las/las-bytes.ts';
import { memorySource } from '../read/memory-source.ts';
import { parseXml } from '../write/drawing/strict-xml.ts';

/** What a written coordinate may be off by, m. */
const WRITTEN = 1e-4;
/** A room without noise and without inward corners: its outline is the truth. */
const OUTLINE = [0, 0, 7, 0, 6.2, 5, 0, 4.1];
const ROOM = roomPoints({ corners: OUTLINE, noise: 0 });
/** The radial pass may take a corner's own vertex; how corners are found is not what is tested here. */
const CORNERS_KEPT = { radialPass: false };
const FOOT = 0.3048;
const SURVEY_FOOT = 1200 / 3937;
const HEADING = 0.3;

type Pair = readonly [x: number, y: number];
type Corner = (x: number, y: number) => Pair;

interface Place {
  readonly at: readonly [x: number, y: number, z: number];
  /** Metres a unit. */
  readonly unit: number;
}

/** Where the place's plan corners lie, source units. */
const placed =
  ({ at, unit }: Place): Corner =>
  (x, y) => [
    at[0] + (x * Math.cos(HEADING) - y * Math.sin(HEADING)) / unit,
    at[1] + (x * Math.sin(HEADING) + y * Math.cos(HEADING)) / unit,
  ];

function scanAt(place: Place): Float64Array {
  const corner = placed(place);
  const source = new Float64Array(ROOM.length);
  for (let i = 0; i < ROOM.length; i += 3) {
    source.set([...corner(ROOM[i], ROOM[i + 1]), place.at[2] + ROOM[i + 2] / place.unit], i);
  }
  return source;
}

async function filesOf(source: ByteSource, given: GivenValues = {}) {
  const session = new Session({ strokeTest: createStrokeTest() });
  const result = await session.load(source, { ...given, ...CORNERS_KEPT });
  const formats = ['geojson', 'dxf', 'svg', 'minimal-svg', 'slice', 'json', 'frame', 'glb'];
  const files = new Map<string, string | Uint8Array<ArrayBuffer>>();
  for (const format of formats) files.set(format, (await session.write(format))[0].content);
  const text = (format: string) => files.get(format) as string;
  return { result, text, glb: files.get('glb') as Uint8Array<ArrayBuffer> };
}

/** The outline's corners as each file has them: source units and coordinates, seen from above. */
const CORNERS: Readonly<Record<string, (text: (format: string) => string) => Pair[]>> = {
  geojson: (text) => {
    const { features } = JSON.parse(text('geojson'));
    const outline = features.find(
      (one: { properties: { kind: string } }) => one.properties.kind === 'primary-boundary',
    );
    return outline.geometry.coordinates[0].slice(0, -1);
  },
  dxf: (text) => {
    const lines = text('dxf').split('\n');
    const entity = lines.findIndex(
      (line, i) => line === 'A-FLOR-OTLN' && lines[i - 1].trim() === '8' && lines[i + 2] === 'AcDbPolyline',
    );
    const places: Pair[] = [];
    for (let i = entity + 3; lines[i].trim() !== '0'; i += 2) {
      if (lines[i].trim() === '10') places.push([Number(lines[i + 1]), Number(lines[i + 3])]);
    }
    return places;
  },
  'plan.svg by its metadata': (text) => {
    const svg = parseXml(text('svg'));
    const { sheet } = JSON.parse(svg.byId('frame')?.text ?? '');
    return pathPlaces(svg.byId('walls')?.all('path')[0].getAttribute('d') ?? '', sheet.sheetToSource);
  },
  'plan.svg by its sidecar': (text) => {
    const { sheet } = JSON.parse(text('frame'));
    const walls = parseXml(text('svg')).byId('walls');
    return pathPlaces(walls?.all('path')[0].getAttribute('d') ?? '', sheet.sheetToSource);
  },
  'plan.minimal.svg by its sidecar': (text) => {
    const { minimal } = JSON.parse(text('frame'));
    return pathPlaces(
      parseXml(text('minimal-svg')).byId('walls')?.getAttribute('d') ?? '',
      minimal.svgToSource,
    );
  },
  'plan.json': (text) => {
    const { frame, storeys } = JSON.parse(text('json'));
    return storeys[0].primary[0].outer.map(([x, y]: Pair) => [
      frame.planOrigin[0] + x / frame.metresPerUnit,
      frame.planOrigin[1] + y / frame.metresPerUnit,
    ]);
  },
};

/** Every place named in a path of absolute moves and lines, through a map as SVG's matrix() has it. */
function pathPlaces(path: string, [a, b, c, d, e, f]: readonly number[]): Pair[] {
  return [...path.matchAll(/[ML]([-\d.]+) ([-\d.]+)/g)].map(([, u, v]): Pair => {
    const [x, y] = [Number(u), Number(v)];
    return [a * x + c * y + e, b * x + d * y + f];
  });
}

const nearest = (places: readonly Pair[], [x, y]: Pair) =>
  Math.min(...places.map(([u, v]) => Math.hypot(u - x, v - y)));

const TRUE_CORNERS = Array.from(
  { length: OUTLINE.length / 2 },
  (_, i) => [OUTLINE[2 * i], OUTLINE[2 * i + 1]] as const,
);

describe.each<[string, Place, GivenValues]>([
  ['UTM', { at: [691_000.1234, 5_334_000.4567, 512.3456], unit: 1 }, {}],
  ['the south-west end of a UTM zone', { at: [166_021.4433, 0.0001, 0], unit: 1 }, {}],
  [
    'the north-east end of a southern UTM zone',
    { at: [833_978.5567, 9_999_999.9999, 8848.8611], unit: 1 },
    {},
  ],
  ['a site grid', { at: [-9_999.9876, 10_000.1234, -431.5], unit: 1 }, {}],
  ['UTM in millimetres', { at: [691_000_123.4, 5_334_000_456.7, 512_345.6], unit: 0.001 }, { unit: 'mm' }],
  ['state plane, feet', { at: [2_000_000.1234, 700_000.4567, 1200.5], unit: FOOT }, { unit: 'ft' }],
  [
    'state plane, survey feet',
    { at: [6_561_666.6667, 2_100_000.3333, 1200.5], unit: SURVEY_FOOT },
    { unit: 'us-ft' },
  ],
])('%s', async (_, place, given) => {
  const scan = scanAt(place);
  const { result, text, glb } = await filesOf(
    memorySource(writePly({ positions: scan }, { type: 'double' }), 'room.ply'),
    given,
  );
  const limit = WRITTEN / place.unit;
  const corner = placed(place);

  it.each(Object.keys(CORNERS))('%s has the true corners', (name) => {
    const places = CORNERS[name](text);
    for (const [x, y] of TRUE_CORNERS) expect(nearest(places, corner(x, y))).toBeLessThan(limit);
  });

  it('slice.csv has points of the scan', () => {
    const lines = text('slice').trim().split('\n').slice(1);
    expect(lines.length).toBeGreaterThan(100);
    const scanned: Pair[] = [];
    for (let i = 0; i < scan.length; i += 3) scanned.push([scan[i], scan[i + 1]]);
    for (let i = 0; i < lines.length; i += 97) {
      const [x, y] = lines[i].split(',').map(Number);
      expect(nearest(scanned, [x, y])).toBeLessThan(limit);
    }
  });

  it('report.json has its bounds', () => {
    const { bounds } = JSON.parse(JSON.stringify(makeReport(result, 0))).input;
    for (let axis = 0; axis < 3; axis++) {
      const own = scan.filter((_value, i) => i % 3 === axis);
      expect(bounds.min[axis]).toBe(own.reduce((a, b) => Math.min(a, b)));
      expect(bounds.max[axis]).toBe(own.reduce((a, b) => Math.max(a, b)));
    }
  });

  it('plan.glb is small numbers about a float64 origin', () => {
    const { frame, places, largest } = readGlb(glb);
    expect(largest).toBeLessThan(10);
    const inSource = places.map(([x, y, z]): Pair => {
      // glTF is y up: its z is the plan's backwards.
      expect(Number.isFinite(y)).toBe(true);
      return [frame.planOrigin[0] + x / frame.metresPerUnit, frame.planOrigin[1] - z / frame.metresPerUnit];
    });
    for (const [x, y] of TRUE_CORNERS) expect(nearest(inSource, corner(x, y))).toBeLessThan(limit);
    const lowest = Math.min(...places.map(([, y]) => y));
    const slab = result.plan.options.slabThickness;
    const floor = frame.origin[2] + (lowest + slab) / frame.metresPerUnit;
    expect(Math.abs(floor - place.at[2])).toBeLessThan(limit);
  });
});

/** Ten kilobytes with all that XML, JSON and DXF have to escape. */
const LONG_WKT = `PROJCS["Gauß-Krüger <&> 'site' ^1",REMARK["${'a "b"'.replaceAll('"', '""')} ${'Lorem ipsum 中 '.repeat(700)}"],UNIT["US survey foot",0.304800609601219]]`;
const LAS_PLACE: Place = { at: [6_561_666.625, 2_100_000.25, 1200.5], unit: SURVEY_FOOT };

/** A LAS file of the room, in steps of 0.0001 ft, that states its coordinate system. */
function lasRoom(content: Partial<LasContent>): Uint8Array {
  const scan = scanAt(LAS_PLACE);
  const points: LasPoint[] = [];
  for (let i = 0; i < scan.length; i += 3) {
    const [x, y, z] = LAS_PLACE.at.map((value, axis) => Math.round((scan[i + axis] - value) * 1e4));
    points.push({ at: [x, y, z] });
  }
  return lasBytes({
    format: 6,
    minor: 4,
    points,
    scale: [1e-4, 1e-4, 1e-4],
    offset: LAS_PLACE.at,
    ...content,
  });
}

function e57Room(crs: string): Uint8Array {
  const scan = scanAt({ at: [691_000.1234, 5_334_000.4567, 512.3456], unit: 1 });
  const points = Array.from({ length: scan.length / 3 }, (_, i) => [...scan.subarray(3 * i, 3 * i + 3)]);
  const text = crs.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
  return e57Bytes([{ fields: cartesianFields(points) }], {
    packets: 60,
    xml: `<coordinateMetadata type="String">${text}</coordinateMetadata>`,
  });
}

describe.each<[string, string, Uint8Array, string, string]>([
  [
    'EPSG by GeoTIFF keys',
    'room.las',
    lasRoom({ records: [geoKeys({ 1024: 1, 3072: 2263, 3076: 9003 })] }),
    'us-ft',
    'EPSG:2263',
  ],
  ['WKT of 10 kB', 'room.las', lasRoom({ records: [wktRecord(LONG_WKT)], hasWkt: true }), 'us-ft', LONG_WKT],
  ['WKT of 10 kB in E57', 'room.e57', e57Room(LONG_WKT), 'm', LONG_WKT],
])('%s travels', async (_, name, bytes, unit, crs) => {
  const { result, text, glb } = await filesOf(memorySource(bytes, name));
  const facts = { unit, crs };

  it('into GeoJSON, SVG, sidecar, plan.json and GLB, with the unit', () => {
    expect(JSON.parse(text('geojson')).frame).toMatchObject(facts);
    expect(JSON.parse(parseXml(text('svg')).byId('frame')?.text ?? '')).toMatchObject(facts);
    expect(JSON.parse(text('frame'))).toMatchObject(facts);
    expect(JSON.parse(text('json')).frame).toMatchObject(facts);
    expect(readGlb(glb).frame).toMatchObject({ ...facts, up: 'z' });
    expect(result.warnings.filter(({ code }) => code.startsWith('frame/unit'))).toEqual([]);
  });

  it('into comments of the DXF, none of them too long', () => {
    const lines = text('dxf').split('\n');
    const comments: string[] = [];
    for (let i = 0; lines[i].trim() === '999'; i += 2) comments.push(lines[i + 1]);
    expect(comments.every(({ length }) => length <= 255)).toBe(true);
    const told = comments
      .join('')
      .replace(/\\U\+([0-9A-F]{4})/g, (_escape, code) => String.fromCharCode(Number.parseInt(code, 16)))
      .replaceAll('^ ', '^');
    expect(told).toBe(`Coordinate system: ${crs}`);
    expect(lines.slice(2 * comments.length, 2 * comments.length + 2)).toEqual(['  0', 'SECTION']);
  });
});

it('survey feet stay survey feet: 2 ppm are 4 m at a state plane', async () => {
  const { text } = await filesOf(
    memorySource(lasRoom({ records: [geoKeys({ 1024: 1, 3072: 2263, 3076: 9003 })] }), 'room.las'),
  );
  const corner = placed(LAS_PLACE);
  for (const name of ['geojson', 'dxf', 'plan.svg by its sidecar']) {
    const places = CORNERS[name](text);
    for (const [x, y] of TRUE_CORNERS)
      expect(nearest(places, corner(x, y))).toBeLessThan(WRITTEN / SURVEY_FOOT);
  }
  expect(JSON.parse(text('json')).frame.metresPerUnit).toBe(SURVEY_FOOT);
});

function readGlb(glb: Uint8Array<ArrayBuffer>) {
  const view = new DataView(glb.buffer, glb.byteOffset);
  const jsonBytes = view.getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + jsonBytes)));
  const places: number[][] = [];
  for (const { primitives } of gltf.meshes) {
    const { bufferView, byteOffset, count } = gltf.accessors[primitives[0].attributes.POSITION];
    const at = 28 + jsonBytes + gltf.bufferViews[bufferView].byteOffset + byteOffset;
    for (let i = 0; i < count; i++)
      places.push([0, 4, 8].map((axis) => view.getFloat32(at + 12 * i + axis, true)));
  }
  const largest = Math.max(...places.flat().map(Math.abs));
  return { frame: gltf.asset.extras.frame, places, largest };
}
