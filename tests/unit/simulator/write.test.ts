import { describe, expect, it } from 'vitest';
import { writeCsv, writePly } from '../../../fixtures/simulator/index.ts';

const positions = Float64Array.of(1.5, -2.25, 3, 691_870.123456, 5_336_020.5, 0.1);
const colour = Uint8Array.of(1, 2, 3, 250, 251, 252);

function parts(file: Uint8Array): { head: string[]; body: DataView } {
  const text = Buffer.from(file).toString('latin1');
  const end = text.indexOf('end_header\n') + 'end_header\n'.length;
  return { head: text.slice(0, end).trim().split('\n'), body: new DataView(file.buffer, end) };
}

describe('writePly', () => {
  it.each([
    ['binary_little_endian', true],
    ['binary_big_endian', false],
  ] as const)('%s: floats and colour in their places', (format, isLittle) => {
    const { head, body } = parts(writePly({ positions, colour }, { format, comments: ['made up'] }));
    expect(head).toEqual([
      'ply',
      `format ${format} 1.0`,
      'comment made up',
      'element vertex 2',
      'property float x',
      'property float y',
      'property float z',
      'property uchar red',
      'property uchar green',
      'property uchar blue',
      'end_header',
    ]);
    expect(body.byteLength).toBe(2 * 15);
    expect(body.getFloat32(4, isLittle)).toBe(-2.25);
    expect([12, 13, 14].map((at) => body.getUint8(at))).toEqual([1, 2, 3]);
    expect(body.getFloat32(15, isLittle)).toBe(Math.fround(691_870.123456));
    expect(body.getUint8(29)).toBe(252);
  });

  it('keeps doubles to the last bit', () => {
    const { body } = parts(writePly({ positions }, { type: 'double' }));
    expect(Array.from({ length: 6 }, (_, i) => body.getFloat64(i * 8, true))).toEqual([...positions]);
  });

  it('writes ascii that reads back unchanged', () => {
    const text = Buffer.from(writePly({ positions, colour }, { format: 'ascii', type: 'double' })).toString();
    const rows = text.split('end_header\n')[1].trim().split('\n');
    expect(rows).toEqual(['1.5 -2.25 3 1 2 3', '691870.123456 5336020.5 0.1 250 251 252']);
  });
});

describe('writeCsv', () => {
  it('writes rows with header, separator and digits as asked', () => {
    expect(writeCsv(Float64Array.of(1, 2, 3.4567, 4), 2, { header: ['x', 'y'], digits: 2 })).toBe(
      'x,y\n1.00,2.00\n3.46,4.00\n',
    );
    expect(writeCsv(Float64Array.of(1, 2, 3), 3, { separator: ';' })).toBe('1;2;3\n');
  });
});
