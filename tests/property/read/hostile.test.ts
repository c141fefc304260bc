import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { gzipSync, zipSync } from 'fflate';
import { expect, it } from 'vitest';
import { FloorPlanError } from '../../../src/core/errors.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import type { ByteSource } from '../../../src/read/bytes/source.ts';
import { READ_FORMAT_NAMES, READ_FORMATS } from '../../../src/read/formats.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import {
  cartesianFields,
  e57Bytes,
  INDEX_PACKET,
  integerField,
  withChecksums,
} from '../../unit/read/e57-bytes.ts';
import { glbBytes, layOut } from '../../unit/read/glb-bytes.ts';
import { CORNERS, geoKeys, lasBytes, wktRecord } from '../../unit/read/las/las-bytes.ts';
import { bytesOf, memorySource } from '../../unit/read/memory-source.ts';
import { pcdBytes } from '../../unit/read/pcd-bytes.ts';
import { plyBytes } from '../../unit/read/ply-bytes.ts';
import { ptxHeader } from '../../unit/read/ptx-text.ts';

const OPTIONS = resolveOptions({ pointBudget: 1_000 });
const records = Array.from({ length: 20 }, (_, i) => [i % 5, [i, i], (i * 7) % 11, (i * 3) % 13, i, i, i]);
const properties = [
  { name: 'x', type: 'float' },
  { name: 'links', type: 'short', countType: 'uint' },
  ...['y', 'z', 'red', 'green', 'blue'].map((name) => ({ name, type: 'float' }) as const),
] as const;
const vertex = { name: 'vertex', properties, records };

const places = records.map(([x, , y, z]) => [x, y, z] as number[]);
const e57Scan = {
  fields: [
    ...cartesianFields(places),
    integerField(
      'intensity',
      0,
      9,
      places.map(([x]) => x),
    ),
  ],
  xml: '<pose type="Structure"><translation type="Structure"><x type="Float">1</x></translation></pose>',
};
const rowsOf = (end: string) => places.map((place) => `${place.join(' ')} 0.5\n`).join('') + end;
const fixture = (name: string) =>
  new Uint8Array(readFileSync(fileURLToPath(new URL(`../../../fixtures/foreign/${name}`, import.meta.url))));
const pcd = {
  fields: [...['x', 'y', 'z', 'rgb'].map((name) => [name, 4, 'F'] as const), ['intensity', 2, 'U'] as const],
  points: Array.from({ length: 20 }, (_, i) => [i % 5, (i * 7) % 11, (i * 3) % 13, i * 1e-39, i]),
};
const corners = [
  [0, 0, 0],
  [5, 0, 0],
  [5, 4, 1],
  [0, 4, 1],
];
const triangle = {
  name: 'face',
  properties: [{ name: 'vertex_indices', type: 'int', countType: 'uchar' }],
  records: [[[0, 1, 2]], [[0, 2, 3, 1]]],
} as const;
const corner = {
  name: 'vertex',
  properties: vertex.properties.filter(({ name }) => 'xyz'.includes(name)),
  records: corners,
};
const glb = layOut([Float32Array.from(corners.flat()), Uint16Array.of(0, 1, 2, 0, 2, 3)]);
const model = {
  asset: { version: '2.0' },
  scenes: [{ nodes: [0] }],
  nodes: [
    { children: [1], scale: [1, 2, 3] },
    { mesh: 0, rotation: [0, 1, 0, 0] },
  ],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
  accessors: [
    { bufferView: 0, componentType: 5126, count: 4, type: 'VEC3' },
    { bufferView: 1, componentType: 5123, count: 6, type: 'SCALAR' },
  ],
  bufferViews: glb.bufferViews,
};
const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...glb.data))}`;

/** Whole files whose bytes are then spoilt. */
const GOOD = [
  plyBytes([vertex], { format: 'ascii' }),
  plyBytes([vertex], { format: 'binary_little_endian' }),
  plyBytes([{ ...vertex, name: 'face' }, vertex], { format: 'binary_big_endian' }),
  plyBytes([corner, triangle], { format: 'ascii' }),
  plyBytes([corner, triangle], { format: 'binary_big_endian' }),
  pcdBytes(pcd, { data: 'ascii' }),
  pcdBytes(pcd, { data: 'binary' }),
  pcdBytes(pcd, { data: 'binary_compressed' }),
  bytesOf(
    `${corners.map((row) => `v ${row.join(' ')} 1 0 0.5\n`).join('')}f 1 2 3 4\nf -1//1 -2 \\\n -3/2\n`,
  ),
  glbBytes({ ...model, buffers: glb.buffers }, glb.data),
  bytesOf(JSON.stringify({ ...model, buffers: [{ byteLength: glb.data.length, uri }] })),
  bytesOf(`x,y,z,r,g,b\n${records.map(([x, , y, z]) => [x, y, z, 1, 2, 3].join()).join('\n')}`),
  bytesOf(records.map(([x, , y]) => `${x},5 ${y},25\r`).join('')),
  gzipSync(bytesOf('x,y,z\n1,2,3\n4,5,6\n7,8,10\n')),
  zipSync({ 'a.xyz': bytesOf('1 2 3\n4 5 6\n'), b: [bytesOf('7,8,10\n9,9,9\n'), { level: 0 }] }),
  e57Bytes([e57Scan, e57Scan], { packets: 2, between: [INDEX_PACKET] }),
  bytesOf(ptxHeader(4, 5) + rowsOf(ptxHeader(2, 10)) + rowsOf('')),
  bytesOf(`20\n${rowsOf('20\n')}${rowsOf('')}`),
];

