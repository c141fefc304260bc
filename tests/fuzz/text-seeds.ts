import { type PcdContent, pcdBytes } from '../unit/read/pcd-bytes.ts';
import { type PlyContent, plyBytes } from '../unit/read/ply-bytes.ts';
import { ptxHeader } from '../unit/read/ptx-text.ts';
import { fixture, PLACES } from './binary-seeds.ts';
import { type Bytes, bytesOfLatin1, placesOf, type Seed } from './seed.ts';

/** A file that begins with lines of text; `mark` ends them where numbers in binary follow. */
function linesSeed(name: string, bytes: Bytes, { mark = '', isBinary = false } = {}): Seed {
  const bodyBegin = mark === '' ? 0 : (placesOf(bytes, mark).at(1) ?? 0);
  const lines = [...placesOf(bytes, '\n'), ...placesOf(bytes, '\r')];
  const boundaries = [...new Set(lines)].filter((at) => at < bodyBegin || !isBinary);
  return {
    name,
    bytes,
    boundaries: [...boundaries, bodyBegin, bodyBegin + 4, bodyBegin + 8].filter(
      (at) => at > 0 && at < bytes.length,
    ),
    body: [bodyBegin, bytes.length],
    text: [isBinary ? [0, bodyBegin] : [0, bytes.length]],
  };
}

const vertex: PlyContent = {
  name: 'vertex',
  properties: [
    { name: 'x', type: 'float' },
    { name: 'links', type: 'short', countType: 'uint' },
    ...['y', 'z', 'red', 'green', 'blue'].map((name) => ({ name, type: 'double' }) as const),
    { name: 'intensity', type: 'ushort' },
    { name: 'classification', type: 'uchar' },
  ],
  records: PLACES.map(([x, y, z], i) => [x, [i, -i], y, z, i / 20, 0.5, 1, i, i]),
};
const corner: PlyContent = {
  name: 'vertex',
  properties: ['x', 'y', 'z'].map((name) => ({ name, type: 'float' }) as const),
  records: PLACES.map((place) => [...place]),
};
const edge: PlyContent = {
  name: 'edge',
  properties: [{ name: 'vertex1', type: 'int' }],
  records: [[1], [2]],
};
const face: PlyContent = {
  name: 'face',
  properties: [
    { name: 'flags', type: 'uchar' },
    { name: 'vertex_indices', type: 'int', countType: 'uchar' },
    { name: 'uv', type: 'float', countType: 'uchar' },
  ],
  records: [
    [1, [0, 1, 2], [0.5, 1]],
    [0, [3, 4, 9, 14, 7], []],
    [0, [0, 5, 2, 8], [1]],
  ],
};
const plain: PlyContent = {
  ...face,
  properties: face.properties.slice(1, 2),
  records: [[[0, 1, 2]], [[3, 4, 9, 11]]],
};

const PLY_FORMATS = ['ascii', 'binary_little_endian', 'binary_big_endian'] as const;
const ply = (name: string, elements: readonly PlyContent[], format: (typeof PLY_FORMATS)[number]) =>
  linesSeed(`${name}.ply`, plyBytes(elements, { format, comments: ['comment made up'] }), {
    mark: 'end_header\n',
    isBinary: format !== 'ascii',
  });

export const PLY_SEEDS: readonly Seed[] = [
  ...PLY_FORMATS.flatMap((format) => [
    ply('links', [vertex], format),
    ply('points', [corner], format),
    ply('edges-first', [edge, face, vertex], format),
    ply('mesh', [corner, plain], format),
    ply('mesh-of-more', [vertex, edge, face], format),
  ]),
  linesSeed('flat.ply', fixture('foreign/flat.ply'), { mark: 'end_header\n', isBinary: true }),
  linesSeed('mesh-tool.ply', fixture('clouds/mesh-tool.ply'), { mark: 'end_header\n', isBinary: true }),
  linesSeed('mac.ply', plyBytes([corner], { format: 'ascii', lineEnd: '\r' }), { mark: 'end_header\r' }),
];

const pcd: PcdContent = {
  fields: [
    ...['x', 'y', 'z', 'rgb'].map((name) => [name, 4, 'F'] as const),
    ['intensity', 2, 'U'],
    ['normal', 4, 'F', 3],
    ['label', 8, 'U'],
  ],
  points: PLACES.map((place, i) => [...place, i * 1e-39, i, 0, 0, 1, i]),
};
const doubles: PcdContent = {
  fields: ['x', 'y', 'z'].map((name) => [name, 8, 'F'] as const),
  points: PLACES.map((place) => [...place]),
};
const pcdSeed = (name: string, bytes: Bytes, data: string) =>
  linesSeed(`${name}.pcd`, bytes, { mark: `DATA ${data}\n`, isBinary: data !== 'ascii' });
