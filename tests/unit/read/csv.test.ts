import { describe, expect, it } from 'vitest';
import { memorySource, readAll } from './memory-source.ts';

const read = (text: string | Uint8Array, name = 'a.csv') => readAll(memorySource(text, name));
const TWO = [
  [1.5, 2, -3],
  [4, 5.25, 6],
];

describe('separators', () => {
  it.each([
    ['comma', '1.5,2,-3\n4,5.25,6\n'],
    ['comma and blank', '1.5, 2, -3\n4 , 5.25 ,6\n'],
    ['semicolon', '1.5;2;-3\n4;5.25;6\n'],
    ['tab', '1.5\t2\t-3\n4\t5.25\t6\n'],
    ['blanks', '  1.5  2 \t -3\n 4 5.25 6  \n'],
    ['semicolon, decimal comma', '1,5;2;-3\n4;5,25;6\n'],
    ['tab, decimal comma', '1,5\t2\t-3\n4\t5,25\t6\n'],
    ['blanks, decimal comma', '1,5 2,0 -3,0\n4,0 5,25 6\n'],
    ['quotes', '"1.5","2","-3"\n"4",5.25,"6"\n'],
    ['quotes, decimal comma', '"1,5";"2";"-3"\n"4";"5,25";"6"\n'],
    ['comma, decimal comma in quotes', '"1,5","2","-3"\n4,"5,25","6"\n'],
    ['scientific', '1.5E0,+20e-1,-.3e+1\n4.,0525e-2,6\n'],
    ['CRLF', '1.5,2,-3\r\n4,5.25,6\r\n'],
    ['CR', '1.5,2,-3\r4,5.25,6\r'],
    ['no last end of line', '1.5,2,-3\n4,5.25,6'],
    ['byte order mark', '\ufeff1.5,2,-3\n4,5.25,6\n'],
    ['empty lines and comments', '# a\n\n1.5,2,-3\n// b\n% c\n   \n4,5.25,6\n\n'],
    ['a comma after the last', '1.5,2,-3,\n4,5.25,6,\n'],
    ['a count on the first line', '2\n1.5 2 -3\n4 5.25 6\n'],
  ])('%s', async (_, text) => {
    const { xyz, isSlice } = await read(text);
    expect(xyz).toEqual(TWO);
    expect(isSlice).toBe(false);
  });
});

describe('columns', () => {
  it.each([
    ['x,y,z', '1.5,2,-3\n4,5.25,6'],
    ['X;Y;Z', '1.5;2;-3\n4;5.25;6'],
    ['//X Y Z', '1.5 2 -3\n4 5.25 6'],
    ['# x, y, z', '1.5,2,-3\n4,5.25,6'],
    ['"x [m]","y [m]","z [m]"', '1.5,2,-3\n4,5.25,6'],
    ['Easting,Northing,Elevation', '1.5,2,-3\n4,5.25,6'],
    ['id,z,label,y,x', '7,-3,wall,2,1.5\n8,6,floor,5.25,4'],
    ['foo,bar,baz', '1.5,2,-3\n4,5.25,6'],
    ['z,y,x,height', '-3,2,1.5,99\n6,5.25,4,98'],
    ['"t","Points:0","Points:1","Points:2"', '7,1.5,2,-3\n8,4,5.25,6'],
    ['z,y,x\nm,m,m', '-3,2,1.5\n6,5.25,4'],
    ['My flat, first floor\nExported today\n\nz;y;x', '-3;2;1.5\n6;5.25;4'],
    ['//z y x\n2', '-3 2 1.5\n6 5.25 4'],
  ])('%s', async (header, rows) => {
    expect((await read(`${header}\n${rows}\n`)).xyz).toEqual(TWO);
  });

  it('passes over row numbers', async () => {
    const rows = [
      [1.5, 2, -3],
      [4, 5.25, 6],
      [7, 8, 9.5],
    ];
    const numbered = rows.map((row, i) => [i + 17, ...row].join(',')).join('\n');
    expect((await read(numbered)).xyz).toEqual(rows);
  });

  it('takes coordinates on a grid for no row numbers', async () => {
    const rows = [0, 1, 2, 3].map((x) => [x, 4, 0.5]);
    expect((await read(rows.map((row) => [...row, 0.25].join(' ')).join('\n'))).xyz).toEqual(rows);
  });

  it.each(['1.5,2,\n4,5.25,\n', 'x,z,\n1.5,2,\n4,5.25,\n', '1.5;2;;;\n4;5.25;;;'])(
    'counts no empty columns at the end: %j',
    async (text) => {
      expect(await read(text)).toMatchObject({
        isSlice: true,
        xyz: [
          [1.5, 2, 0],
          [4, 5.25, 0],
        ],
      });
    },
  );

  it('finds colour, intensity and class by name', async () => {
    const text = 'b,g,r,x,y,z,Intensity,class\n3,2,1,10,20,30,0.5,6\n6,5,4,11,21,31,0.25,2\n';
    expect(await read(text)).toEqual({
      isSlice: false,
      xyz: [
        [10, 20, 30],
        [11, 21, 31],
      ],
      colour: [
        [1, 2, 3],
        [4, 5, 6],
      ],
      intensity: [0.5, 0.25],
      classification: [6, 2],
    });
  });

  it('leaves attributes out that are text', async () => {
    expect((await read('x,y,z,class\n1,2,3,wall\n4,5,6,floor\n')).classification).toBeUndefined();
  });

  it.each([
    ['1 2 3 10 20 255', [[10, 20, 255]], undefined],
    ['1 2 3 -0.5 10 20 255', [[10, 20, 255]], [-0.5]],
    ['1 2 3 10 20 255 0.5', [[10, 20, 255]], [0.5]],
    ['1 2 3 0.7', undefined, [Math.fround(0.7)]],
    ['1 2 3 0.1 -0.9 0.2', undefined, undefined],
  ])('finds colour and intensity by position: %s', async (row, colour, intensity) => {
    const points = await read(`${row}\n`, 'a.xyz');
    expect(points.xyz).toEqual([[1, 2, 3]]);
    expect(points.colour).toEqual(colour);
    expect(points.intensity).toEqual(intensity);
  });

  it('scales colours that go to 1', async () => {
    expect((await read('x,y,z,r,g,b\n1,2,3,0,0.5,1\n')).colour).toEqual([[0, 128, 255]]);
  });
});

