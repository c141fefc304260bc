import { execFileSync } from 'node:child_process';
import { resolve } from 'node:path';
import { expect, it } from 'vitest';

const root = resolve(import.meta.dirname, '../..');

/** What a door exports, seen by plain Node through the package's own name, without DOM or bundler. */
function exportsOf(door: string): string[] {
  const script = `console.log(JSON.stringify(Object.keys(await import('${door}'))))`;
  return JSON.parse(
    execFileSync(process.execPath, ['--input-type=module', '-e', script], { cwd: root, encoding: 'utf8' }),
  );
}

it.each([
  ['grundriss', ['FloorPlanError', 'PARAMS', 'Session', 'blobSource']],
  ['grundriss/element', ['FloorPlanElement']],
  ['grundriss/element/define', []],
])('the built door %s opens in plain Node', (door, names) => {
  expect(exportsOf(door)).toEqual(expect.arrayContaining(names));
});
