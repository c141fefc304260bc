import { FloorPlanError } from '../../core/errors.ts';
import { type ByteSource, inPieces } from '../bytes/source.ts';
import { latin1 } from '../signatures.ts';
import { inflate } from './inflate.ts';
import { type UnpackedSource, unpackedSource } from './unpacked-source.ts';
import { entryBegin, readZipDirectory, type ZipEntry } from './zip.ts';

const STORED = 0;
const DEFLATED = 8;
/** More files than that are no scan's tiles. */
const MOST_ENTRIES = 4096;

/** What packers and file systems add. */
const LITTER = /(^|\/)(__MACOSX\/|\.|Thumbs\.db$|desktop\.ini$)/i;

const GZIP = '\x1f\x8b\x08';
/** With files, and without. */
const ZIP = ['PK\x03\x04', 'PK\x05\x06'];

/** Whether the first bytes are an archive's. */
export function isArchive(head: Uint8Array): boolean {
  const magic = latin1(head.subarray(0, 4));
  return magic.startsWith(GZIP) || ZIP.includes(magic);
}

/** The files in an archive. @param head its first bytes @throws input/… */
export async function openArchive(source: ByteSource, head: Uint8Array): Promise<UnpackedSource[]> {
  if (latin1(head.subarray(0, 3)) === GZIP) return [gunzipped(source)];
  const entries = (await readZipDirectory(source)).filter(({ name }) => !LITTER.test(name));
  if (entries.length === 0) throw noFiles(source);
  if (entries.length > MOST_ENTRIES) throw tooMany(source, entries.length);
  return Promise.all(entries.map((entry) => unzipped(source, entry, entries.length)));
}

/** `scan.ply.gz` holds `scan.ply`. */
function gunzipped(source: ByteSource): UnpackedSource {
  return unpackedSource({
    name: source.name.replace(/\.gz$/i, ''),
    // The size a gzip file tells at its end is modulo 4 GB and of its last part only.
    size: undefined,
    files: 1,
    unpack: (onTaken) =>
      inflate({ name: source.name, stream: () => source.stream(), method: 'gzip', onTaken }),
  });
}

async function unzipped(source: ByteSource, entry: ZipEntry, files: number): Promise<UnpackedSource> {
  const name = `${source.name} › ${entry.name}`;
  assertReadable(name, entry);
  const begin = await entryBegin(source, entry);
  const { packedBytes, bytes } = entry;
  const packed = part(source, begin, packedBytes);
  if (entry.method === STORED) return storedSource(name, packed, bytes);
  return unpackedSource({
    name,
    size: bytes,
    files,
    unpack: (onTaken) =>
      inflate({ name, unpackedSize: bytes, stream: packed.stream, method: 'deflate-raw', onTaken }),
  });
}

interface Part {
  readonly size: number;
  stream(): AsyncIterable<Uint8Array>;
  slice(begin: number, end: number): Promise<Uint8Array>;
}

/** Some bytes of a source. */
function part(source: ByteSource, offset: number, size: number): Part {
  const slice = (begin: number, end: number) =>
    source.slice(offset + Math.min(begin, size), offset + Math.min(end, size));
  return { size, slice, stream: () => inPieces(slice, size) };
}

/** Read in any order, as it lies. */
function storedSource(name: string, packed: Part, size: number): UnpackedSource {
  let packedBytesRead = 0;
  return {
    name,
    size,
    get packedBytesRead() {
      return packedBytesRead;
    },
    slice: packed.slice,
    async *stream() {
      packedBytesRead = 0;
      for await (const piece of packed.stream()) {
        packedBytesRead += piece.length;
        yield piece;
      }
    },
  };
}

function assertReadable(name: string, { method, isEncrypted }: ZipEntry): void {
  if (!isEncrypted && (method === STORED || method === DEFLATED)) return;
  const found = isEncrypted ? 'an encrypted file' : `a file packed by method ${method}`;
  throw new FloorPlanError('input/malformed', `${name}: expected a stored or deflated file, found ${found}`, {
    hint: 'Unpack the archive and load the files in it.',
  });
}

function noFiles({ name }: ByteSource): FloorPlanError {
  return new FloorPlanError('input/empty', `${name}: expected files in the archive, found none`, {
    hint: 'Pack the scan again.',
  });
}

function tooMany({ name }: ByteSource, found: number): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected at most ${MOST_ENTRIES} files in the archive, found ${found}`,
    { hint: 'Unpack the archive and load the scan in it.' },
  );
}
