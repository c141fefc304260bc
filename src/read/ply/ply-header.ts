import { FloorPlanError } from '../../core/errors.ts';
import type { ByteSource } from '../bytes/source.ts';
import { cutOff } from '../cut-off.ts';
import { NUMBER_BYTES, type NumberType } from '../records.ts';
import { latin1 } from '../signatures.ts';
import { CARRIAGE_RETURN, LINE_FEED } from '../text/characters.ts';

/** What PLY calls its types. */
export const NUMBER_TYPE_OF = {
  char: 'int8',
  uchar: 'uint8',
  short: 'int16',
  ushort: 'uint16',
  int: 'int32',
  uint: 'uint32',
  float: 'float32',
  double: 'float64',
} as const satisfies Record<string, NumberType>;
export type PlyType = keyof typeof NUMBER_TYPE_OF;

/** Bytes of a value. */
export function valueBytes(type: PlyType): number {
  return NUMBER_BYTES[NUMBER_TYPE_OF[type]];
}

const TYPES: Readonly<Record<string, PlyType>> = {
  ...{ char: 'char', uchar: 'uchar', short: 'short', ushort: 'ushort' },
  ...{ int: 'int', uint: 'uint', float: 'float', double: 'double' },
  ...{ int8: 'char', uint8: 'uchar', int16: 'short', uint16: 'ushort' },
  ...{ int32: 'int', uint32: 'uint', float32: 'float', float64: 'double' },
};

export interface PlyProperty {
  readonly name: string;
  readonly type: PlyType;
  /** Type of a list's length; absent where the property is a single value. */
  readonly countType?: PlyType;
}

export interface PlyElement {
  readonly name: string;
  readonly count: number;
  readonly properties: readonly PlyProperty[];
}

export interface PlyHeader {
  readonly format: 'ascii' | 'binary_little_endian' | 'binary_big_endian';
  readonly elements: readonly PlyElement[];
  /** Byte offset and number (from 1) of the first line after the header. */
  readonly bodyBegin: number;
  readonly bodyLine: number;
}

/** What writers call the list of a face's vertices. */
const VERTEX_LISTS = ['vertex_indices', 'vertex_index'];

/** Which property of an element lists the vertices of a face; −1 where it has no faces. */
export function vertexListOf({ name: element, count, properties }: PlyElement): number {
  if (element !== 'face' || count === 0) return -1;
  return properties.findIndex(({ name, countType }) => countType && VERTEX_LISTS.includes(name));
}

/** A header with more comments than this is none. */
const MAX_HEADER_BYTES = 1 << 20;
const FIRST_TRY_BYTES = 1 << 13;

/** Reads a PLY header [Turk94]; lines may end in LF, CRLF or CR. @throws input/malformed, input/truncated */
export async function readPlyHeader(source: ByteSource): Promise<PlyHeader> {
  for (let length = FIRST_TRY_BYTES; ; length *= 16) {
    const head = await source.slice(0, Math.min(length, MAX_HEADER_BYTES));
    const lines = headerLines(head);
    if (lines.isWhole) return parseHeader(source.name, lines);
    if (head.length < length) throw headerCut(source.name, head.length);
  }
}

interface HeaderLines {
  readonly lines: readonly string[];
  readonly end: number;
  /** Whether `end_header` was found. */
  readonly isWhole: boolean;
}

/** The first line's end tells what ends all lines: after a CR, a binary body may begin with a byte like LF. */
function headerLines(head: Uint8Array): HeaderLines {
  const carriage = head.indexOf(CARRIAGE_RETURN);
  const feed = head.indexOf(LINE_FEED);
  const hasCarriage = carriage >= 0 && (feed < 0 || carriage < feed);
  const endByte = hasCarriage && feed !== carriage + 1 ? CARRIAGE_RETURN : LINE_FEED;
  const lines: string[] = [];
  let begin = 0;
  while (begin < head.length) {
    const end = head.indexOf(endByte, begin);
    // A file may end with its header, and the header without an end of line.
    const line = latin1(head.subarray(begin, end < 0 ? head.length : end)).trim();
    const isLast = line === 'end_header';
    if (end < 0 && !isLast) break;
    lines.push(line);
    begin = end < 0 ? head.length : end + 1;
    if (isLast) return { lines, end: begin, isWhole: true };
  }
  return { lines, end: begin, isWhole: false };
}

function parseHeader(name: string, { lines, end }: HeaderLines): PlyHeader {
  let format: PlyHeader['format'] | null = null;
  const elements: { name: string; count: number; properties: PlyProperty[] }[] = [];
  for (const [index, line] of lines.entries()) {
    const words = line.split(/\s+/);
    const fail = (expected: string) => malformed(name, index + 1, expected, line);
    if (words[0] === 'format') format = parseFormat(words[1]) ?? fail('ascii or binary format');
    else if (words[0] === 'element') elements.push(parseElement(words) ?? fail('element NAME COUNT'));
    else if (words[0] === 'property') {
      const property = parseProperty(words) ?? fail('property TYPE NAME or property list TYPE TYPE NAME');
      (elements.at(-1) ?? fail('an element before its properties')).properties.push(property);
    } else if (index > 0 && !['comment', 'obj_info', 'end_header', ''].includes(words[0])) {
      fail('format, element, property or comment');
    }
  }
  if (!format) return malformed(name, 2, 'a format line', lines[1] ?? '');
  return { format, elements, bodyBegin: end, bodyLine: lines.length + 1 };
}

function parseFormat(word: string | undefined): PlyHeader['format'] | null {
  return word === 'ascii' || word === 'binary_little_endian' || word === 'binary_big_endian' ? word : null;
}

function parseElement(
  words: readonly string[],
): { name: string; count: number; properties: PlyProperty[] } | null {
  const [, name, count] = words;
  if (!name || !/^\d{1,15}$/.test(count ?? '')) return null;
  return { name, count: Number(count), properties: [] };
}

function parseProperty(words: readonly string[]): PlyProperty | null {
  if (words[1] === 'list') {
    const [, , count, item, name] = words;
    const [countType, type] = [TYPES[count], TYPES[item]];
    return countType && type && name ? { name, type, countType } : null;
  }
  const type = TYPES[words[1]];
  return type && words[2] ? { name: words[2], type } : null;
}

function malformed(name: string, line: number, expected: string, found: string): never {
  const shown = found.slice(0, 40);
  throw new FloorPlanError(
    'input/malformed',
    `${name}: expected ${expected} in line ${line} of the PLY header, found "${shown}"`,
    { hint: 'Export the cloud again.', detail: { line, text: shown } },
  );
}

function headerCut(name: string, offset: number): FloorPlanError {
  const found = `no such line in ${offset} bytes`;
  return cutOff(name, 'the PLY header to end with end_header', found, { offset });
}
