import type { ExportedFile } from '../worker/protocol.ts';

/** A download stays reachable this long after the click, ms: browsers read it late. */
const LIFETIME = 60_000;

/** One file as it is, several of one format as one ZIP. */
export async function bundleFiles(files: readonly ExportedFile[], format: string): Promise<ExportedFile> {
  if (files.length === 1) return files[0];
  const { zipSync } = await import('fflate');
  const entries: Record<string, Uint8Array> = {};
  for (const { name, blob } of files) entries[name] = new Uint8Array(await blob.arrayBuffer());
  // A fixed date: equal plans give equal bytes.
  const bytes = zipSync(entries, { mtime: '1980-01-01T00:00:00' });
  return {
    name: `plan-${format}.zip`,
    blob: new Blob([bytes as Uint8Array<ArrayBuffer>], { type: 'application/zip' }),
  };
}

/** Hands a file to the person's downloads. */
export function saveFile({ name, blob }: ExportedFile): void {
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), LIFETIME);
}
