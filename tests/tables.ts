/** The README's tables, made from the source's: `npm run tables` writes them, a unit test compares. */
import { readFileSync, writeFileSync } from 'node:fs';
import { valueWords } from '../src/cli/help.ts';
import { kebabCase, PARAM_NAMES, PARAMS, type ParamRow } from '../src/core/params.ts';
import { STAGES } from '../src/core/stages.ts';
import { ARCHIVES, READ_FORMATS } from '../src/read/formats.ts';
import { WRITE_FORMATS } from '../src/write/formats.ts';

export const readmePath = new URL('../README.md', import.meta.url);

const tables: Record<string, () => string> = {
  'read formats': () =>
    table(
      ['format', 'extensions', 'what is read'],
      Object.values({ ...READ_FORMATS, ...ARCHIVES }).map(({ label, extensions, doc }) => [
        label,
        code(extensions),
        doc,
      ]),
    ),
  'write formats': () =>
    table(
      ['name', 'format', 'what it holds'],
      Object.entries(WRITE_FORMATS).map(([name, { label, doc }]) => [code([name]), label, doc]),
    ),
  parameters: () =>
    table(
      ['flag and attribute', 'values', 'default', 'stage', 'what it does', 'source'],
      PARAM_NAMES.map((name) => {
        const row: ParamRow = PARAMS[name];
        const start =
          row.paper === undefined ? String(row.default) : `${row.default} (paper: ${paperWords(row)})`;
        const values = valueWords(row).replaceAll('|', ' \\| ');
        return [code([kebabCase(name)]), values, start, STAGES[row.stage].label, row.doc, row.source];
      }),
    ),
};

/** The README with every `<!-- table: NAME -->` … `<!-- end -->` made afresh. */
export function withTables(readme: string): string {
  return readme.replace(/(<!-- table: ([a-z ]+) -->\n)[\s\S]*?(<!-- end -->)/g, (_, open, name, close) => {
    return `${open}${tables[name]()}${close}`;
  });
}

function paperWords({ paper }: ParamRow): string {
  if (typeof paper !== 'object' || !('px' in paper)) return String(paper);
  return `${paper.px} px${paper.power === 2 ? '²' : ''}`;
}

function table(head: string[], rows: string[][]): string {
  return [head, head.map(() => '---'), ...rows].map((cells) => `| ${cells.join(' | ')} |\n`).join('');
}

function code(words: readonly string[]): string {
  return words.map((word) => `\`${word}\``).join(' ');
}

if (process.argv.includes('--write')) {
  writeFileSync(readmePath, withTables(readFileSync(readmePath, 'utf8')));
}
