import { zipSync } from 'fflate';
import { FloorPlanError } from '../core/errors.ts';
import { oneLine } from './model/model-notes.ts';
import type { Product, WrittenFile } from './plan-writer.ts';

/** A fixed date, the earliest that ZIP knows: equal plans give equal bytes. */
const DATE = '1980-01-01T00:00:00';
/** Files that hold compressed data already are stored as they are. */
const PACKED = /\.(zip|xlsx|png|pdf)$/;
/** Of compression: half the time of the usual 6 for a hundredth more bytes. */
const LEVEL = 3;

/** A format of the table of write formats and its key there. */
export interface ZippedFormat {
  readonly name: string;
  readonly label: string;
  readonly doc: string;
}

/** What {@link writeZip} needs of the table. */
export interface ZipOrder {
  readonly formats: readonly ZippedFormat[];
  write(product: Product, format: string): Promise<readonly WrittenFile[]>;
}

type File = Pick<WrittenFile, 'name' | 'content'>;

/** Files as one ZIP ([APPNOTE]); the same files give the same bytes. */
export function zipFiles(files: readonly File[]): Uint8Array<ArrayBuffer> {
  const encoder = new TextEncoder();
  const entries = files.map(({ name, content }) => {
    const bytes = typeof content === 'string' ? encoder.encode(content) : content;
    return [name, [bytes, { level: PACKED.test(name) ? 0 : LEVEL }]] as const;
  });
  return zipSync(Object.fromEntries(entries) as Parameters<typeof zipSync>[0], {
    mtime: DATE,
  }) as Uint8Array<ArrayBuffer>;
}

/**
 * Writes a plan in several formats as one ZIP, with a README.txt that tells what each file is. A format that this plan
 * cannot be written in is left out and README.txt says why. While a picture is packed outside this thread, the next
 * formats are written.
 *
 * @throws the error of the first format where none could be written
 */
export async function writeZip(
  product: Product,
  { formats, write }: ZipOrder,
): Promise<Uint8Array<ArrayBuffer>> {
  const parts = await Promise.all(formats.map((format) => packFormat(format, write(product, format.name))));
  const files = parts.flatMap((part) => part.files);
  const failure = parts.find((part) => part.failure)?.failure;
  if (files.length === 0 && failure !== undefined) throw failure;
  const title = `Floor plan of ${oneLine(product.name)}, made by Grundriss.`;
  const readme = `${[title, ...parts.map((part) => part.told)].join('\n\n')}\n`;
  return zipFiles([...files, { name: 'README.txt', content: readme }]);
}

interface ZipPart {
  readonly files: readonly WrittenFile[];
  readonly told: string;
  readonly failure?: FloorPlanError;
}

async function packFormat(
  { label, doc }: ZippedFormat,
  writing: Promise<readonly WrittenFile[]>,
): Promise<ZipPart> {
  try {
    const files = await writing;
    const told = `${files.map(({ name }) => name).join(', ')}\n  ${label}: ${doc}`;
    return { files, told };
  } catch (error) {
    if (!(error instanceof FloorPlanError)) throw error;
    const told = `No ${label}\n  ${oneLine(error.message)} ${oneLine(error.hint ?? '')}`.trimEnd();
    return { files: [], told, failure: error };
  }
}
