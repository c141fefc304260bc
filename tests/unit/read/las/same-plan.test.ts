import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { createStrokeTest } from '../../../../src/cli/canvas-stroke.ts';
import { nodeSource } from '../../../../src/cli/node-source.ts';
import type { ByteSource } from '../../../../src/read/bytes/source.ts';
import { Session } from '../../../../src/session/session.ts';
import { memorySource, readAll } from '../memory-source.ts';
import { plyBytes } from '../ply-bytes.ts';
import { lasBytes } from './las-bytes.ts';

const ROOM = fileURLToPath(new URL('../../../../fixtures/foreign/room.laz', import.meta.url));
const OFFSET = [691_000, 5_334_000, 500];

async function planOf(source: ByteSource): Promise<string[]> {
  const session = new Session({ strokeTest: createStrokeTest() });
  await session.load(source);
  const files = await Promise.all(['geojson', 'slice', 'dxf'].map((format) => session.write(format)));
  return files.flat().map(({ content }) => (typeof content === 'string' ? content : content.join()));
}

it('one cloud as LAZ, LAS and PLY, in any order, has one plan', async () => {
  const laz = await nodeSource(ROOM);
  const { xyz } = await readAll(laz);
  expect(xyz.length).toBe(6_000);
  const other = xyz.map((_, i) => xyz[(i * 7_919) % xyz.length]);
  const places = other.map((place) => place.map((value, axis) => Math.round((value - OFFSET[axis]) * 1000)));
  const las = lasBytes({
    format: 6,
    minor: 4,
    points: places.map(([x, y, z]) => ({ at: [x, y, z] })),
    scale: [0.001, 0.001, 0.001],
    offset: OFFSET,
  });
  const properties = (['x', 'y', 'z'] as const).map((name) => ({ name, type: 'double' }) as const);
  const ply = plyBytes([{ name: 'vertex', properties, records: other }], { format: 'binary_little_endian' });
  const plan = await planOf(laz);
  expect(await planOf(memorySource(las, 'room.laz'))).toEqual(plan);
  expect(await planOf(memorySource(ply, 'room.laz'))).toEqual(plan);
});
