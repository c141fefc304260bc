import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { describe, expect, it } from 'vitest';

const src = resolve(import.meta.dirname, '../../src');

/** Rows of the layer table in src/README.md: layer → what it may import. */
function readTable(): Map<string, { layers: Set<string>; packages: Set<string> }> {
  const text = readFileSync(join(src, 'README.md'), 'utf8');
  const section = text.slice(text.indexOf('## Who may import whom'));
  const rows = section.match(/^\| `[^|]+\|[^|]+\|[^|]+\|[^|]+\|$/gm) ?? [];
  return new Map(
    rows.map((row) => {
      const [layer, layers, packages] = row
        .split('|')
        .slice(1, 4)
        .map((cell) => [...cell.matchAll(/`([^`]+)`/g)].map((match) => match[1]));
      return [layer[0], { layers: new Set(layers), packages: new Set(packages) }];
    }),
  );
}

function layerOf(file: string): string {
  const path = relative(src, file);
  return path.includes('/') ? path.split('/')[0] : path.replace(/\.ts$/, '');
}

function importsOf(file: string): string[] {
  const text = readFileSync(file, 'utf8');
  return [...text.matchAll(/(?<=\s)(?:from|import)\s*\(?\s*'([^']+)'/g)].map((match) => match[1]);
}

const table = readTable();
const files = readdirSync(src, { recursive: true, encoding: 'utf8' })
  .filter((name) => name.endsWith('.ts'))
  .map((name) => join(src, name));

describe('layers', () => {
  it('has a row for every layer and no row without one', () => {
    expect([...table.keys()].sort()).toEqual([...new Set(files.map(layerOf))].sort());
  });

  it.each(files.map((file) => [relative(src, file), file]))(
    '%s imports only what its layer may',
    (_, file) => {
      const allowed = table.get(layerOf(file))!;
      for (const target of importsOf(file)) {
        if (target.startsWith('.')) {
          const layer = layerOf(resolve(dirname(file), target.replace(/\?.*$/, '')));
          if (layer !== layerOf(file))
            expect(allowed.layers, `${relative(src, file)} → ${target}`).toContain(layer);
        } else {
          const name = target.startsWith('node:')
            ? 'node'
            : target
                .split('/')
                .slice(0, target.startsWith('@') ? 2 : 1)
                .join('/');
          expect(allowed.packages, `${relative(src, file)} → ${target}`).toContain(name);
        }
      }
    },
  );
});
