/** The README's tables, made from the source's: `npm run tables` writes them, a unit test compares. */
import { readFileSync, writeFileSync } from 'node:fs';
import { valueWords } from '../src/cli/help.ts';
import type { ParamRow } from '../src/core/param-rows.ts';
import { kebabCase, PARAM_NAMES, PARAMS } from '../src/core/params.ts';
import { STAGES } from '../src/core/stages.ts';
import { ARCHIVES, READ_FORMATS } from '../src/read/formats.ts';
import { writePlanSchema } from '../src/write/data/plan-schema.ts';
import { WRITE_FORMATS } from '../src/write/formats.ts';
import { readText } from './reproduction/folder.ts';
import { OUTLINE_METHODS } from './reproduction/outlines.ts';
import { PAPER_SETS } from './reproduction/paper-sets.ts';
import type { Results } from './reproduction/results.ts';

export const readmePath = new URL('../README.md', import.meta.url);
/** Of plan.json, from its shape and the parameters; goes with the package. */
export const schemaPath = new URL('../src/write/data/plan.schema.json', import.meta.url);

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
  reproduction: () =>
    table(['on the rebuilt sets', "the paper's method", 'α-shape', 'ours'], reproductionRows()),
};

/** The README with every `<!-- table: NAME -->` … `<!-- end -->` made afresh. */
export function withTables(readme: string): string {
  return readme.replace(/(<!-- table: ([a-z ]+) -->\n)[\s\S]*?(<!-- end -->)/g, (_, open, name, close) => {
    return `${open}${tables[name]()}${close}`;
  });
}

/** The page's numbers in short, from what `npm run reproduce` measured. */
function reproductionRows(): string[][] {
  const { sets, structureCases, doorGaps }: Results = JSON.parse(readText('results.json'));
  const methods = ["gift opening and the paper's three passes", 'α-shape, α 150 px', 'ours: preset building'];
  const columns = methods.map((label) => OUTLINE_METHODS.findIndex((method) => method.label === label));
  const hallways = PAPER_SETS.filter(({ isRoom }) => !isRoom).map(({ name, label }) => [
    `outline of ${label}, IoU`,
    ...columns.map((column) => sets[name].outlines[column].iou.toFixed(3)),
  ]);
  const percent = (share: number, digits = 0) => `${(100 * share).toFixed(digits)} %`;
  const worst = (key: 'worst' | 'worstWithout') =>
    percent(Math.max(...doorGaps.byWidth.map((gap) => gap[key])), 1);
  const { cases, paper, robust } = structureCases.keptBack;
  return [
    ...hallways,
    [`structures found (IoU over 0.8) in ${cases} rooms kept back`, percent(paper), '–', percent(robust)],
    ['largest error of the area by a gap of 0.3 to 3 m', worst('worstWithout'), '–', worst('worst')],
  ];
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
  writeFileSync(schemaPath, writePlanSchema());
}
