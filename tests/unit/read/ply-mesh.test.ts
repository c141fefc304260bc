import { describe, expect, it } from 'vitest';
import { openScan } from '../../../src/read/open-scan.ts';
import type { PlyProperty, PlyType } from '../../../src/read/ply/ply-header.ts';
import { memorySource, readAll } from './memory-source.ts';
import { type PlyContent, plyBytes } from './ply-bytes.ts';

const FORMATS = ['ascii', 'binary_little_endian', 'binary_big_endian'] as const;
const single = (type: PlyType, ...names: string[]): PlyProperty[] => names.map((name) => ({ name, type }));
const VERTEX: PlyContent = {
  name: 'vertex',
  properties: [...single('float', 'x', 'y', 'z'), ...single('uchar', 'red', 'green', 'blue')],
  records: [
    [0, 0, 1, 10, 20, 30],
    [4, 0, 1, 10, 20, 30],
    [4, 4, 1, 10, 20, 30],
    [0, 4, 1, 10, 20, 30],
  ],
};
const facesOf = (...records: PlyContent['records']): PlyContent => ({
  name: 'face',
  properties: [
    ...single('float', 'quality'),
    { name: 'texcoord', type: 'float', countType: 'uchar' },
    { name: 'vertex_indices', type: 'int', countType: 'uchar' },
    ...single('uchar', 'flags'),
  ],
  records,
});
const edges: PlyContent = {
  name: 'edge',
  properties: single('int', 'vertex1', 'vertex2'),
  records: [[0, 1]],
};
const read = (bytes: Uint8Array, pieces?: number[]) => readAll(memorySource(bytes, 'a.ply', pieces));

describe.each(FORMATS)('PLY %s with faces', (format) => {
  it('is sampled on its triangles and polygons', async () => {
    const faces = [
      facesOf([-0.5, [0.5, 1], [0, 1, 2, 3], 7]),
      facesOf([0, [], [0, 1, 2], 7], [1.5, [0, 0, 0], [0, 2, 3], 7], [0, [], [0, 1], 7]),
    ];
    for (const face of faces) {
      const bytes = plyBytes([edges, VERTEX, edges, face, edges], { format });
      for (const pieces of [[1 << 20], [3, 11]]) {
        const { xyz, colour } = await read(bytes, pieces);
        expect(xyz.length / 200_000).toBeCloseTo(1, 2);
        expect(xyz.filter(([x, y]) => y < x).length / xyz.length).toBeCloseTo(0.5, 2);
        expect(new Set(colour?.map(String))).toEqual(new Set(['10,20,30']));
      }
    }
  });

  it('without a single face is a cloud', async () => {
    const { cloud } = await openScan([memorySource(plyBytes([VERTEX, facesOf()], { format }), 'a.ply')]);
    expect(cloud.isAdaptive).toBeUndefined();
    expect(cloud.pointsAnnounced).toBe(4);
  });

  it('refuses vertices that are not there', async () => {
    for (const corner of [4, -1]) {
      const bytes = plyBytes([VERTEX, facesOf([0, [], [0, 1, corner], 7])], { format });
      await expect(read(bytes)).rejects.toMatchObject({ code: 'input/malformed' });
    }
  });

  it('says that a file is cut off', async () => {
    const whole = plyBytes([VERTEX, facesOf([0, [], [0, 1, 2], 7], [0, [], [0, 2, 3], 7])], { format });
    const cut = whole.subarray(0, whole.length - (format === 'ascii' ? 14 : 9));
    const ofUnknownSize = { ...memorySource(cut, 'a.ply'), size: undefined };
    await expect(readAll(ofUnknownSize)).rejects.toMatchObject({ code: 'input/truncated' });
  });

  it('takes the vertices where the faces are too many to be held', async () => {
    const header = `ply\nformat ${format} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 100000000\nproperty list uchar int vertex_indices\nend_header\n`;
    const source = { ...memorySource(header, 'a.ply'), size: undefined };
    const { cloud } = await openScan([source]);
    expect(cloud.warnings).toMatchObject([{ code: 'read/mesh-vertices-only' }]);
    expect(cloud.isAdaptive).toBeUndefined();
  });
});

it('refuses lists that no face has', async () => {
  const long: PlyContent = {
    name: 'face',
    properties: [{ name: 'vertex_indices', type: 'int', countType: 'uint' }],
    records: [[[0, 1, 2]]],
  };
  const bytes = plyBytes([VERTEX, long], { format: 'binary_little_endian' });
  bytes.fill(255, bytes.length - 16, bytes.length - 12);
  await expect(read(bytes)).rejects.toMatchObject({ code: 'input/malformed' });
});
