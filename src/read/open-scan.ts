import { FloorPlanError } from '../core/errors.ts';
import type { Warning } from '../core/types.ts';
import { isArchive, openArchive } from './archive/open-archive.ts';
import type { UnpackedSource } from './archive/unpacked-source.ts';
import type { ByteSource } from './bytes/source.ts';
import type { OpenCloud } from './cloud-reader.ts';
import { detectFormat, READ_FORMAT_NAMES, READ_FORMATS, type ReadFormatName } from './formats.ts';
import { type CloudPart, mergeClouds } from './merged-cloud.ts';
import { HEAD_BYTES } from './signatures.ts';

/** A ZIP of gzipped tiles is met; archives deeper than that are made to annoy. */
const MOST_DEPTH = 3;

/** What one or several sources hold together. */
export interface OpenScan {
  /** Of the parts, each once, e.g. `ply` or `las+ply`. */
  readonly format: string;
  readonly cloud: OpenCloud;
}

interface OpenPart extends CloudPart {
  readonly format: ReadFormatName;
}

/**
 * Opens sources, and the files of those that are archives, as one cloud: formats are told by content first and by
 * extension second. Of several files, those that are no clouds are passed over with a warning.
 *
 * @param sources at least one
 * @throws input/empty, input/unknown-format, and what readers and archives throw
 */
export async function openScan(sources: readonly ByteSource[]): Promise<OpenScan> {
  const clouds = sources.length === 1 ? sources : await cloudsAmong(sources);
  const parts: OpenPart[] = [];
  // Where none is a cloud, the first tells what it is instead.
  for (const source of clouds.length > 0 ? clouds : sources.slice(0, 1))
    parts.push(...(await openParts(source, 0)));
  const formats = [...new Set(parts.map(({ format }) => format))];
  return { format: formats.sort().join('+'), cloud: mergeClouds(parts, passedOver(sources, clouds)) };
}

async function openParts(source: ByteSource, depth: number): Promise<OpenPart[]> {
  const head = await source.slice(0, HEAD_BYTES);
  if (head.length === 0) {
    throw new FloorPlanError('input/empty', `${source.name}: expected a point cloud, found an empty file`, {
      hint: 'Export or copy the cloud again.',
    });
  }
  if (isArchive(head)) return openPacked(source, await openArchive(source, head), depth + 1);
  const format = detectFormat(head, source.name);
  return [{ format, name: source.name, size: source.size, cloud: await READ_FORMATS[format].open(source) }];
}

async function openPacked(
  archive: ByteSource,
  files: readonly UnpackedSource[],
  depth: number,
): Promise<OpenPart[]> {
  if (depth > MOST_DEPTH) {
    throw new FloorPlanError(
      'input/malformed',
      `${archive.name}: expected a scan, found archives in archives`,
      {
        hint: 'Unpack them and load the scan.',
      },
    );
  }
  const clouds = files.length === 1 ? files : await cloudsAmong(files);
  const parts: OpenPart[] = [];
  // Where none is a cloud, the first tells what it is instead.
  for (const file of clouds.length > 0 ? clouds : files.slice(0, 1)) {
    const opened = await openParts(file, depth);
    parts.push(...opened.map((part) => ({ ...part, cloud: withPackedProgress(part.cloud, file) })));
  }
  parts[0].cloud.warnings.push(...passedOver(files, clouds));
  // The archive's size is what there is to read.
  return parts.map((part) => ({ ...part, size: files.length === 1 ? archive.size : undefined }));
}

/** Those whose content tells that they are clouds, or archives: a picture or a note beside the tiles is none. */
async function cloudsAmong<T extends ByteSource>(files: readonly T[]): Promise<T[]> {
  const clouds: T[] = [];
  for (const file of files) {
    const head = await file.slice(0, HEAD_BYTES);
    if (isArchive(head) || READ_FORMAT_NAMES.some((format) => READ_FORMATS[format].detect(head)))
      clouds.push(file);
  }
  return clouds;
}

/** Progress is told in bytes of the archive. */
function withPackedProgress(cloud: OpenCloud, file: UnpackedSource): OpenCloud {
  return {
    ...cloud,
    chunks: (progress, ...rest) => cloud.chunks(() => progress(file.packedBytesRead), ...rest),
  };
}

/** A warning that names the files which are no clouds, where there are any. */
function passedOver(files: readonly ByteSource[], clouds: readonly ByteSource[]): readonly Warning[] {
  const names = files.filter((file) => !clouds.includes(file)).map(({ name }) => name);
  if (names.length === 0) return [];
  const isOne = names.length === 1;
  const found = isOne
    ? `${names[0]} is no point cloud and was`
    : `${names.length} files, ${names[0]} among them, are no point clouds and were`;
  return [
    {
      code: 'read/files-passed-over',
      message: `${found} passed over.`,
      hint: 'If the scan is not whole, load the files that are missing by themselves: then they tell what is wrong with them.',
    },
  ];
}
