import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { nodeSource } from '../../../src/cli/node-source.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { crc32c } from '../../../src/read/e57/crc32c.ts';
import { parseXml, XmlError } from '../../../src/read/e57/xml.ts';
import { openScan } from '../../../src/read/open-scan.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import {
  bitwiseCrc32c,
  cartesianFields,
  type E57Field,
  e57Bytes,
  IGNORED_PACKET,
  INDEX_PACKET,
  integerField,
  withChecksums,
} from './e57-bytes.ts';
import { bytesOf, memorySource, readWhole } from './memory-source.ts';

const pathOf = (relative: string) => fileURLToPath(new URL(`../../../${relative}`, import.meta.url));
const POINTS = [
  [0, 0, 0],
  [4.25, 0, 1],
  [4.25, 3, -2],
  [1e6, 5e6, 0.1],
];
const read = (bytes: Uint8Array, pieces?: number[]) => readWhole(memorySource(bytes, 'a.e57', pieces));
const POSE = `<pose type="Structure"><rotation type="Structure"><w type="Float">1</w><x type="Float"/><y type="Float"/><z type="Float">1e+000</z></rotation><translation type="Structure"><x type="Float">10</x><y type="Float">20</y><z type="Float">30</z></translation></pose>`;

function expectClose(
  found: readonly (readonly number[])[],
  expected: readonly (readonly number[])[],
  within: number,
) {
  expect(found).toHaveLength(expected.length);
  found.forEach((point, i) => {
    point.forEach((value, k) => {
      expect(Math.abs(value - expected[i][k])).toBeLessThanOrEqual(within);
    });
  });
}

describe('files by libE57Format', () => {
  const grid = Array.from({ length: 60 }, (_, i) => [
    2 + 0.5 * (i % 5),
    1 + 0.5 * (Math.floor(i / 5) % 4),
    0.5 + 0.5 * Math.floor(i / 20),
  ]);
  const kept = grid.map((_, i) => i).filter((i) => i % 7 !== 3);
  const twice = [...kept, ...kept];

  it('two-scans.e57', async () => {
    const { cloud, ...found } = await readWhole(await nodeSource(pathOf('fixtures/foreign/two-scans.e57')));
    const places = twice.map((i) => grid[i]);
    // Coordinates are float32 below 4.
    expectClose(found.xyz, places, 2 ** -22);
    expect(found.colour).toEqual(twice.map((i) => [i, 2 * i, 3 * i]));
    expectClose([found.intensity ?? []], [twice.map((i) => i / 59)], 1e-6);
    expect(found.station).toEqual(twice.map((_, i) => (i < kept.length ? 0 : 1)));
    expect(cloud).toMatchObject({ unit: 'm', pointsAnnounced: 120, warnings: [] });
    expect(cloud.stations).toEqual([
      [3, 2, 1.5],
      [-1, 0.25, 1.75],
    ]);
  });

  it('packed-spherical.e57', async () => {
    const { cloud, ...found } = await readWhole(
      await nodeSource(pathOf('fixtures/foreign/packed-spherical.e57')),
    );
    expectClose(
      found.xyz,
      twice.map((i) => grid[i]),
      1e-12,
    );
    const shares = [...kept.map((i) => i / 59), ...kept.map(() => 0)];
    expectClose([found.intensity ?? []], [shares], 1e-6);
    expect(found.colour?.slice(40, 43)).toEqual(
      kept.slice(40, 43).map((i) => [Math.round((i * 255) / 1023), Math.round((2 * i * 255) / 1023), 0]),
    );
    expect(cloud.crs).toBe('LOCAL_CS["site <A> & B"]');
    expect(cloud.stations).toEqual([
      [0, 0, 0],
      [-1, 0.25, 1.75],
    ]);
  });

  const PUMP = pathOf('../shared/scans/pumpA.e57');
  it.skipIf(!existsSync(PUMP))(
    'pumpA.e57, as pye57 reads it (skipped where ../shared/scans is not)',
    async () => {
      const { xyz, colour, intensity } = await readWhole(await nodeSource(PUMP));
      const mean = (values: readonly number[]) =>
        values.reduce((sum, value) => sum + value, 0) / values.length;
      expect(xyz).toHaveLength(155_201);
      expectClose(
        [[0, 1, 2].map((axis) => mean(xyz.map((point) => point[axis])))],
        [[-0.482685742, -2.636014758, -0.947162136]],
        1e-8,
      );
      expect(mean(colour?.map(([red]) => red) ?? [])).toBeCloseTo(32.364913886, 8);
      expect(mean(intensity ?? [])).toBeCloseTo(0.47202483, 7);
    },
  );
});

