import type { ReadFormat } from '../cloud-reader.ts';
import { latin1 } from '../signatures.ts';

const POINT_FORMAT = 104;
/** LASzip sets the highest bit of the point format. */
const COMPRESSED = 0x80;
/** A COPC file begins with its own record, at a fixed place. */
const COPC_USER = 377;

export const LAS_FORMAT: ReadFormat = {
  label: 'LAS',
  extensions: ['las'],
  doc: 'ASPRS LAS 1.0 to 1.4, all point formats, with colour, intensity, class, unit and CRS; points marked as withheld are left out.',
  detect: (head) => isLas(head) && !isCompressed(head),
  open: async (source) => (await import('./open-las.ts')).openLas(source),
};

export const LAZ_FORMAT: ReadFormat = {
  label: 'LAZ',
  extensions: ['laz'],
  doc: 'LAS compressed by LASzip: point formats 0 to 3 and 6 to 10.',
  detect: (head) => isLas(head) && isCompressed(head),
  open: async (source) => (await import('./open-laz.ts')).openLaz(source),
};

export const COPC_FORMAT: ReadFormat = {
  label: 'COPC',
  extensions: ['copc.laz'],
  doc: 'Cloud-optimised LAZ 1.0: of a file or URL only the octree nodes are fetched that the working resolution asks for.',
  detect: (head) => LAZ_FORMAT.detect(head) && latin1(head.subarray(COPC_USER, COPC_USER + 5)) === 'copc\0',
  open: async (source) => (await import('./open-copc.ts')).openCopc(source),
};

function isLas(head: Uint8Array): boolean {
  return latin1(head.subarray(0, 4)) === 'LASF';
}

function isCompressed(head: Uint8Array): boolean {
  return (head[POINT_FORMAT] & COMPRESSED) !== 0;
}