const PCD_DATA = ['ascii', 'binary', 'binary_compressed'] as const;
const GRID = { WIDTH: 'WIDTH 5', HEIGHT: 'HEIGHT 4', VIEWPOINT: 'VIEWPOINT 1 2 3 1 0 0 0' };

export const PCD_SEEDS: readonly Seed[] = [
  ...PCD_DATA.flatMap((data) => [
    pcdSeed('fields', pcdBytes(pcd, { data }), data),
    pcdSeed('doubles', pcdBytes(doubles, { data, lines: GRID }), data),
  ]),
  pcdSeed('open3d', fixture('foreign/cloud-ascii.pcd'), 'ascii'),
  pcdSeed('open3d-binary', fixture('foreign/cloud-binary.pcd'), 'binary'),
  pcdSeed('open3d-packed', fixture('foreign/cloud-compressed.pcd'), 'binary_compressed'),
];

const text = (name: string, content: string) => linesSeed(name, bytesOfLatin1(content));
const table = (separator: string, make: (place: readonly number[], i: number) => readonly unknown[]) =>
  PLACES.map((place, i) => `${make(place, i).join(separator)}\n`).join('');

export const CSV_SEEDS: readonly Seed[] = [
  ...['cloudcompare.txt', 'paper-slice.csv', 'spreadsheet.csv'].map((name) =>
    linesSeed(name, fixture(`clouds/${name}`)),
  ),
  text(
    'named.csv',
    `x,y,z,r,g,b,intensity,class\n${table(',', ([x, y, z], i) => [x, y, z, i, 2, 3, 0.5, i])}`,
  ),
  text(
    'plain.xyz',
    table(' ', ([x, y, z], i) => [x, y, z, i, 255, 0, 9]),
  ),
  text('numbered.txt', `20\n${table('\t', ([x, y, z], i) => [i, x + 0.25, y + 0.25, z + 0.125])}`),
  text(
    'comma.txt',
    table(';', ([x, y]) => [x, y].map((value) => `${value}`.replace('.', ','))),
  ),
  text('quoted.csv', `"x","y","z"\r\n${table(',', (place) => place.map((value) => `"${value}"`))}`),
  text('mac.csv', table(' ', (place) => place).replaceAll('\n', '\r')),
];

const rows = table(' ', ([x, y, z], i) => [x, y, z, (i * 131) % 256]);
const coloured = table(' ', ([x, y, z], i) => [x, y, z, i * 100 - 1000, i, 2, 3]);

export const PTS_SEEDS: readonly Seed[] = [
  linesSeed('open3d.pts', fixture('foreign/open3d.pts')),
  text('two.pts', `20\n${rows}20\n${rows}`),
  text('coloured.pts', `20\n${coloured}`),
  text('places.pts', `20\r\n${table(' ', (place) => place).replaceAll('\n', '\r\n')}`),
  text('last.pts', `20\n${table(' ', ([x, y, z], i) => [x, y, z, 1, 2, i, i / 20])}`),
  text('more.pts', `10\n${rows}`),
  text('none.pts', rows),
];

const TURNED = [
  [0, 1, 0],
  [-1, 0, 0],
  [0, 0, 1],
  [10, 20, 1],
];

export const PTX_SEEDS: readonly Seed[] = [
  text('one.ptx', ptxHeader(4, 5) + rows),
  text('two.ptx', `${ptxHeader(4, 5, TURNED)}${coloured}${ptxHeader(2, 10)}${coloured}`),
  text('empty.ptx', ptxHeader(4, 5, TURNED) + rows.replace(/^.*$/m, '0 0 0 0.5')),
  text('places.ptx', ptxHeader(4, 5) + table(' ', (place) => place)),
];

const corners = table(' ', (place) => ['v', ...place]);

export const OBJ_SEEDS: readonly Seed[] = [
  linesSeed('flat.obj', fixture('foreign/flat.obj')),
  text(
    'quads.obj',
    `mtllib a.mtl\no Room\n${corners}f 1 2 3 4\nf -1//1 -2 \\\n -3/2 # a face\nf 1/2/3 7 9 11 3\n`,
  ),
  text('points.obj', `# points\n${table(' ', ([x, y, z], i) => ['v', x, y, z, i, 2, 3])}`),
  text(
    'weighted.obj',
    table(' ', ([x, y, z]) => ['v', x, y, z, 1, 0.5, 0, 1]),
  ),
];