describe('points', () => {
  it('come in any pieces and packets, past other packets', async () => {
    const points = Array.from({ length: 700 }, (_, i) => [i / 7, i * i, -i]);
    const states = points.map((_, i) => i % 3);
    const fields = [...cartesianFields(points), integerField('cartesianInvalidState', 0, 2, states)];
    const whole = points.filter((_, i) => i % 3 === 0);
    for (const style of [{}, { packets: 9, between: [INDEX_PACKET, IGNORED_PACKET] }]) {
      const bytes = e57Bytes([{ fields }], style);
      for (const pieces of [[1 << 20], [1000, 37]]) expect((await read(bytes, pieces)).xyz).toEqual(whole);
    }
  });

  it.each([1, 2, 3, 7, 8, 9, 16, 24, 25, 26, 31, 32, 33, 40, 53])('of integers of %i bits', async (bits) => {
    const most = 2 ** bits - 1;
    const values = Array.from({ length: 40 }, (_, i) => Math.floor((most * i) / 39));
    const least = bits < 53 ? -5 : 0;
    const x = integerField(
      'cartesianX',
      least,
      most + least,
      values.map((value) => value + least),
    );
    const other = (axis: string) =>
      integerField(
        `cartesian${axis}`,
        7,
        7,
        values.map(() => 7),
      );
    const { xyz } = await read(e57Bytes([{ fields: [x, other('Y'), other('Z')] }], { packets: 5 }));
    expect(x.bits).toBe(bits);
    expect(xyz).toEqual(values.map((value) => [value + least, 7, 7]));
  });

  it('of scaled integers without limits have all of an int64', async () => {
    const scaled = (axis: string, values: bigint[]): E57Field => ({
      name: `cartesian${axis}`,
      prototype: 'type="ScaledInteger" scale="0.5" offset="1"',
      values: values.map((value) => value + 2n ** 63n),
      bits: 64,
    });
    const fields = [scaled('X', [-3n, 2n ** 52n]), scaled('Y', [4n, -(2n ** 40n)]), scaled('Z', [0n, 1n])];
    expect((await read(e57Bytes([{ fields }]))).xyz).toEqual([
      [-0.5, 3, 1],
      [2 ** 51 + 1, 1 - 2 ** 39, 1.5],
    ]);
  });

  it('stand in the poses of their scans, in float64', async () => {
    const fields = cartesianFields(POINTS);
    const { xyz, station, cloud } = await read(e57Bytes([{ fields }, { fields, xml: POSE }]));
    const turned = POINTS.map(([x, y, z]) => [10 - y, 20 + x, 30 + z]);
    expectClose(xyz, [...POINTS, ...turned], 1e-9);
    expect(station).toEqual([0, 0, 0, 0, 1, 1, 1, 1]);
    expect(cloud.stations).toEqual([
      [0, 0, 0],
      [10, 20, 30],
    ]);
  });

  it('have no station where no scan has a pose', async () => {
    const { station, cloud } = await read(e57Bytes([{ fields: cartesianFields(POINTS) }]));
    expect([station, cloud.stations]).toEqual([undefined, undefined]);
  });

  it('of scans with other attributes have all of them, 0 where they lack one', async () => {
    const fields = cartesianFields(POINTS);
    const tones = ['Red', 'Green', 'Blue'].map((name) =>
      integerField(`color${name}`, 0, 65_535, [0, 257, 65_535, 1]),
    );
    const { colour } = await read(e57Bytes([{ fields }, { fields: [...fields, ...tones] }]));
    expect(colour).toEqual([0, 0, 0, 0, 0, 1, 255, 0].map((tone) => [tone, tone, tone]));
  });

  it('are read again from the start', async () => {
    const source = memorySource(e57Bytes([{ fields: cartesianFields(POINTS) }]), 'a.e57');
    const { cloud } = await openScan([source]);
    const counts: number[] = [];
    for (let time = 0; time < 2; time++)
      for await (const { count } of cloud.chunks(() => {}, 0)) counts.push(count);
    expect(counts).toEqual([4, 4]);
  });
});

