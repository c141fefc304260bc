import { performance } from 'node:perf_hooks';
import { makeNodeCanvas } from '../../src/cli/node-canvas.ts';
import { makeSolid } from '../../src/solid/make-solid.ts';
import { WRITE_FORMAT_NAMES, writeFiles } from '../../src/write/formats.ts';
import type { Product, WrittenFile } from '../../src/write/plan-writer.ts';
import { drawSheets } from '../../src/write/sheet/draw-sheet.ts';
import { largePlan, sliceOf } from './large-plan.ts';
import type { Figure } from './table.ts';

/** Of the slice's points, m. */
const SPACING = 0.05;
const TIMES = 3;
/** What an export of a large plan may take at most. */
const MOST_MS = 2000;
const MOST_MB: Readonly<Record<string, number>> = { svg: 3, glb: 5 };
/** As large as the scan, of which there is none here. */
const OF_SCANS: readonly string[] = ['glb-points'];
const UNIT = '500 rooms, 5,000 walls';

/** Every format of the table written from a plan of 500 rooms and 5,000 walls: time and size, beside what they may be. */
export async function benchExports(): Promise<readonly Figure[]> {
  const plan = largePlan();
  const slice = { xy: sliceOf(plan, SPACING), band: [1, 2], spacing: SPACING } as const;
  const drawn = { name: 'large', plan, slice, options: plan.options };
  // What is worked out once a plan is worked out anew.
  const solid = await timed(() => makeSolid(largePlan(), plan.options));
  const sheet = await timed(() => drawSheets({ ...drawn, plan: largePlan() }));
  const product: Product = { ...drawn, solid: solid.made, sheet: sheet.made };
  const figures: Figure[] = [
    timeFigure('the solid all models are made of', solid.ms),
    timeFigure('the sheet all drawings are made of', sheet.ms),
  ];
  for (const format of WRITE_FORMAT_NAMES.filter((name) => !OF_SCANS.includes(name))) {
    const { made, ms } = await timed(() => writeFiles(product, format, { makeCanvas: makeNodeCanvas }));
    const megabytes = sizeOf(made) / 1e6;
    const most = MOST_MB[format];
    const isOver = most !== undefined && megabytes > most;
    figures.push(timeFigure(format, ms));
    figures.push({
      ...{ name: format, of: 'MB', value: megabytes, unit: UNIT },
      ...(isOver && { note: `over ${most} MB` }),
    });
  }
  return figures;
}

const timeFigure = (name: string, ms: number): Figure => ({
  ...{ name, of: 'ms', value: ms, unit: UNIT },
  ...(ms > MOST_MS && { note: `over ${MOST_MS} ms` }),
});

/** The middle one of a few times. */
async function timed<T>(make: () => T | Promise<T>): Promise<{ made: T; ms: number }> {
  const runs: { made: T; ms: number }[] = [];
  for (let i = 0; i < TIMES; i++) {
    const start = performance.now();
    const made = await make();
    runs.push({ made, ms: performance.now() - start });
  }
  return runs.sort((a, b) => a.ms - b.ms)[Math.floor(TIMES / 2)];
}

function sizeOf(files: readonly WrittenFile[]): number {
  return files.reduce((sum, { content }) => {
    const bytes = typeof content === 'string' ? Buffer.byteLength(content) : content.length;
    return sum + bytes;
  }, 0);
}
