import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Random } from '../../fixtures/simulator/random.ts';
import {
  cartesianFields,
  type E57Field,
  type E57ScanContent,
  e57Bytes,
  IGNORED_PACKET,
  INDEX_PACKET,
  integerField,
  withChecksums,
} from '../unit/read/e57-bytes.ts';
import { CORNERS, geoKeys, type LasContent, lasBytes, wktRecord } from '../unit/read/las/las-bytes.ts';
import { bytesOf } from '../unit/read/memory-source.ts';
import { mutateText } from './mutate-text.ts';
import { type Bytes, placesOf, type Seed, textOf } from './seed.ts';

export function fixture(name: string): Bytes {
  return new Uint8Array(readFileSync(fileURLToPath(new URL(`../../fixtures/${name}`, import.meta.url))));
}

/** Twenty places of no pattern in a room of 5 × 4 × 3 m. */
export const PLACES = Array.from(
  { length: 20 },
  (_, i) => [i % 5, ((i * 7) % 17) / 4, ((i * 3) % 13) / 4] as const,
);

const viewOf = (bytes: Uint8Array) => new DataView(bytes.buffer, bytes.byteOffset, bytes.length);

/** Fields of the header block: version, sizes, offsets, counts, scales, bounds. */
const LAS_FIELDS = [4, 6, 24, 25, 94, 96, 100, 104, 105, 107, 111, 131, 155, 179, 227, 235, 243, 247, 375];
const MOST_RECORD_MARKS = 40;

function lasSeed(name: string, bytes: Bytes): Seed {
  const view = viewOf(bytes);
  const pointsBegin = view.getUint32(96, true);
  const boundaries = [...LAS_FIELDS, pointsBegin, pointsBegin + 8, bytes.length - 8];
  let at = view.getUint16(94, true);
  for (let i = view.getUint32(100, true); i > 0 && at + 54 <= pointsBegin; i--) {
    boundaries.push(at, at + 18, at + 20, at + 54);
    at += 54 + view.getUint16(at + 20, true);
  }
  const isPacked = view.getUint8(104) > 63;
  const table = isPacked ? Number(view.getBigInt64(pointsBegin, true)) : bytes.length;
  const stride = view.getUint16(105, true);
  for (let i = 1; !isPacked && i < MOST_RECORD_MARKS; i++) boundaries.push(pointsBegin + i * stride);
  const isCopc = name.includes('.copc.');
  if (isPacked) boundaries.push(table, table + 4, table + 8);
  // What follows the chunks of a COPC file, its hierarchy, is read with the points.
  const end = isCopc ? bytes.length : table;
  if (isCopc) boundaries.push(...copcMarks(bytes));
  return {
    name,
    bytes,
    boundaries: boundaries.filter((mark) => mark > 0 && mark <= bytes.length),
    body: [pointsBegin + (isPacked ? 8 : 0), end],
    text: placesOf(bytes, 'CS[').length > 0 ? [[view.getUint16(94, true) + 54, pointsBegin]] : [],
    isRigid: true,
    ...(isCopc && { remake: (random: Random) => withCrookedTree(bytes, random) }),
  };
}

const COPC_INFO = 375 + 54;
const ENTRY_BYTES = 32;

/** Entries of the hierarchy's root page and what they point at. */
function copcMarks(bytes: Uint8Array): number[] {
  const info = viewOf(bytes.subarray(COPC_INFO));
  const root = Number(info.getBigUint64(40, true));
  const entries = Number(info.getBigUint64(48, true)) / ENTRY_BYTES;
  const marks = [COPC_INFO + 32, COPC_INFO + 40, COPC_INFO + 48];
  for (let i = 0; i < entries; i++) {
    const entry = root + i * ENTRY_BYTES;
    marks.push(entry, entry + 16, entry + 24, Number(viewOf(bytes).getBigUint64(entry + 16, true)));
  }
  return marks;
}

