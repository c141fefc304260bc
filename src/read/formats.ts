import { FloorPlanError } from '../core/errors.ts';
import type { ByteSource } from './bytes/source.ts';
import type { OpenCloud, ReadFormat } from './cloud-reader.ts';
import { GLTF_FORMAT } from './mesh/gltf.ts';
import { OBJ_FORMAT } from './mesh/obj.ts';
import { PCD_FORMAT } from './pcd/pcd.ts';
import { PLY_FORMAT } from './ply/ply.ts';
import { HEAD_BYTES, isText, recogniseForeign } from './signatures.ts';
import { CSV_FORMAT } from './text/csv.ts';

/**
 * What can be read: drives detection, file picker, command line and README. In order of detection: formats with a
 * mark of their own first.
 */
export const READ_FORMATS = {
  ply: PLY_FORMAT,
  pcd: PCD_FORMAT,
  glb: GLTF_FORMAT,
  obj: OBJ_FORMAT,
  csv: CSV_FORMAT,
} as const satisfies Record<string, ReadFormat>;

export type ReadFormatName = keyof typeof READ_FORMATS;

export const READ_FORMAT_NAMES = Object.keys(READ_FORMATS) as readonly ReadFormatName[];

export interface DetectedCloud {
  readonly format: ReadFormatName;
  readonly cloud: OpenCloud;
}

/**
 * Finds the format of a source, by content first and by extension second, and reads its header.
 *
 * @throws input/empty, input/unknown-format, and what the reader throws
 */
export async function openCloud(source: ByteSource): Promise<DetectedCloud> {
  const head = await source.slice(0, HEAD_BYTES);
  if (head.length === 0) {
    throw new FloorPlanError('input/empty', `${source.name}: expected a point cloud, found an empty file`, {
      hint: 'Export or copy the cloud again.',
    });
  }
  const format = detectFormat(head, source.name);
  return { format, cloud: await READ_FORMATS[format].open(source) };
}

/** @param head the first bytes, up to 64 KiB @throws input/unknown-format */
export function detectFormat(head: Uint8Array, name: string): ReadFormatName {
  const byContent = READ_FORMAT_NAMES.find((format) => READ_FORMATS[format].detect(head));
  if (byContent) return byContent;
  const foreign = recogniseForeign(head);
  // A text that is no sure table: its reader can say where it goes wrong.
  if (!foreign && isText(head)) {
    const text = (['csv', 'obj'] as const).find((format) => isNamedAs(format, name));
    if (text) return text;
  }
  const named = READ_FORMAT_NAMES.find((format) => isNamedAs(format, name));
  const expected = named ? `a ${READ_FORMATS[named].label} file` : labels();
  const found = foreign ?? (isText(head) ? 'text that is no table of points' : 'bytes of no known kind');
  throw new FloorPlanError(
    'input/unknown-format',
    `${name}: expected ${expected}, found what looks like ${found}`,
    {
      hint: `Save the cloud as ${labels()}.`,
      detail: { found },
    },
  );
}

function isNamedAs(format: ReadFormatName, name: string): boolean {
  const extensions: readonly string[] = READ_FORMATS[format].extensions;
  return extensions.includes(name.slice(name.lastIndexOf('.') + 1).toLowerCase());
}

function labels(): string {
  return READ_FORMAT_NAMES.map((name) => READ_FORMATS[name].label).join(' or ');
}
