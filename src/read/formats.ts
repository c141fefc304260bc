import { FloorPlanError } from '../core/errors.ts';
import type { ReadFormat } from './cloud-reader.ts';
import { E57_FORMAT } from './e57/e57.ts';
import { COPC_FORMAT, LAS_FORMAT, LAZ_FORMAT } from './las/las.ts';
import { GLTF_FORMAT } from './mesh/gltf.ts';
import { OBJ_FORMAT } from './mesh/obj.ts';
import { PCD_FORMAT } from './pcd/pcd.ts';
import { PLY_FORMAT } from './ply/ply.ts';
import { PTS_FORMAT } from './pts/pts.ts';
import { PTX_FORMAT } from './ptx/ptx.ts';
import { extensionOf, type Foreign, foreignByName, isText, recogniseForeign } from './signatures.ts';
import { CSV_FORMAT } from './text/csv.ts';

/**
 * What can be read: drives detection, file picker, command line and README. In order of detection: formats with a
 * mark of their own first.
 */
export const READ_FORMATS = {
  ply: PLY_FORMAT,
  las: LAS_FORMAT,
  copc: COPC_FORMAT,
  laz: LAZ_FORMAT,
  e57: E57_FORMAT,
  ptx: PTX_FORMAT,
  pts: PTS_FORMAT,
  pcd: PCD_FORMAT,
  glb: GLTF_FORMAT,
  obj: OBJ_FORMAT,
  csv: CSV_FORMAT,
} as const satisfies Record<string, ReadFormat>;

/** What may be around them. */
export const ARCHIVES = {
  gzip: { label: 'gzip', extensions: ['gz'], doc: 'Any of these, packed.' },
  zip: {
    label: 'ZIP',
    extensions: ['zip'],
    doc: 'Any of these, packed or stored; several clouds in it are parts of one scan.',
  },
} as const satisfies Record<string, Pick<ReadFormat, 'label' | 'extensions' | 'doc'>>;

export type ReadFormatName = keyof typeof READ_FORMATS;

const TEXT_FORMATS = ['ptx', 'pts', 'csv', 'obj'] as const satisfies readonly ReadFormatName[];

export const READ_FORMAT_NAMES = Object.keys(READ_FORMATS) as readonly ReadFormatName[];

/**
 * The format of a source, by content first and by extension second.
 *
 * @param head the first bytes, up to 64 KiB
 * @throws input/unknown-format
 */
export function detectFormat(head: Uint8Array, name: string): ReadFormatName {
  const byContent = READ_FORMAT_NAMES.find((format) => READ_FORMATS[format].detect(head));
  // Any rows of numbers are a table: a damaged PTX too, headers and all.
  const isPlain = byContent === 'csv' || byContent === 'pts';
  if (isPlain && isNamedAs('ptx', name)) return 'ptx';
  if (byContent) return byContent;
  const foreign = recogniseForeign(head);
  // A text that is no sure table: its reader can say where it goes wrong.
  const text = TEXT_FORMATS.find((format) => isNamedAs(format, name));
  if (text && !foreign && isText(head)) return text;
  throw unknownFormat(name, foreign?.hint ? foreign : (foreignByName(name) ?? foreign), isText(head));
}

function unknownFormat(name: string, foreign: Foreign | null, isPlainText: boolean): FloorPlanError {
  const named = READ_FORMAT_NAMES.find((format) => isNamedAs(format, name));
  const expected = named ? `the content of a ${READ_FORMATS[named].label} file` : 'a point cloud';
  const found = foreign?.what ?? (isPlainText ? 'text that is no table of points' : 'bytes of no known kind');
  const labels = READ_FORMAT_NAMES.map((format) => READ_FORMATS[format].label);
  return new FloorPlanError(
    'input/unknown-format',
    `${name}: expected ${expected}, found what looks like ${found}`,
    {
      hint: foreign?.hint ?? `Read are ${labels.slice(0, -1).join(', ')} and ${labels.at(-1)}.`,
      detail: { found },
    },
  );
}

function isNamedAs(format: ReadFormatName, name: string): boolean {
  const extensions: readonly string[] = READ_FORMATS[format].extensions;
  return extensions.includes(extensionOf(name));
}
