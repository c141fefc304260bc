import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, it } from 'vitest';

const root = resolve(import.meta.dirname, '../../..');
const FOLDERS = ['fixtures', 'public/samples'];

function dataFiles(): string[] {
  return FOLDERS.flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' })
      .map((file) => join(folder, file))
      .filter((path) => statSync(join(root, path)).isFile() && !/\.(ts|md|py)$/.test(path)),
  );
}

it('fixtures/README.md lists every file of data with its size', () => {
  const rows = readFileSync(join(root, 'fixtures/README.md'), 'utf8').matchAll(/^\| `(.+?)` \| (\d+) \|/gm);
  const listed = Object.fromEntries(Array.from(rows, ([, path, bytes]) => [path, Number(bytes)]));
  const found = Object.fromEntries(dataFiles().map((path) => [path, statSync(join(root, path)).size]));
  expect(listed).toEqual(found);
});