/** Entries that point at one another, at themselves, at other levels and at too much. */
function withCrookedTree(bytes: Bytes, random: Random): Bytes {
  const spoilt = bytes.slice();
  const view = viewOf(spoilt);
  const info = viewOf(bytes.subarray(COPC_INFO));
  const [root, size] = [Number(info.getBigUint64(40, true)), Number(info.getBigUint64(48, true))];
  const entry = () => root + ENTRY_BYTES * random.integer(0, size / ENTRY_BYTES - 1);
  for (let edits = random.integer(1, 3); edits > 0; edits--) {
    const at = entry();
    const edit = random.integer(0, 5);
    if (edit === 0) spoilt.copyWithin(at, entry(), root + size);
    if (edit === 1) view.setInt32(at, random.pick([-1, 0, 1, 2, 30, 31, 32, 2 ** 31 - 1]), true);
    if (edit === 2)
      view.setBigUint64(at + 16, random.pick([0n, BigInt(root), BigInt(bytes.length), 2n ** 62n]), true);
    if (edit === 3) view.setInt32(at + 24, random.pick([0, 1, 32, size, 2 ** 31 - 1, -1]), true);
    if (edit === 4) view.setInt32(at + 28, random.pick([-1, 0, 1, 1000, 2 ** 31 - 1, -2]), true);
    if (edit === 5) {
      view.setBigUint64(at + 16, BigInt(root), true);
      view.setInt32(at + 24, size, true);
      view.setInt32(at + 28, -1, true);
    }
  }
  return spoilt;
}

const COMPOUND =
  'COMPD_CS["a",PROJCS["b",GEOGCS["c",UNIT["degree",0.0174532925]],UNIT["US survey foot",0.304800609601219],AUTHORITY["EPSG","2222"]],VERT_CS["d",UNIT["metre",1]]]';
const ENGINEERING = 'ENGCRS["a",CS[cartesian,3],AXIS["x",east,LENGTHUNIT["yard",0.9144]]]';
const las = (name: string, content: Partial<LasContent>) =>
  lasSeed(name, lasBytes({ format: 3, minor: 2, points: CORNERS, ...content }));

export const LAS_SEEDS: readonly Seed[] = [
  ...['format-0.las', 'format-3.las', 'format-8.las'].map((name) =>
    lasSeed(name, fixture(`foreign/${name}`)),
  ),
  las('keys.las', { records: [geoKeys({ 1024: 1, 3072: 31_467, 3076: 9002, 4099: 9001 })] }),
  las('wkt.las', { format: 8, minor: 4, hasWkt: true, records: [wktRecord(COMPOUND)] }),
  las('behind.las', { format: 6, minor: 4, extended: [wktRecord(ENGINEERING)], hasWkt: true, extraBytes: 3 }),
  las('geocentric.las', {
    format: 7,
    minor: 4,
    hasWkt: true,
    records: [wktRecord('GEODCRS["w",CS[Cartesian,3]]')],
  }),
  las('withheld.las', {
    format: 1,
    minor: 3,
    points: CORNERS.map((point, i) => ({ ...point, isWithheld: i > 4 })),
  }),
  las('degrees.las', {
    format: 2,
    minor: 0,
    records: [geoKeys({ 1024: 2, 2048: 4326 })],
    bounds: [
      [8, 50, 0],
      [500, 800, 9],
    ],
  }),
];

export const LAZ_SEEDS: readonly Seed[] = [
  ...[0, 1, 2, 3, 6, 7, 8].map((format) => `format-${format}.laz`),
  ...['chunks-1.laz', 'chunks-6.laz', 'chunks-9.laz', 'chunks-10.laz', 'variable-3.laz', 'variable-7.laz'],
].map((name) => lasSeed(name, fixture(`foreign/${name}`)));

export const COPC_SEEDS: readonly Seed[] = [lasSeed('octree.copc.laz', fixture('foreign/octree.copc.laz'))];

const E57_FIELDS = [8, 12, 16, 24, 32, 40, 48];
const PAGE_BYTES = 1024;

function e57Seed(name: string, bytes: Bytes, remake?: (random: Random) => Bytes): Seed {
  const xmlAt = Number(viewOf(bytes).getBigUint64(24, true));
  const sections = [...textOf(bytes).matchAll(/fileOffset="(\d+)"/g)].map((match) => Number(match[1]));
  const tags = placesOf(bytes, '<').filter((at) => at >= xmlAt);
  const marks = sections.flatMap((at) => [at, at + 8, at + 16, at + 32, at + 34, at + 36, at + 38]);
  const pages = Array.from({ length: bytes.length / PAGE_BYTES }, (_, i) => PAGE_BYTES * i);
  return {
    name,
    bytes,
    boundaries: [...E57_FIELDS, ...marks, ...pages, ...pages.map((at) => at + PAGE_BYTES - 4), ...tags],
    body: [48, Math.floor(xmlAt / PAGE_BYTES) * PAGE_BYTES || xmlAt],
    text: [],
    isRigid: true,
    // Checksums make all damage look the same: most files get theirs put right.
    repair: (spoilt) => withChecksums(spoilt),
    ...(remake && { remake }),
  };
}

