import type { ReadFormat } from '../cloud-reader.ts';
import { HEAD_BYTES, isText } from '../signatures.ts';
import { HEADER_LINES, headerNumbers, PtxFault } from './ptx-header.ts';

export const PTX_FORMAT: ReadFormat = {
  label: 'Leica PTX',
  extensions: ['ptx'],
  doc: 'Text grids of one or more scans, each with the place of its scanner; cells without a return are passed over.',
  detect: isPtx,
  open: async (source) => (await import('./open-ptx.ts')).openPtx(source),
};

/** Ten lines of so many numbers; whether the numbers are right, the reader says. */
function isPtx(head: Uint8Array): boolean {
  // The header is short: no more of a large text is decoded to find that it has none.
  const begin = head.subarray(0, HEAD_BYTES / 16);
  if (!isText(begin)) return false;
  const lines = new TextDecoder()
    .decode(begin)
    .trimStart()
    .split(/[\r\n]+\s*/, HEADER_LINES + 1);
  return lines.length > HEADER_LINES && !(headerNumbers(lines) instanceof PtxFault);
}
