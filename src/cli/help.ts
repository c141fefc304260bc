import { CROP_FORM } from '../core/crop-box.ts';
import { type AutoNumberRow, defaultWords, type NumberRow, type ParamRow } from '../core/param-rows.ts';
import { kebabCase, PARAM_NAMES, PARAMS } from '../core/params.ts';
import { ROOM_NAME_WORDS } from '../core/room-names.ts';
import { STAGE_NAMES, STAGES } from '../core/stages.ts';
import { READ_FORMATS } from '../read/formats.ts';
import { WRITE_FORMATS } from '../write/formats.ts';
import type { WriteFormat } from '../write/plan-writer.ts';

/** The text of `grundriss --help`, made from the tables. */
export function helpText(): string {
  const reads = Object.values(READ_FORMATS).map((format) => format.label);
  const writes = Object.entries(WRITE_FORMATS).map(([name, row]) => formatLine(name, row));
  const params = STAGE_NAMES.flatMap((stage) => {
    const names = PARAM_NAMES.filter((name) => PARAMS[name].stage === stage);
    return names.length === 0 ? [] : [`\n  ${STAGES[stage].label}`, ...names.map(paramLine)];
  });
  return `grundriss INPUT… -o DIR [--merge] [--formats a,b,…] [--json] [--PARAMETER value]…

Turns indoor point clouds into floor plans. Reads ${reads.join(', ')}.
Each may be gzipped, or be in a ZIP. A plan.json written before is opened again: its model is made with
the parameters given, its files are written, but those that need the points. One input writes its files into DIR, several into DIR/<input name>/;
with --merge they are parts of one scan.
The last line of standard output is the report as JSON.

Formats (all but those on request, unless --formats names some; report.json always):
${writes.join('\n')}

Parameters (lengths and areas also with a unit: 24mm, 2.4px, 1ft, 5cm2):${params.join('\n')}

Exit codes: 0 done, 2 options, 3 input, 4 no plan, 5 environment, 70 a bug, 130 cancelled.
`;
}

/** The longest name of a format and a blank. */
const NAME_WIDTH = 1 + Math.max(...Object.keys(WRITE_FORMATS).map((name) => name.length));

function formatLine(name: string, { doc, isOnRequest }: WriteFormat): string {
  return `  ${name.padEnd(NAME_WIDTH)}${doc}${isOnRequest ? ' On request.' : ''}`;
}

function paramLine(name: (typeof PARAM_NAMES)[number]): string {
  const row: ParamRow = PARAMS[name];
  return `  --${kebabCase(name)} ${valueWords(row)}\n      ${row.doc} Default ${defaultWords(row)}.`;
}

/** What a value may be: `0 to 5 m`, `density|count`. */
export function valueWords(row: ParamRow): string {
  switch (row.kind) {
    case 'number':
      return rangeWords(row);
    case 'auto-number':
      return `auto|${rangeWords(row)}`;
    case 'flag':
      return 'true|false';
    case 'choice':
      return row.choices.join('|');
    case 'choice-list':
      return `${row.choices.join('|')},…`;
    case 'level':
      return 'auto|0|1|2|low:high';
    case 'doors':
      return 'none|gaps|x,y,width[,height];…';
    case 'classes':
      return 'all|CODE,CODE-CODE,…';
    case 'crop':
      return `none|${CROP_FORM}`;
    case 'room-names':
      return `none|${ROOM_NAME_WORDS};…`;
    case 'text':
      return 'TEXT';
  }
}

function rangeWords({ min, max, unit }: NumberRow | AutoNumberRow): string {
  return `${min} to ${max}${unit ? ` ${unit}` : ''}`;
}