describe('a file that is not right', () => {
  const good = (): Uint8Array<ArrayBuffer> =>
    e57Bytes([{ fields: cartesianFields(Array.from({ length: 200 }, (_, i) => [i, 0, 0])) }]);
  const broken = (change: (view: DataView) => void) => {
    const bytes = good();
    change(new DataView(bytes.buffer));
    return withChecksums(bytes);
  };

  it('has the page with the wrong checksum named', async () => {
    const bytes = good();
    bytes[2 * 1024 + 77] ^= 1;
    await expect(read(bytes)).rejects.toMatchObject({
      code: 'input/malformed',
      message: expect.stringMatching(/checksum \w{8} of page 2 at byte 2048, found \w{8}/),
      detail: { page: 2, offset: 2048 },
    });
  });

  it.each([
    [
      'pages of another size',
      (view: DataView) => view.setBigUint64(40, 512n, true),
      'input/malformed',
      'pages of 1024',
    ],
    [
      'an XML section past its end',
      (view: DataView) => view.setBigUint64(24, 1n << 40n, true),
      'input/malformed',
      'XML section within',
    ],
    [
      'a gigantic XML section',
      (view: DataView) => view.setBigUint64(32, 1n << 40n, true),
      'input/too-large',
      'at most',
    ],
    [
      'more bytes than there are',
      (view: DataView) => view.setBigUint64(16, 1n << 40n, true),
      'input/truncated',
      '1099511627776 bytes',
    ],
    [
      'another section in place of points',
      (view: DataView) => view.setUint8(48, 9),
      'input/malformed',
      'section of type 9',
    ],
    [
      'a packet of an unknown type',
      (view: DataView) => view.setUint8(80, 5),
      'input/malformed',
      'packet of type 5',
    ],
    [
      'a packet with too few streams',
      (view: DataView) => view.setUint8(84, 2),
      'input/malformed',
      '2 bytestreams for 3 fields',
    ],
    [
      'streams longer than their packet',
      (view: DataView) => view.setUint16(86, 0xffff, true),
      'input/malformed',
      'with bytestreams of',
    ],
    [
      'a section that ends too soon',
      (view: DataView) => view.setBigUint64(56, 32n, true),
      'input/malformed',
      'end of its section',
    ],
    [
      'packets in a checksum',
      (view: DataView) => view.setBigUint64(64, 1021n, true),
      'input/malformed',
      'checksum of a page',
    ],
    [
      'packets before their section',
      (view: DataView) => view.setBigUint64(64, 8n, true),
      'input/malformed',
      'overlaps',
    ],
  ] as const)('with %s', async (_, change, code, message) => {
    await expect(read(broken(change))).rejects.toMatchObject({
      code,
      message: expect.stringContaining(message),
    });
  });

  it('is truncated wherever it is cut', async () => {
    const bytes = good();
    for (const length of [20, 48, 1024, 3000, bytes.length - 1]) {
      const { size, ...cut } = memorySource(bytes.subarray(0, length), 'a.e57');
      expect(size).toBe(length);
      await expect(readWhole({ ...cut, size: undefined })).rejects.toMatchObject({ code: 'input/truncated' });
    }
  });

  it('may not announce more points than it holds, not even points that take no bytes', async () => {
    const fields = cartesianFields(POINTS);
    await expect(read(e57Bytes([{ fields, recordCount: 2 ** 50 }]))).rejects.toMatchObject({
      code: 'input/malformed',
    });
    const same = ['X', 'Y', 'Z'].map((axis) => integerField(`cartesian${axis}`, 1, 1, []));
    expect((await read(e57Bytes([{ fields: same, recordCount: 2 ** 50 }]))).xyz).toEqual([[1, 1, 1]]);
  });

  it.each([
    ['no coordinates', { fields: [integerField('intensity', 0, 1, [1])] }, 'intensity'],
    [
      'a minimum above the maximum',
      {
        fields: [
          { ...integerField('cartesianX', 0, 1, [1]), prototype: 'type="Integer" minimum="2" maximum="1"' },
        ],
      },
      '2 … 1',
    ],
    [
      'an unknown type',
      { fields: [{ ...integerField('cartesianX', 0, 1, [1]), prototype: 'type="Blob"' }] },
      'Blob',
    ],
    [
      'a rotation of no length',
      { fields: cartesianFields(POINTS), xml: POSE.replaceAll(/>1(e\+000)?</g, '><') },
      '0 0 0 0',
    ],
    ['a pose of words', { fields: cartesianFields(POINTS), xml: POSE.replace('>20<', '>north<') }, 'north'],
  ])('has scans of %s refused', async (_, scan, found) => {
    await expect(read(e57Bytes([scan]))).rejects.toMatchObject({
      code: 'input/malformed',
      message: expect.stringContaining(found),
    });
  });

  it('is empty without points, images or not', async () => {
    const none = { fields: cartesianFields([]) };
    await expect(read(e57Bytes([none]))).rejects.toMatchObject({ code: 'input/empty' });
    const xml = '<images2D type="Vector"><vectorChild type="Structure"/></images2D>';
    await expect(read(e57Bytes([], { xml }))).rejects.toMatchObject({
      code: 'input/empty',
      message: expect.stringContaining('1 images only'),
    });
  });
});

