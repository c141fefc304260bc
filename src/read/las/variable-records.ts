import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';
import { latin1 } from '../signatures.ts';
import type { LasHeader } from './las-header.ts';

/** A variable length record: something a program adds to a LAS file under its name. */
export interface VariableRecord {
  readonly user: string;
  readonly id: number;
  readonly bytes: Uint8Array;
}

const HEADER_BYTES = 54;
const EXTENDED_HEADER_BYTES = 60;
/** Records are read up to here: a CRS takes some kilobytes, waveforms and images are passed over. */
const MOST_BYTES = 1 << 24;
const MOST_EXTENDED = 256;

/**
 * The records before the points, then those behind them, as many as are whole: a record that announces more bytes
 * than there are ends the list, for a plan can be made without it.
 */
export async function readVariableRecords(source: ByteSource, header: LasHeader): Promise<VariableRecord[]> {
  const { headerBytes, pointsBegin, records, extended } = header;
  const end = Math.min(pointsBegin, headerBytes + MOST_BYTES);
  const list = records === 0 ? [] : parseRecords(await source.slice(headerBytes, end), records);
  if (list.some(isCrs) || extended.begin < pointsBegin || source.isSequential) return list;
  return [...list, ...(await readExtended(source, extended))];
}

export function isCrs({ user }: VariableRecord): boolean {
  return user === 'LASF_Projection';
}

function parseRecords(bytes: Uint8Array, count: number): VariableRecord[] {
  const view = viewOf(bytes);
  const list: VariableRecord[] = [];
  let begin = 0;
  while (list.length < count && begin + HEADER_BYTES <= bytes.length) {
    const end = begin + HEADER_BYTES + view.getUint16(begin + 20, true);
    if (end > bytes.length) break;
    list.push({
      user: userAt(bytes, begin + 2),
      id: view.getUint16(begin + 18, true),
      bytes: bytes.subarray(begin + HEADER_BYTES, end),
    });
    begin = end;
  }
  return list;
}

/** Only the CRS is looked for here. */
async function readExtended(
  source: ByteSource,
  { begin, count }: LasHeader['extended'],
): Promise<VariableRecord[]> {
  const list: VariableRecord[] = [];
  let at = begin;
  for (let i = 0; i < Math.min(count, MOST_EXTENDED); i++) {
    if (source.size === undefined || at + EXTENDED_HEADER_BYTES > source.size) break;
    const head = await source.slice(at, at + EXTENDED_HEADER_BYTES);
    if (head.length < EXTENDED_HEADER_BYTES) break;
    const view = viewOf(head);
    const length = Number(view.getBigUint64(20, true));
    at += EXTENDED_HEADER_BYTES;
    if (at + length > source.size) break;
    const record = { user: userAt(head, 2), id: view.getUint16(18, true) };
    if (isCrs({ ...record, bytes: head }) && length <= MOST_BYTES)
      list.push({ ...record, bytes: await source.slice(at, at + length) });
    at += length;
  }
  return list;
}

function userAt(bytes: Uint8Array, at: number): string {
  return latin1(bytes.subarray(at, at + 16)).replace(/\0.*$/s, '');
}
