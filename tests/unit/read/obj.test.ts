import { describe, expect, it } from 'vitest';
import { bytesOf, memorySource, readAll } from './memory-source.ts';

const read = (text: string, pieces?: number[]) => readAll(memorySource(bytesOf(text), 'a.obj', pieces));
const SQUARE = 'v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n';
/** Samples of a rough whole. */
const WHOLE = 200_000;

/** Share of the points below the diagonal of the square. */
const below = (xyz: number[][]) => xyz.filter(([x, y]) => y < x).length / WHOLE;

describe('OBJ', () => {
  it.each([
    ['plain', 'f 1 2 3 4'],
    ['with textures', 'f 1/1 2/2 3/3 4/4'],
    ['with normals', 'f 1//1 2//1 3//1 4//1'],
    ['with both', 'f 1/1/1 2/2/1 3/3/1 4/4/1'],
    ['from the end', 'f -4 -3 -2 -1'],
    ['on two lines', 'f 1 2 \\\n3 4'],
    ['on two lines that end in CRLF', 'f 1 2\\\r\n 3 4\r\n'],
    ['with a comment', 'f 1 2 3 4 # the floor'],
    ['of two triangles in groups', 'g a\nusemtl x\nf 1 2 3\ng b\ns 1\nf 1 3 4'],
  ])('reads faces %s', async (_, faces) => {
    const text = `# made by hand\nmtllib a.mtl\no Room\n${SQUARE}vt 0 0\nvn 0 0 1\n${faces}`;
    for (const pieces of [[1 << 20], [1], [5, 3]]) {
      const { xyz } = await read(text, pieces);
      expect(xyz.length / WHOLE).toBeCloseTo(1, 2);
      expect(below(xyz)).toBeCloseTo(0.5, 2);
    }
  });

  it('takes the vertices for points where there are no faces', async () => {
    const { xyz, colour } = await read('v 1 2 3 1 0.5 0\n  v -1e1\t0.5 .25 0 0 1\nl 1 2\n');
    expect(xyz).toEqual([
      [1, 2, 3],
      [-10, 0.5, 0.25],
    ]);
    expect(colour).toEqual([
      [255, 128, 0],
      [0, 0, 255],
    ]);
  });

  it('knows a weight from a colour', async () => {
    expect((await read('v 1 2 3 1\nv 1 2 4 1\n')).colour).toBeUndefined();
    expect((await read('v 1 2 3 1 0 1 0\nv 1 2 4 1 0 1 0\n')).colour).toEqual([
      [0, 255, 0],
      [0, 255, 0],
    ]);
    expect((await read('v 1 2 3 200 100 7\n')).colour).toEqual([[200, 100, 7]]);
  });

  it.each([
    ['f 1 2 9', 5, 'a vertex from 1 to 4'],
    ['f 1 2 -5', 5, 'a vertex from 1 to 4'],
    ['f 1 2 0', 5, 'a vertex from 1 to 4'],
    ['f a b c', 5, 'a vertex from 1 to 4'],
    ['\nv 1 2', 6, 'three numbers'],
    ['v 1 2 x', 5, 'a number'],
  ])('names the line it cannot read: %j', async (text, line, expected) => {
    await expect(read(`${SQUARE}${text}\n`)).rejects.toMatchObject({
      code: 'input/malformed',
      message: expect.stringContaining(expected),
      detail: { line },
    });
  });

  it('is empty without vertices', async () => {
    await expect(read('# nothing\n')).rejects.toMatchObject({ code: 'input/empty' });
  });
});
