import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** Where the page lies; part of the site. */
export const pageFolder = fileURLToPath(new URL('../../public/reproduction', import.meta.url));

/** The colours of the app, which the page has beside it: it is read without a build, too. */
export function appPalette(): string {
  return readFileSync(new URL('../../src/element/palette.css', import.meta.url), 'utf8');
}

export function readText(name: string): string {
  return readFileSync(join(pageFolder, name), 'utf8');
}

export function write(name: string, content: string | Uint8Array): void {
  mkdirSync(pageFolder, { recursive: true });
  writeFileSync(join(pageFolder, name), content);
}

/** Pictures that no figure shows any more go. */
export function removeOthers(files: ReadonlySet<string>): void {
  for (const name of readdirSync(pageFolder)) {
    if (/\.(svg|png)$/.test(name) && !files.has(name)) rmSync(join(pageFolder, name));
  }
}
