/**
 * `npm run fuzz [-- --format e57 --seed 7 --cases 500 --case 31]`: spoilt files of every format, read in every way.
 *
 * Each must end in a scan or in a FloorPlanError of the input, within bounds of time and memory. Files are made from
 * valid ones (seeds.ts) by structure-aware edits (mutate.ts), a case from seed, format and number alone, so that it can
 * be repeated. Says how many got past the header and how many of the readers' lines were run, and exits with 1 where a
 * bound fails. Coverage does not guide it: Jazzer.js, the one such fuzzer for Node, instruments CommonJS modules only.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { type Coverage, type FormatReport, formatCoverage, formatReports, problemsOf } from './report.ts';
import { FUZZ_FORMATS, type FuzzFormat } from './seeds.ts';
import type { FuzzTask } from './task.ts';

const root = fileURLToPath(new URL('../..', import.meta.url));
const folder = join(root, '.cache/fuzz');
/** Of each format: 100,100 in all. */
const CASES = 7_700;

const { values } = parseArgs({
  options: {
    format: { type: 'string', multiple: true },
    seed: { type: 'string', default: '1' },
    cases: { type: 'string', default: `${CASES}` },
    case: { type: 'string' },
  },
});
const unknown = values.format?.find((format) => !FUZZ_FORMATS.includes(format as FuzzFormat));
if (unknown) throw new Error(`No format "${unknown}"; there are ${FUZZ_FORMATS.join(', ')}.`);

const isOne = values.case !== undefined;
const formats = (values.format ?? FUZZ_FORMATS) as readonly FuzzFormat[];
const tasks = formats.map(
  (format): FuzzTask => ({
    format,
    seed: Number(values.seed),
    first: Number(values.case ?? 0),
    cases: isOne ? 1 : Number(values.cases),
    folder,
  }),
);

rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const isWhole = values.format === undefined && !isOne;
const vitest = join(root, 'node_modules/vitest/vitest.mjs');
const { status } = spawnSync(
  process.execPath,
  [vitest, 'run', '-c', 'tests/fuzz/vitest.config.ts', '--root', root, ...(isWhole ? ['--coverage'] : [])],
  {
    cwd: root,
    stdio: ['ignore', 'inherit', 'inherit'],
    env: { ...process.env, FUZZ_TASKS: JSON.stringify(tasks) },
  },
);

const reports = tasks.map(({ format }) => join(folder, `${format}.json`)).filter((file) => existsSync(file));
const read = reports.map((file): FormatReport => JSON.parse(readFileSync(file, 'utf8')));
const coverage = isWhole ? readCoverage() : null;
console.log(`\nseed ${values.seed}, ${read.reduce((sum, { cases }) => sum + cases, 0)} cases\n`);
console.log(formatReports(read));
if (coverage) console.log(`\n${formatCoverage(coverage)}`);
const problems = problemsOf(read, coverage);
for (const { format } of tasks)
  if (!read.some((report) => report.format === format))
    problems.push(`${format}: ended before its time, see above`);
if (status !== 0 && problems.length === 0) problems.push('Vitest tells of an error, see above');
for (const problem of problems) console.log(`\n✗ ${problem}`);
if (problems.length > 0) process.exitCode = 1;

function readCoverage(): Coverage | null {
  const file = join(folder, 'coverage/coverage-summary.json');
  if (!existsSync(file)) return null;
  const summary: Record<string, { lines: { total: number; covered: number } }> = JSON.parse(
    readFileSync(file, 'utf8'),
  );
  return Object.fromEntries(
    Object.entries(summary).map(([path, { lines }]) => [
      path === 'total' ? path : relative(root, path),
      lines,
    ]),
  );
}
