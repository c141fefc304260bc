/** Files that must fail with a clear error; used against the reader, the command and the page. */
import type { ErrorCode } from '../src/core/errors.ts';

export interface BadInput {
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly code: ErrorCode;
  /** What the message must tell: where, or what was found. */
  readonly says: RegExp;
}

const text = (content: string) => new TextEncoder().encode(content);

function plyHeader(vertices: number, format = 'binary_little_endian'): string {
  const properties = ['x', 'y', 'z'].map((axis) => `property float ${axis}`).join('\n');
  return `ply\nformat ${format} 1.0\nelement vertex ${vertices}\n${properties}\nend_header\n`;
}

function binaryPly(vertices: number, points: readonly (readonly number[])[]): Uint8Array<ArrayBuffer> {
  const header = text(plyHeader(vertices));
  const bytes = new Uint8Array(header.length + points.length * 12);
  bytes.set(header);
  const view = new DataView(bytes.buffer, header.length);
  for (const [k, value] of points.flat().entries()) view.setFloat32(4 * k, value, true);
  return bytes;
}

const repeat = <T>(n: number, make: (i: number) => T): T[] => Array.from({ length: n }, (_, i) => make(i));
const csv = (rows: readonly (readonly (number | string)[])[]) =>
  text(rows.map((row) => row.join(',')).join('\n'));

export const BAD_INPUTS: readonly BadInput[] = [
  { name: 'empty.ply', bytes: text(''), code: 'input/empty', says: /0 bytes|empty/i },
  { name: 'empty.csv', bytes: text(''), code: 'input/empty', says: /0 bytes|empty/i },
  {
    name: 'header-only.ply',
    bytes: text(plyHeader(0)),
    code: 'input/empty',
    says: /no points|0 (points|vertices)/i,
  },
  { name: 'header-only.csv', bytes: text('x,y,z\n'), code: 'input/empty', says: /no points/i },
  {
    name: 'truncated.ply',
    bytes: binaryPly(
      100,
      repeat(40, (i) => [i, i * i, 1]),
    ),
    code: 'input/truncated',
    says: /byte/,
  },
  {
    name: 'huge-announced.ply',
    bytes: binaryPly(
      180_000_000,
      repeat(70, (i) => [i, i * i, 1]),
    ),
    code: 'input/truncated',
    says: /180,?000,?000|2,?160,?000/,
  },
  {
    name: 'words.csv',
    bytes: csv([['x', 'y', 'z'], ...repeat(20, (i) => [i, i === 13 ? 'thirteen' : i, 1])]),
    code: 'input/malformed',
    says: /line 15.*thirteen/,
  },
  {
    name: 'one-point.csv',
    bytes: csv([
      ['x', 'y', 'z'],
      [1, 2, 3],
    ]),
    code: 'input/too-few-points',
    says: /1 point/,
  },
  {
    name: 'equal.csv',
    bytes: csv([['x', 'y', 'z'], ...repeat(500, () => [1, 2, 3])]),
    code: 'input/too-few-points',
    says: /1 (distinct )?point|same place|distinct/,
  },
  {
    name: 'collinear.csv',
    bytes: csv([['x', 'y', 'z'], ...repeat(500, (i) => [i * 0.5, i * 0.25, 1])]),
    code: 'input/degenerate',
    says: /line/,
  },
  {
    name: 'nan.ply',
    bytes: binaryPly(
      50,
      repeat(50, () => [Number.NaN, Number.NaN, Number.POSITIVE_INFINITY]),
    ),
    code: 'input/not-finite',
    says: /50/,
  },
  {
    name: 'photo.ply',
    bytes: new Uint8Array([
      0xff,
      0xd8,
      0xff,
      0xe0,
      0,
      16,
      ...text('JFIF'),
      ...repeat(4000, (i) => (i * 89 + (i >> 3)) & 255),
    ]),
    code: 'input/unknown-format',
    says: /JPEG/,
  },
];
