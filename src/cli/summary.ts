import { kebabCase, renameParams } from '../core/params.ts';
import { sayScale } from '../core/source-coordinates.ts';
import type { Report } from '../session/report.ts';

/** What a person at a terminal wants to see of a run: what was kept, the unit, the axis, the area, the warnings. */
export function summaryText({ input, boundary, warnings }: Report): string {
  const { name, pointsKept, pointsRead, unit, metresPerUnit, up } = input;
  const count = (n: number) => n.toLocaleString('en-GB');
  const facts = [
    `kept ${count(pointsKept)} of ${count(pointsRead)} points`,
    sayScale(unit, metresPerUnit),
    `${up} up`,
    `${boundary.areaM2.toFixed(1)} m² inside`,
  ];
  const lines = warnings.map(({ message, hint }) => `  ! ${sayFlags(`${message} ${hint}`)}`);
  return `${[`${name}: ${facts.join(', ')}`, ...lines].join('\n')}\n`;
}

/** At the command parameters are flags. */
function sayFlags(text: string): string {
  return renameParams(text, (name) => `--${kebabCase(name)}`);
}
