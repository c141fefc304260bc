import type { FuzzFormat } from './seeds.ts';

/** Bounds of a case. */
export const MOST_MS = 5_000;
export const MOST_BYTES = 512 * 2 ** 20;
/** Share of the cases of a format that have to get past the header, and of the readers' lines that have to be run. */
const LEAST_PAST_HEADER = 0.5;
const LEAST_COVERAGE = 0.9;

/** What came of one format. */
export interface FormatReport {
  readonly format: FuzzFormat;
  readonly seed: number;
  readonly cases: number;
  readonly pastHeader: number;
  /** How often each outcome came: `scan`, or an error's code. */
  readonly outcomes: Readonly<Record<string, number>>;
  readonly slowest: { readonly number: number; readonly ms: number };
  readonly largest: { readonly number: number; readonly bytes: number };
  readonly failures: readonly { readonly number: number; readonly message: string }[];
}

/** Lines there are and lines run, by file. */
export type Coverage = Readonly<Record<string, { readonly total: number; readonly covered: number }>>;

const MEGABYTE = 2 ** 20;

export function formatReports(reports: readonly FormatReport[]): string {
  const rows = reports.map(({ format, cases, pastHeader, outcomes, slowest, largest }) => [
    format,
    `${cases}`,
    percent(pastHeader, cases),
    `${outcomes.scan ?? 0}`,
    `${slowest.ms.toFixed(0)} (${slowest.number})`,
    `${(largest.bytes / MEGABYTE).toFixed(0)} (${largest.number})`,
    Object.entries(outcomes)
      .filter(([code]) => code !== 'scan')
      .sort(([, a], [, b]) => b - a)
      .map(([code, count]) => `${code.replace('input/', '')} ${count}`)
      .join(', '),
  ]);
  const head = [
    'format',
    'cases',
    'past the header',
    'scans',
    'slowest ms (case)',
    'peak MB (case)',
    'errors',
  ];
  return table([head, ...rows]);
}

export function formatCoverage(coverage: Coverage): string {
  const rows = Object.entries(coverage).map(([file, { total, covered }]) => [
    file,
    `${covered}/${total}`,
    percent(covered, total),
  ]);
  return table([['file', 'lines run', ''], ...rows]);
}

/** What went wrong, a line each, with the command that repeats it. */
export function problemsOf(reports: readonly FormatReport[], coverage: Coverage | null): string[] {
  const problems = reports.flatMap(({ format, seed, cases, pastHeader, failures }) => [
    ...failures.map(({ number, message }) => `${repeatCommand(format, seed, number)}: ${message}`),
    ...(pastHeader < LEAST_PAST_HEADER * cases && cases > 1
      ? [`${format}: only ${percent(pastHeader, cases)} of the cases got past the header`]
      : []),
  ]);
  const { total, covered } = coverage?.total ?? { total: 0, covered: 0 };
  if (covered < LEAST_COVERAGE * total)
    problems.push(`only ${percent(covered, total)} of the readers' lines were run`);
  return problems;
}

export function repeatCommand(format: FuzzFormat, seed: number, number: number): string {
  return `npm run fuzz -- --format ${format} --seed ${seed} --case ${number}`;
}

function percent(part: number, whole: number): string {
  return whole === 0 ? '–' : `${((100 * part) / whole).toFixed(1)} %`;
}

function table(rows: readonly (readonly string[])[]): string {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  return rows
    .map((row) =>
      row
        .map((cell, column) =>
          column === 0 || column > 5 ? cell.padEnd(widths[column]) : cell.padStart(widths[column]),
        )
        .join('  ')
        .trimEnd(),
    )
    .join('\n');
}
