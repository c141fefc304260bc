import { FloorPlanError } from '../core/errors.ts';
import { nameOf } from '../read/bytes/url-source.ts';
import type { ScanFile } from '../worker/protocol.ts';

/** A File, a Blob, or an address, absolute or relative to the page. */
export type ScanSource = Blob | URL | string;

/** @throws input/unreadable for what is no address */
export function fileOf(source: ScanSource): ScanFile {
  if (source instanceof File) return { data: source, name: source.name };
  if (source instanceof Blob) return { data: source, name: 'scan' };
  if (URL.canParse(source, document.baseURI)) {
    const { href } = new URL(source, document.baseURI);
    return { data: href, name: nameOf(href) };
  }
  throw new FloorPlanError('input/unreadable', `expected the address of a scan, found "${source}"`, {
    hint: 'Give a URL, absolute or relative to the page.',
  });
}

/** Tells a scan from others: the same files at the same places, or of the same names and sizes. */
export function scanKey(files: readonly ScanFile[]): string {
  return files.map(({ data, name }) => (typeof data === 'string' ? data : `${name} ${data.size}`)).join('\n');
}