const scaled: E57Field = {
  name: 'cartesianZ',
  prototype: 'type="ScaledInteger" minimum="-100" maximum="3000" scale="0.001" offset="1"',
  values: PLACES.map(([, , z]) => Math.round(1000 * z) + 100),
  bits: 12,
};
const single = (name: string, values: readonly number[]): E57Field => ({
  name,
  prototype: 'type="Float" precision="single" minimum="0" maximum="4"',
  values,
  bits: 32,
  isFloat: true,
});
const column = (axis: 0 | 1 | 2) => PLACES.map((place) => place[axis]);
const POSE =
  '<pose type="Structure"><rotation type="Structure"><w type="Float">0.8</w><z type="Float">6e-1</z></rotation><translation type="Structure"><x type="Float">1</x><y type="Float">20</y></translation></pose>';
const LIMITS =
  '<intensityLimits type="Structure"><intensityMinimum type="Integer">0</intensityMinimum><intensityMaximum type="Integer">9</intensityMaximum></intensityLimits>';

const E57_CONTENTS: readonly E57ScanContent[] = [
  {
    fields: [...cartesianFields(PLACES).slice(0, 2), scaled, integerField('intensity', 0, 9, column(0))],
    xml: POSE + LIMITS,
  },
  {
    fields: [
      single('sphericalRange', column(1)),
      single('sphericalAzimuth', column(0)),
      single('sphericalElevation', column(2)),
      integerField(
        'sphericalInvalidState',
        0,
        2,
        column(0).map((x) => (x === 4 ? 2 : 0)),
      ),
      ...['colorRed', 'colorGreen', 'colorBlue'].map((name) => integerField(name, 0, 255, column(0))),
    ],
  },
  {
    fields: [
      ...['cartesianX', 'cartesianY'].map((name, i) =>
        integerField(name, -(2 ** 20), 2 ** 30, column(i as 0).map(Math.round)),
      ),
      integerField(
        'cartesianZ',
        2,
        2,
        column(2).map(() => 2),
      ),
      integerField('classification', 0, 31, column(0)),
      { name: 'label', prototype: 'type="String"', values: [], bits: 0 },
    ],
  },
];

/** A file whose words are spoilt before it is made: offsets and checksums are right. */
function remakeE57(random: Random): Bytes {
  const scans = Array.from({ length: random.integer(1, 3) }, () => {
    const scan = random.pick(E57_CONTENTS);
    const die = random.integer(0, 5);
    const spoil = <T>(list: readonly T[], make: (item: T) => T) => {
      const chosen = random.integer(0, list.length - 1);
      return list.map((item, i) => (i === chosen ? make(item) : item));
    };
    const fields = spoil(scan.fields, (field) => {
      if (die === 0)
        return { ...field, prototype: mutateText(field.prototype, random).replace(/[<>&]/g, '') };
      if (die === 1)
        return {
          ...field,
          bits: random.pick([1, 7, 13, 31, 63]),
          isFloat: false,
          values: field.values.map(() => 1),
        };
      if (die === 2)
        return { ...field, values: field.values.slice(0, random.integer(0, field.values.length)) };
      return field;
    });
    const xml = die === 3 ? mutateText(scan.xml ?? POSE, random) : scan.xml;
    const recordCount = die === 4 ? random.pick([0, 1, 19, 21, 1000, 2 ** 31, 2 ** 53 - 1]) : undefined;
    return {
      fields: die === 5 && random.chance(0.5) ? fields.slice(1) : fields,
      ...(xml && { xml }),
      ...(recordCount !== undefined && { recordCount }),
    };
  });
  return e57Bytes(scans, {
    packets: random.integer(1, 3),
    between: random.pick([[], [INDEX_PACKET], [IGNORED_PACKET, INDEX_PACKET]]),
    xml: random.chance(0.1)
      ? mutateText('<formatName type="String"><![CDATA[a]]></formatName><!-- b --><e a="1"/>', random)
      : '',
  });
}

export const E57_SEEDS: readonly Seed[] = [
  e57Seed('two-scans.e57', fixture('foreign/two-scans.e57')),
  e57Seed('packed-spherical.e57', fixture('foreign/packed-spherical.e57')),
  e57Seed(
    'built.e57',
    e57Bytes(E57_CONTENTS, { packets: 2, between: [INDEX_PACKET, IGNORED_PACKET] }),
    remakeE57,
  ),
  e57Seed('one.e57', e57Bytes(E57_CONTENTS.slice(1, 2)), remakeE57),
];

export const NOTE = bytesOf('Dear Sir,\nin 2019 there were 3 rooms.\n') as Bytes;
