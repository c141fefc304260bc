import type { ExportedFile } from '../worker/protocol.ts';

/** A download stays reachable this long after the click, ms: browsers read it late. */
const LIFETIME = 60_000;

/** One file as it is, several of one format as one ZIP. */
export async function bundleFiles(files: readonly ExportedFile[], format: string): Promise<ExportedFile> {
  if (files.length === 1) return files[0];
  const { zipFiles } = await import('../write/zip.ts');
  const contents = files.map(async ({ name, blob }) => ({
    name,
    content: new Uint8Array(await blob.arrayBuffer()),
  }));
  const bytes = zipFiles(await Promise.all(contents));
  return {
    name: `plan-${format}.zip`,
    blob: new Blob([bytes], { type: 'application/zip' }),
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
