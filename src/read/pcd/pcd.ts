import type { ReadFormat } from '../cloud-reader.ts';
import { latin1 } from '../signatures.ts';

/** Comments and blank lines, then the first entry of a header: its version, or in old files its fields. */
const HEADER = /^(\s|#[^\n]*\n)*(VERSION\s+\.?\d|(FIELDS|COLUMNS)\s[^\n]*\n(\s|#[^\n]*\n)*SIZE\s)/i;
const MARK = /^#\s*\.PCD\b/i;
/** A header's first entry comes sooner. */
const LOOKED_AT_BYTES = 4096;

export const PCD_FORMAT: ReadFormat = {
  label: 'PCD',
  extensions: ['pcd'],
  doc: 'Point Cloud Library: text, binary and compressed, with colour, intensity and the place of the scanner.',
  detect: (head) => {
    const text = latin1(head.subarray(0, LOOKED_AT_BYTES));
    return MARK.test(text) || HEADER.test(text);
  },
  open: async (source) => (await import('./pcd-reader.ts')).openPcd(source),
};
