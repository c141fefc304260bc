import fc from 'fast-check';
import { expect, it } from 'vitest';
import type { PlyProperty, PlyType } from '../../../src/read/ply/ply-header.ts';
import { memorySource, readAll } from '../../unit/read/memory-source.ts';
import { type PlyContent, plyBytes } from '../../unit/read/ply-bytes.ts';

const RANGES: Readonly<Record<Exclude<PlyType, 'float' | 'double'>, readonly [number, number]>> = {
  char: [-128, 127],
  uchar: [0, 255],
  short: [-32768, 32767],
  ushort: [0, 65535],
  int: [-2147483648, 2147483647],
  uint: [0, 4294967295],
};

function singleOf(type: PlyType): fc.Arbitrary<number> {
  const noNaN = { noNaN: true, noDefaultInfinity: true };
  if (type === 'float') return fc.float(noNaN);
  if (type === 'double') return fc.double(noNaN);
  const [min, max] = RANGES[type];
  return fc.integer({ min, max });
}

const typeOf = fc.constantFrom<PlyType>('char', 'uchar', 'short', 'ushort', 'int', 'uint', 'float', 'double');
const listOf = fc.record({ type: typeOf, countType: fc.constantFrom<PlyType>('uchar', 'ushort', 'int') });

const property = (name: string): fc.Arbitrary<PlyProperty> =>
  name.startsWith('list')
    ? listOf.map(({ type, countType }) => ({ name, type, countType }))
    : typeOf.map((type) => ({ name, type }));

const valuesOf = ({ type, countType }: PlyProperty) =>
  countType ? fc.array(singleOf(type), { maxLength: 5 }) : singleOf(type);

function element(name: string, names: readonly string[], least: number): fc.Arbitrary<PlyContent> {
  return fc
    .shuffledSubarray([...names], { minLength: names.length })
    .chain((order) => fc.tuple(...order.map(property)))
    .chain((properties) =>
      fc
        .array(fc.tuple(...properties.map(valuesOf)), { minLength: least, maxLength: 12 })
        .map((records) => ({ name, properties, records })),
    );
}

const file = fc.record({
  before: element('face', ['list_a', 'b'], 0),
  vertex: fc
    .subarray(['list_a', 'nx', 'list_b', 'quality'])
    .chain((extra) => element('vertex', ['x', 'y', 'z', ...extra], 1)),
  format: fc.constantFrom('ascii' as const, 'binary_little_endian' as const, 'binary_big_endian' as const),
  lineEnd: fc.constantFrom('\n', '\r\n', '\r'),
  pieces: fc.array(fc.integer({ min: 1, max: 40 }), { minLength: 1, maxLength: 4 }),
});

it('reads back any layout, byte order and split of the bytes', async () => {
  await fc.assert(
    fc.asyncProperty(file, async ({ before, vertex, format, lineEnd, pieces }) => {
      const bytes = plyBytes([before, vertex, before], { format, lineEnd });
      const { xyz } = await readAll(memorySource(bytes, 'a.ply', pieces));
      const columns = ['x', 'y', 'z'].map((axis) => vertex.properties.findIndex(({ name }) => name === axis));
      // A written −0 comes back as 0 from text.
      const expected = vertex.records.map((record) =>
        columns.map((column) => (record[column] as number) + 0),
      );
      expect(xyz.map((point) => point.map((value) => value + 0))).toEqual(expected);
    }),
  );
});
