import { zipSync } from 'fflate';
import { FloorPlanError } from '../core/errors.ts';
import { oneLine } from './model/model-notes.ts';
import type { Product, WrittenFile } from './plan-writer.ts';

/** A fixed date, the earliest that ZIP knows: equal plans give equal bytes. */
const DATE = '1980-01-01T00:00:00';
/** Files that hold compressed data already are stored as they are. */
const PACKED = /\.(zip|xlsx|png|pdf)$/;

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

/** Files as one ZIP ([APPNOTE]); the same files give the same bytes. */
export function zipFiles(files: readonly Pick<WrittenFile, 'name' | 'content'>[]): Uint8Array<ArrayBuffer> {
  const encoder = new TextEncoder();
  const entries = files.map(({ name, content }) => {
    const bytes = typeof content === 'string' ? encoder.encode(content) : content;
    return [name, [bytes, { level: PACKED.test(name) ? 0 : 6 }]] as const;
  });
  return zipSync(Object.fromEntries(entries) as Parameters<typeof zipSync>[0], {
    mtime: DATE,
  }) as Uint8Array<ArrayBuffer>;
}

/**
 * Writes a plan in several formats as one ZIP, with a README.txt that tells what each file is. A format that this plan
 * cannot be written in is left out and README.txt says why.
 *
 * @throws the error of the first format where none could be written
 */
export async function writeZip(
  product: Product,
  { formats, write }: ZipOrder,
): Promise<Uint8Array<ArrayBuffer>> {
  const files: WrittenFile[] = [];
  const told: string[] = [];
  const failures: FloorPlanError[] = [];
  for (const { name, label, doc } of formats) {
    try {
      const written = await write(product, name);
      files.push(...written);
      told.push(`${written.map((file) => file.name).join(', ')}\n  ${label}: ${doc}`);
    } catch (error) {
      if (!(error instanceof FloorPlanError)) throw error;
      failures.push(error);
      told.push(`No ${label}\n  ${oneLine(error.message)} ${oneLine(error.hint ?? '')}`.trimEnd());
    }
  }
  if (files.length === 0 && failures.length > 0) throw failures[0];
  const readme = [`Floor plan of ${oneLine(product.name)}, made by Grundriss.`, ...told].join('\n\n');
  return zipFiles([...files, { name: 'README.txt', content: `${readme}\n` }]);
}
