import { FloorPlanError } from '../../core/errors.ts';
import type { Vec3 } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import { cutOff } from '../cut-off.ts';
import type { NumberType } from '../records.ts';
import { latin1 } from '../signatures.ts';
import { LINE_FEED } from '../text/characters.ts';

const ENCODINGS = ['ascii', 'binary', 'binary_compressed'] as const;

export interface PcdField {
  readonly name: string;
  /** Undefined for the 8-byte integers, which no coordinate or colour has. */
  readonly type: NumberType | undefined;
  /** Bytes of one value, and how many values a point has. */
  readonly size: number;
  readonly count: number;
}

export interface PcdHeader {
  readonly fields: readonly PcdField[];
  readonly points: number;
  /** More than one row: a grid of directions, in which NaN stands for "no return". */
  readonly isGrid: boolean;
  /** Where the scanner stood; undefined where the header tells nothing but the default pose. */
  readonly viewpoint: Vec3 | undefined;
  readonly encoding: (typeof ENCODINGS)[number];
  /** Byte offset and number (from 1) of the first line after the header. */
  readonly bodyBegin: number;
  readonly bodyLine: number;
}

/** A header is some hundred bytes; one that is longer is none. */
const MAX_HEADER_BYTES = 1 << 16;

const TYPES: Readonly<Record<string, NumberType>> = {
  ...{ F4: 'float32', F8: 'float64' },
  ...{ I1: 'int8', I2: 'int16', I4: 'int32' },
  ...{ U1: 'uint8', U2: 'uint16', U4: 'uint32' },
};

/** Reads the header of a PCD file, versions .5 to .7. @throws input/malformed, input/truncated */
export async function readPcdHeader(source: ByteSource): Promise<PcdHeader> {
  const head = await source.slice(0, MAX_HEADER_BYTES);
  const entries = new Map<string, Entry>();
  let begin = 0;
  for (let line = 1; begin < head.length; line++) {
    const feed = head.indexOf(LINE_FEED, begin);
    const end = feed < 0 ? head.length : feed;
    const text = latin1(head.subarray(begin, end)).trim();
    begin = end + 1;
    if (text === '' || text.startsWith('#')) continue;
    const [key, ...words] = text.split(/\s+/);
    entries.set(key.toUpperCase(), { words, line, text });
    if (key.toUpperCase() !== 'DATA') continue;
    return headerOf({ name: source.name, entries }, Math.min(begin, head.length), line + 1);
  }
  const found = `no such line in ${head.length} bytes`;
  throw cutOff(source.name, 'the PCD header to end with DATA', found, { offset: head.length });
}

/** A line: its first word is the key. */
interface Entry {
  readonly words: readonly string[];
  readonly line: number;
  readonly text: string;
}

interface Entries {
  readonly name: string;
  readonly entries: ReadonlyMap<string, Entry>;
}

function headerOf(from: Entries, bodyBegin: number, bodyLine: number): PcdHeader {
  const encoding = ENCODINGS.find((known) => known === from.entries.get('DATA')?.words[0]?.toLowerCase());
  if (!encoding) return malformed(from, 'DATA', ENCODINGS.join(', '));
  const height = countOf(from, 'HEIGHT') ?? 1;
  const points =
    countOf(from, 'POINTS') ?? (countOf(from, 'WIDTH') ?? malformed(from, 'POINTS', 'a count')) * height;
  return {
    fields: fieldsOf(from),
    points,
    isGrid: height > 1,
    viewpoint: viewpointOf(from),
    encoding,
    bodyBegin,
    bodyLine,
  };
}

function countOf(from: Entries, key: string): number | undefined {
  const entry = from.entries.get(key);
  if (!entry) return undefined;
  return /^\d{1,15}$/.test(entry.words[0] ?? '') ? Number(entry.words[0]) : malformed(from, key, 'a count');
}

function fieldsOf(from: Entries): PcdField[] {
  const names = (from.entries.get('FIELDS') ?? from.entries.get('COLUMNS'))?.words ?? [];
  if (names.length === 0) return malformed(from, 'FIELDS', 'names of fields');
  const sizes = numbersOf(from, 'SIZE', names.length) ?? names.map(() => 4);
  const counts = numbersOf(from, 'COUNT', names.length) ?? names.map(() => 1);
  const types = from.entries.get('TYPE')?.words ?? names.map(() => 'F');
  return names.map((name, i) => {
    const type = `${types[i]}`.toUpperCase();
    if (!/^([FIU]8|[FIU]4|[IU][12])$/.test(type + sizes[i])) {
      return malformed(from, 'TYPE', `F, I or U of 1, 2, 4 or 8 bytes for the field ${name.slice(0, 20)}`);
    }
    return { name, type: TYPES[type + sizes[i]], size: sizes[i], count: counts[i] };
  });
}

function numbersOf(from: Entries, key: string, length: number): number[] | undefined {
  const entry = from.entries.get(key);
  if (!entry) return undefined;
  const isGood = entry.words.length >= length && entry.words.every((word) => /^\d{1,6}$/.test(word));
  return isGood ? entry.words.map(Number) : malformed(from, key, `${length} numbers, one a field`);
}

/**
 * Translation and quaternion: where the scanner stood, in the points' own frame, as PCL uses it to orient normals. The
 * default pose, which every writer puts down, tells nothing.
 */
function viewpointOf({ entries }: Entries): Vec3 | undefined {
  const pose = entries.get('VIEWPOINT')?.words.map(Number) ?? [];
  if (pose.length < 7 || !pose.every(Number.isFinite)) return undefined;
  const isDefault = pose.every((value, i) => value === (i === 3 ? 1 : 0));
  return isDefault ? undefined : [pose[0], pose[1], pose[2]];
}

function malformed({ name, entries }: Entries, key: string, expected: string): never {
  const entry = entries.get(key);
  const where = entry ? ` in line ${entry.line}` : '';
  const shown = entry ? `"${entry.text.slice(0, 40)}"` : `no ${key}`;
  throw new FloorPlanError(
    'input/malformed',
    `${name}: expected ${expected} at ${key}${where} of the PCD header, found ${shown}`,
    { hint: 'Export the cloud again.', detail: entry ? { line: entry.line, text: shown } : {} },
  );
}
