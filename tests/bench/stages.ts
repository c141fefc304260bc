import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import { nodeSource } from '../../src/cli/node-source.ts';
import { Session } from '../../src/session/session.ts';
import { cloudFile } from './clouds.ts';
import type { Figure } from './table.ts';

const SIZES = [10_000, 100_000, 1_000_000];
const RUNS = 3;

/** Every stage of the chain at three sizes: the best of some runs, after the code is warm. */
export async function benchStages(): Promise<readonly Figure[]> {
  const figures: Figure[] = [];
  for (const points of SIZES) {
    const { path } = await cloudFile(points, 'ply');
    const best = new Map<string, number>();
    const note = (name: string, ms: number) =>
      best.set(name, Math.min(ms, best.get(name) ?? Number.POSITIVE_INFINITY));
    for (let i = 0; i < RUNS; i++) {
      const session = new Session({ strokeTest: createStrokeTest() });
      const { stages } = await session.load(await nodeSource(path), { secondaryCount: 1 });
      for (const { name, ms } of stages) note(name, ms);
      note(
        'whole',
        stages.reduce((sum, { ms }) => sum + ms, 0),
      );
    }
    const of = `${points.toLocaleString('en-GB')} points`;
    for (const [name, ms] of best) figures.push({ name, of, value: ms, unit: 'ms' });
  }
  return figures;
}