describe('slices', () => {
  it.each(['', 'x,y\n', 'X,Z\n', 'a,b\n', 'y,x\n'])('two columns with the header %j', async (header) => {
    expect(await read(`${header}1.5,2\n4,5.25\n`)).toMatchObject({
      isSlice: true,
      xyz: [
        [1.5, 2, 0],
        [4, 5.25, 0],
      ],
    });
  });

  it('takes two named coordinates among other columns', async () => {
    expect(await read('id,x,z,intensity\n1,10,20,0.5\n2,11,21,0.5\n')).toMatchObject({
      isSlice: true,
      xyz: [
        [10, 20, 0],
        [11, 21, 0],
      ],
    });
  });
});

describe('values that are no places', () => {
  it.each(['nan', 'NaN', '-nan(ind)', 'inf', '-Infinity', '1.#QNAN', 'null', 'N/A', '""', ''])(
    '%j',
    async (text) => {
      const { xyz } = await read(`x,y,z\n1,2,3\n4,${text},6\n7,8,${text}\n`);
      expect(xyz).toHaveLength(3);
      expect(Number.isFinite(xyz[1][1])).toBe(false);
      expect(Number.isFinite(xyz[2][2])).toBe(false);
    },
  );
});

describe('errors', () => {
  it('names line, column and text', async () => {
    await expect(read('x,y,z\n1,2,3\r\n4,5,6\r\n\n7,thirteen and a half,9\n')).rejects.toMatchObject({
      code: 'input/malformed',
      detail: { line: 5, column: 2, text: 'thirteen and a half' },
    });
  });

  it.each(['\n', '\r\n', '\r'])(
    'counts lines that end in %j however the bytes are split',
    async (lineEnd) => {
      const text = ['x,y,z', '1,2,3', '', '4,5,6', '7,oops,9', ''].join(lineEnd);
      for (const size of [1, 2, 3, 7, 100]) {
        await expect(readAll(memorySource(text, 'a.csv', [size]))).rejects.toMatchObject({
          detail: { line: 5 },
        });
      }
    },
  );

  it('shows the row that is to blame where no column is a number, not the header', async () => {
    const rows = '389.002,03;5.819.004,5;1.2.3\n'.repeat(3);
    await expect(read(`x;y;z\n${rows}`)).rejects.toMatchObject({
      code: 'input/malformed',
      message: expect.stringContaining('found "389.002,03;'),
    });
  });

  it('cuts long text', async () => {
    await expect(read(`1,2,3\n1,${'z'.repeat(500)},3\n`)).rejects.toMatchObject({
      detail: { text: 'z'.repeat(40) },
    });
  });

  it.each(['1,2x,3', '1,2 3,3', '1,--2,3', '1,2e,3', '1,1.2.3,3', '1,0x10,3'])('refuses %j', async (row) => {
    await expect(read(`x,y,z\n1,2,3\n${row}\n`)).rejects.toMatchObject({ code: 'input/malformed' });
  });

  it('tells short rows from a cut-off file', async () => {
    await expect(read('1,2,3\n4,5\n7,8,9\n')).rejects.toMatchObject({
      code: 'input/malformed',
      detail: { line: 2 },
    });
    await expect(read('1,2,3\n4,5,6\n7,8')).rejects.toMatchObject({
      code: 'input/truncated',
      detail: { line: 3 },
    });
    await expect(read('1 2 3\n4 5 6\n7')).rejects.toMatchObject({ code: 'input/truncated' });
  });

  it('reads numbers of any length', async () => {
    const { xyz } = await read(`1,2,3\n1,${'0'.repeat(300_000)}5,0.${'3'.repeat(300_000)}\n`);
    expect(xyz[1]).toEqual([1, 5, 1 / 3]);
  });

  it('gives up on a line without end', async () => {
    await expect(read(`1,2,3\n${'1'.repeat(3 << 20)}`)).rejects.toMatchObject({ code: 'input/malformed' });
  });
});
