import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, inject, it } from 'vitest';
import { seededRandom } from '../../fixtures/simulator/random.ts';
import { type FormatReport, MOST_BYTES, MOST_MS, repeatCommand } from './report.ts';
import { type FuzzCase, makeCase, runCase } from './run-case.ts';
import { SEEDS } from './seeds.ts';
import type { FuzzTask } from './task.ts';
import { startWatchdog } from './watchdog.ts';

/** A reader that fails in more ways than this is to be mended first. */
const MOST_FAILURES = 20;

const task = inject('task');

it(`answers spoilt ${task.format} files with a scan or a FloorPlanError`, async () => {
  const report = await fuzz(task);
  writeFileSync(join(task.folder, `${task.format}.json`), JSON.stringify(report));
  expect(report.failures).toEqual([]);
});

async function fuzz({ format, seed, first, cases, folder }: FuzzTask): Promise<FormatReport> {
  const report = {
    format,
    seed,
    cases: 0,
    pastHeader: 0,
    outcomes: {} as Record<string, number>,
    slowest: { number: 0, ms: 0 },
    largest: { number: 0, bytes: 0 },
    failures: [] as { number: number; message: string }[],
  };
  const watchdog = startWatchdog(MOST_MS, repeatCommand(format, seed, 0).replace(/ --case 0$/, ''));
  for (let number = first; number < first + cases && report.failures.length < MOST_FAILURES; number++) {
    watchdog.begin(number);
    const fuzzCase = makeCase(SEEDS[format], seededRandom(seed, `${format} ${number}`));
    report.cases++;
    try {
      const { isPastHeader, outcome, ms, peakBytes } = await runCase(fuzzCase);
      if (isPastHeader) report.pastHeader++;
      report.outcomes[outcome] = (report.outcomes[outcome] ?? 0) + 1;
      if (ms > report.slowest.ms) report.slowest = { number, ms };
      if (peakBytes > report.largest.bytes) report.largest = { number, bytes: peakBytes };
      if (peakBytes > MOST_BYTES) throw new Error(`${peakBytes} bytes of memory`);
    } catch (error) {
      report.failures.push({ number, message: error instanceof Error ? `${error.stack}` : String(error) });
      keep(fuzzCase, join(folder, 'failures'), `${format}-${seed}-${number}`);
    }
  }
  await watchdog.stop();
  return report;
}

/** Writes the file down, to be looked at. */
function keep({ bytes, name }: FuzzCase, folder: string, number: string): void {
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, `${number}-${name}`), bytes);
}
