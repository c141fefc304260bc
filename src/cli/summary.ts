import { kebabCase, PARAM_NAMES, type ParamName } from '../core/params.ts';
import { sayScale } from '../core/source-coordinates.ts';
import type { Report } from '../session/report.ts';

/** `bridgeGap` among words; names of a single word are plain English and stay. */
const CODE_NAME = /\b[a-z]+[A-Z][A-Za-z]*\b/g;

/** What a person at a terminal wants to see of a run: what was kept, the unit, the axis, the area, the warnings. */
export function summaryText({ input, boundary, warnings }: Report): string {
  const { name, pointsKept, pointsRead, unit, metresPerUnit, up } = input;
  const count = (n: number) => n.toLocaleString('en-GB');
  const facts = [
    `kept ${count(pointsKept)} of ${count(pointsRead)} points`,
    unit === 'custom' ? sayScale(unit, metresPerUnit) : `in ${unit}`,
    `${up} up`,
    `${boundary.areaM2.toFixed(1)} m² inside`,
  ];
  const lines = warnings.map(({ message, hint }) => `  ! ${sayFlags(`${message} ${hint}`)}`);
  return `${[`${name}: ${facts.join(', ')}`, ...lines].join('\n')}\n`;
}

/** Warnings name parameters as a script would; at the command they are flags. */
function sayFlags(text: string): string {
  return text.replace(CODE_NAME, (name) =>
    PARAM_NAMES.includes(name as ParamName) ? `--${kebabCase(name)}` : name,
  );
}
