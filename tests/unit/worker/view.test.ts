import { expect, it } from 'vitest';
import { Session } from '../../../src/session/session.ts';
import type { CloudView } from '../../../src/worker/protocol.ts';
import { makeView } from '../../../src/worker/view.ts';
import { memorySource } from '../read/memory-source.ts';

/** A slice with the given columns beside x and y at z 0, 0.1 m apart. */
function cloud(header: string, columns: (i: number) => string): string {
  const rows = Array.from({ length: 400 }, (_, i) => {
    const side = Math.floor(i / 100);
    const along = (i % 100) / 25;
    const [x, y] = [
      [along, 0],
      [4, along],
      [4 - along, 4],
      [0, 4 - along],
    ][side];
    return `${x},${y},${(i % 7) * 0.4},${columns(i)}`;
  });
  return `x,y,z,${header}\n${rows.join('\n')}\n`;
}

async function cloudOf(text: string): Promise<CloudView> {
  const session = new Session();
  await session.load(memorySource(text, 'room.csv'), { unit: 'm', up: 'z' });
  return makeView(session, [], 0).view.cloud;
}

it('shows colours, and intensities as greys that glints do not darken, where they differ', async () => {
  const both = await cloudOf(cloud('red,green,blue,intensity', (i) => `${i % 256},20,30,${i}`));
  expect(both.colour!.subarray(1, 3)).toEqual(Uint8Array.of(20, 30));
  expect(both.intensity).toHaveLength(both.positions.length);
  const grey = await cloudOf(cloud('intensity', (i) => `${i === 7 ? 1e6 : i}`));
  expect(grey.colour).toBeUndefined();
  const shades = grey.intensity!;
  const greys = shades.filter((_, i) => i % 3 === 0);
  expect(greys).toEqual(shades.filter((_, i) => i % 3 === 1));
  expect(Math.min(...greys)).toBe(0);
  expect(Math.max(...greys)).toBe(255);
  expect(greys.toSorted()[200]).toBeGreaterThan(100);
  expect((await cloudOf(cloud('intensity', () => '5'))).intensity).toBeUndefined();
});