const spoilt = fc
  .record({
    file: fc.constantFrom(...GOOD),
    edits: fc.array(fc.tuple(fc.double({ min: 0, max: 1, noNaN: true }), fc.integer({ min: 0, max: 255 })), {
      maxLength: 6,
    }),
    keep: fc.oneof(fc.constant(1), fc.double({ min: 0, max: 1, noNaN: true })),
    tail: fc.uint8Array({ maxLength: 30 }),
  })
  .map(({ file, edits, keep, tail }) => {
    const bytes = new Uint8Array([...file.subarray(0, Math.floor(file.length * keep)), ...tail]);
    for (const [place, value] of edits)
      if (bytes.length > 0) bytes[Math.floor(place * (bytes.length - 1))] = value;
    return bytes;
  });

/** Damage behind a right checksum. */
const summed = spoilt.map((bytes) => (bytes[0] === 0x41 ? withChecksums(bytes) : bytes));

/** Files whose bytes are spoilt where it hurts most: in header, records, tables and the first points. */
const COMPRESSED = ['format-1.laz', 'variable-3.laz', 'chunks-6.laz', 'octree.copc.laz'].map(fixture);
const spoiltLas = fc
  .record({
    file: fc.constantFrom(
      lasBytes({ format: 3, minor: 2, points: CORNERS, records: [geoKeys({ 1024: 1, 3076: 9002 })] }),
      lasBytes({ format: 8, minor: 4, points: CORNERS, records: [wktRecord('PROJCS["a",UNIT["b",1]]')] }),
      ...COMPRESSED,
      ...COMPRESSED,
    ),
    edits: fc.array(
      fc.tuple(fc.boolean(), fc.integer({ min: 0, max: 1200 }), fc.constantFrom(0, 1, 127, 128, 255)),
      { minLength: 1, maxLength: 3 },
    ),
    keep: fc.oneof({ weight: 4, arbitrary: fc.constant(1) }, fc.double({ min: 0, max: 1, noNaN: true })),
  })
  .map(({ file, edits, keep }) => {
    const bytes = file.slice(0, Math.floor(file.length * keep));
    for (const [isFromEnd, place, value] of edits)
      bytes[isFromEnd ? Math.max(4, bytes.length - 1 - place) : 4 + place] = value;
    return bytes;
  });

const hostile = fc.oneof(
  spoilt,
  spoiltLas,
  summed,
  fc.uint8Array({ maxLength: 400 }),
  fc.string({ unit: fc.constantFrom(...'0123456789.,;-+e" \t\r\n#%/nainfxyz'), maxLength: 200 }).map(bytesOf),
);
const pieces = fc.array(fc.integer({ min: 1, max: 60 }), { minLength: 1, maxLength: 3 });

async function expectScanOrError(work: () => Promise<unknown>): Promise<void> {
  try {
    await work();
  } catch (error) {
    if (!(error instanceof FloorPlanError)) throw error;
    expect(error.code).toMatch(/^input\//);
    expect(error.message).not.toBe('');
    expect(error.hint).not.toBe('');
  }
}

it('answers hostile bytes with a scan or a FloorPlanError', async () => {
  await fc.assert(
    fc.asyncProperty(
      hostile,
      fc.constantFrom('a.ply', 'a.csv', 'a.laz', 'a.obj', 'a'),
      pieces,
      fc.boolean(),
      async (bytes, name, split, hasSize) => {
        const memory = memorySource(bytes, name, split);
        const source: ByteSource = hasSize ? memory : { ...memory, size: undefined };
        await expectScanOrError(() => readScan(source, OPTIONS));
      },
    ),
    { numRuns: 1_500 },
  );
});

it.each(READ_FORMAT_NAMES)('the %s reader alone throws nothing else', async (format) => {
  await fc.assert(
    fc.asyncProperty(hostile, pieces, async (bytes, split) => {
      READ_FORMATS[format].detect(bytes);
      await expectScanOrError(async () => {
        const cloud = await READ_FORMATS[format].open(memorySource(bytes, 'a', split));
        for await (const { count } of cloud.chunks(() => {}, 0)) expect(count).toBeGreaterThan(0);
      });
    }),
    { numRuns: 1_000 },
  );
});
