import type { ReadFormat } from '../cloud-reader.ts';
import { latin1 } from '../signatures.ts';

/** First bytes of every E57 file. */
const MAGIC = 'ASTM-E57';

export const E57_FORMAT: ReadFormat = {
  label: 'E57',
  extensions: ['e57'],
  doc: 'ASTM E2807, from terrestrial scanners: all scans in their poses, cartesian or spherical, with colour and intensity; checksums are checked.',
  detect: (head) => latin1(head.subarray(0, MAGIC.length)) === MAGIC,
  open: async (source) => (await import('./open-e57.ts')).openE57(source),
};
