import { FloorPlanError } from '../../core/errors.ts';
import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';

const END_MARK = 0x06054b50;
const END_BYTES = 22;
const LOCATOR_64_MARK = 0x07064b50;
const LOCATOR_64_BYTES = 20;
const END_64_MARK = 0x06064b50;
const END_64_BYTES = 56;
const ENTRY_MARK = 0x02014b50;
const ENTRY_BYTES = 46;
const LOCAL_MARK = 0x04034b50;
const LOCAL_BYTES = 30;
/** The comment after the end record is no longer than 16 bits tell. */
const MOST_COMMENT = 0xffff;
const MOST_DIRECTORY_BYTES = 1 << 24;
const MARK_64_BIT = 0xffffffff;
const ENCRYPTED = 1;
const UTF_8 = 1 << 11;

/** A file in a ZIP archive. */
export interface ZipEntry {
  /** With its folders. */
  readonly name: string;
  /** 0 stored, 8 deflated; others are not read. */
  readonly method: number;
  readonly isEncrypted: boolean;
  readonly packedBytes: number;
  readonly bytes: number;
  /** Byte offset of its local header. */
  readonly offset: number;
}

/**
 * The files of a ZIP archive [APPNOTE] §4.3, those of more than 4 GB too; folders are left out.
 *
 * @throws input/malformed, input/truncated
 */
export async function readZipDirectory(source: ByteSource): Promise<ZipEntry[]> {
  // A URL tells its size with the first bytes.
  await source.slice(0, 1);
  const { name, size } = source;
  if (size === undefined) {
    throw new FloorPlanError('input/unreadable', `${name}: the server does not tell the archive's size`, {
      hint: 'Download the archive and open the file.',
    });
  }
  const tail = await source.slice(Math.max(0, size - END_BYTES - MOST_COMMENT), size);
  const end = await findEnd(source, viewOf(tail), size - tail.length);
  if (end.offset + end.bytes > size || end.bytes > MOST_DIRECTORY_BYTES) throw noDirectory(name, end.offset);
  const entries = parseEntries(name, await source.slice(end.offset, end.offset + end.bytes), end.count);
  const packed = entries.reduce((sum, { packedBytes }) => sum + packedBytes, 0);
  // A bomb's files share their bytes: a few megabytes would unpack to terabytes.
  if (packed > size) throw overlapping(name, packed, size);
  return entries;
}

function overlapping(name: string, packed: number, size: number): FloorPlanError {
  return new FloorPlanError(
    'input/malformed',
    `${name}: expected files side by side in an archive of ${size} bytes, found files of ${packed} bytes`,
    { hint: 'The archive seems damaged or made to do harm; pack the scan again.', detail: { packed } },
  );
}

/** Byte offset of an entry's packed bytes. @throws input/malformed */
export async function entryBegin(source: ByteSource, { offset, name }: ZipEntry): Promise<number> {
  const view = viewOf(await source.slice(offset, offset + LOCAL_BYTES));
  if (view.byteLength < LOCAL_BYTES || view.getUint32(0, true) !== LOCAL_MARK) {
    throw damaged(source.name, `a file header of ${name}`, offset);
  }
  return offset + LOCAL_BYTES + view.getUint16(26, true) + view.getUint16(28, true);
}

interface Directory {
  readonly offset: number;
  readonly bytes: number;
  readonly count: number;
}

/** @param base byte offset of the tail */
async function findEnd(source: ByteSource, tail: DataView, base: number): Promise<Directory> {
  for (let at = tail.byteLength - END_BYTES; at >= 0; at--) {
    if (tail.getUint32(at, true) !== END_MARK) continue;
    const found = {
      count: tail.getUint16(at + 10, true),
      bytes: tail.getUint32(at + 12, true),
      offset: tail.getUint32(at + 16, true),
    };
    const locator = at - LOCATOR_64_BYTES;
    const is64 = locator >= 0 && tail.getUint32(locator, true) === LOCATOR_64_MARK;
    return is64 ? findEnd64(source, Number(tail.getBigUint64(locator + 8, true))) : found;
  }
  throw new FloorPlanError(
    'input/truncated',
    `${source.name}: expected the directory of a ZIP archive at its end, found none in the last ${tail.byteLength} bytes from ${base} on`,
    { hint: 'The archive seems cut off; copy it or pack it again.', detail: { offset: base } },
  );
}

async function findEnd64(source: ByteSource, offset: number): Promise<Directory> {
  const view = viewOf(await source.slice(offset, offset + END_64_BYTES));
  if (view.byteLength < END_64_BYTES || view.getUint32(0, true) !== END_64_MARK) {
    throw noDirectory(source.name, offset);
  }
  return {
    count: Number(view.getBigUint64(32, true)),
    bytes: Number(view.getBigUint64(40, true)),
    offset: Number(view.getBigUint64(48, true)),
  };
}

function parseEntries(archive: string, bytes: Uint8Array, count: number): ZipEntry[] {
  const view = viewOf(bytes);
  const entries: ZipEntry[] = [];
  let at = 0;
  for (let i = 0; i < count; i++) {
    if (at + ENTRY_BYTES > bytes.length || view.getUint32(at, true) !== ENTRY_MARK) {
      throw damaged(archive, `entry ${i + 1} of ${count} in the directory`, at);
    }
    const nameEnd = at + ENTRY_BYTES + view.getUint16(at + 28, true);
    const extraEnd = nameEnd + view.getUint16(at + 30, true);
    if (extraEnd > bytes.length) throw damaged(archive, `a whole entry ${i + 1} in the directory`, at);
    const flags = view.getUint16(at + 8, true);
    const name = decodeName(bytes.subarray(at + ENTRY_BYTES, nameEnd), (flags & UTF_8) !== 0);
    const sizes = sizesOf(view, at, nameEnd, extraEnd);
    const entry = {
      name,
      method: view.getUint16(at + 10, true),
      isEncrypted: (flags & ENCRYPTED) !== 0,
      ...sizes,
    };
    if (!name.endsWith('/')) entries.push(entry);
    at = extraEnd + view.getUint16(at + 32, true);
  }
  return entries;
}

/** The 64-bit figures stand in an extra field, only those whose 32 bits are full. */
function sizesOf(view: DataView, at: number, nameEnd: number, extraEnd: number) {
  const sizes = {
    bytes: view.getUint32(at + 24, true),
    packedBytes: view.getUint32(at + 20, true),
    offset: view.getUint32(at + 42, true),
  };
  for (let field = nameEnd; field + 4 <= extraEnd; field += 4 + view.getUint16(field + 2, true)) {
    if (view.getUint16(field, true) !== 1) continue;
    let value = field + 4;
    for (const key of ['bytes', 'packedBytes', 'offset'] as const) {
      if (sizes[key] !== MARK_64_BIT || value + 8 > extraEnd) continue;
      sizes[key] = Number(view.getBigUint64(value, true));
      value += 8;
    }
  }
  return sizes;
}

/** Names without the flag are in the packer's code page; Latin-1 is near enough for a message. */
function decodeName(bytes: Uint8Array, isUtf8: boolean): string {
  return new TextDecoder(isUtf8 ? 'utf-8' : 'latin1').decode(bytes);
}

function noDirectory(name: string, offset: number): FloorPlanError {
  return damaged(name, 'the directory of a ZIP archive', offset);
}

function damaged(name: string, expected: string, offset: number): FloorPlanError {
  return new FloorPlanError(
    'input/malformed',
    `${name}: expected ${expected}, found other bytes at ${offset}`,
    {
      hint: 'The archive seems damaged; copy it or pack it again.',
      detail: { offset },
    },
  );
}
