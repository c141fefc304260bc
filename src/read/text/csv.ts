import { FloorPlanError } from '../../core/errors.ts';
import type { Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud, ReadFormat } from '../cloud-reader.ts';
import { HEAD_BYTES, isText, recogniseForeign } from '../signatures.ts';
import { layOutCsv } from './csv-layout.ts';
import { wholeLines } from './line-blocks.ts';
import { readTextPoints } from './text-points.ts';

/** Looked at where the first 64 KiB hold nothing but comments or very long rows. */
const LONG_HEAD_BYTES = 1 << 20;

export const CSV_FORMAT: ReadFormat = {
  label: 'Text table',
  extensions: ['csv', 'txt', 'xyz', 'tsv', 'asc'],
  doc: 'One point a line; comma, semicolon, tab or blanks; columns by name or position. Two columns are a ready slice.',
  detect: (head) =>
    isText(head) && recogniseForeign(head) === null && (layOutCsv(wholeLines(head))?.isSure ?? false),
  open: openCsv,
};

/**
 * Finds out what the columns of a text table are.
 *
 * @throws input/empty, input/malformed
 */
async function openCsv(source: ByteSource): Promise<OpenCloud> {
  const short = await source.slice(0, HEAD_BYTES);
  const layout =
    layOutCsv(wholeLines(short)) ??
    layOutCsv(wholeLines(await source.slice(0, LONG_HEAD_BYTES), LONG_HEAD_BYTES));
  if (!layout) throw noTable(source, short);
  const { begin, line } = layout;
  const warnings: Warning[] = [];
  return {
    isSlice: layout.isSlice,
    chunks: (progress) => readTextPoints(source, { layout, begin, line, warnings }, progress),
    warnings,
  };
}

function noTable({ name }: ByteSource, head: Uint8Array): FloorPlanError {
  const text = new TextDecoder().decode(head);
  const rows = text.split(/[\r\n]+/).filter((line) => !/^\s*(#|%|\/\/|$)/.test(line));
  if (rows.length === 1 && !/\d/.test(rows[0])) {
    return new FloorPlanError('input/empty', `${name}: expected points after the header, found no points`, {
      hint: 'Export the cloud again.',
    });
  }
  if (rows.length === 0) {
    return new FloorPlanError('input/empty', `${name}: found no points, only blank lines and comments`, {
      hint: 'Export the cloud again.',
    });
  }
  // The header is not to blame where a row that may hold numbers follows it.
  const shown = (rows.find((row) => /^\W*\d/.test(row)) ?? rows[0]).trim().slice(0, 40);
  return new FloorPlanError(
    'input/malformed',
    `${name}: expected rows of two or more numbers, found "${shown}"`,
    {
      hint: 'A text table has one point a line: x, y and z, or x and y for a slice.',
      detail: { text: shown },
    },
  );
}
