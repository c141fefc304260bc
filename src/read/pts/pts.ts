import type { ReadFormat } from '../cloud-reader.ts';
import { isText } from '../signatures.ts';
import { layOutPts } from './pts-layout.ts';

export const PTS_FORMAT: ReadFormat = {
  label: 'Leica PTS',
  extensions: ['pts'],
  doc: 'A number of points, then one point a line: x y z, intensity, red green blue; any number of scans. Without that number it is read as a text table.',
  detect: (head) => isText(head) && layOutPts(head) !== null,
  open: async (source) => (await import('./open-pts.ts')).openPts(source),
};