describe('XML', () => {
  it('has elements, attributes, text, CDATA and five entities', () => {
    const root = parseXml(
      `<?xml version="1.0"?><!-- <no> --><a b='1' c = "&lt;&#xe9;"><d/>x<![CDATA[<&]]>&amp;</a>\n`,
    );
    expect(root).toMatchObject({ name: 'a', text: 'x<&&', children: [{ name: 'd', text: '' }] });
    expect([...root.attributes]).toEqual([
      ['b', '1'],
      ['c', '<é'],
    ]);
  });

  it.each([
    '',
    'text',
    '<a>',
    '<a></b>',
    '<a/><b/>',
    '</a>',
    '<a b>',
    '<a b=c/>',
    '<a>&bomb;</a>',
    '<a>&constructor;</a>',
    '<a>&#x110000;</a>',
    '<!DOCTYPE a [<!ENTITY b "c">]><a/>',
    '<a><!-- </a>',
    '<a>'.repeat(100),
    '< a/>',
  ])('refuses %j', (text) => {
    expect(() => parseXml(text)).toThrow(XmlError);
  });

  it('refuses more elements than memory should hold', () => {
    expect(() => parseXml(`<a>${'<b/>'.repeat(2 ** 20)}</a>`)).toThrow('at most');
  });
});

it('sums bytes as the definition of CRC-32C does', () => {
  // RFC 3720, B.4
  expect(crc32c(new Uint8Array(32), 0, 32)).toBe(0x8a9136aa);
  const bytes = bytesOf('The quick brown fox jumps over the lazy dog'.repeat(3));
  for (let end = 3; end <= bytes.length; end++)
    expect(crc32c(bytes, 3, end)).toBe(bitwiseCrc32c(bytes.subarray(3, end)));
});

it('becomes a scan in metres with its stations', async () => {
  const fields = cartesianFields(POINTS.slice(0, 3));
  const scan = await readScan(memorySource(e57Bytes([{ fields, xml: POSE }]), 'a.e57'), resolveOptions({}));
  expect(scan).toMatchObject({
    unit: 'm',
    stations: [[10, 20, 30]],
    facts: { format: 'e57', pointsRead: 3 },
  });
});
