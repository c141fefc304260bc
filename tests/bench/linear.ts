import { execFile } from 'node:child_process';
import { access, mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { simulate } from '../../fixtures/simulator/index.ts';
import { officeBuilding } from '../../fixtures/simulator/layouts.ts';
import { bundleChild } from './child-bundle.ts';
import { cacheFolder } from './clouds.ts';
import type { LinearRun } from './linear-child.ts';
import type { Figure } from './table.ts';

const TILE_POINTS = 1_000_000;
/** Millions of points; LINEAR_COPIES=1,2,5 for others. */
const COPIES = (process.env.LINEAR_COPIES ?? '1,2,5,10,20,50').split(',').map(Number);
/** m, with the outer walls. */
const TILE = { width: 24 + 0.72, depth: 13 + 0.72 };
/** Less is the clock's grain, and no growth is told by it, ms. */
const LEAST_MS = 5;

const run = promisify(execFile);

/** The whole chain on an office of 1 to 50 M points, most of them kept: time and memory by stage, and how they grow. */
export async function benchLinear(): Promise<readonly Figure[]> {
  const tile = await officeTile();
  const child = await bundleChild('linear-child');
  const runs = new Map<number, LinearRun>();
  for (const copies of COPIES) {
    const words = ['--max-old-space-size=8000', child, tile, ...[copies, TILE.width, TILE.depth].map(String)];
    const { stdout } = await run(process.execPath, words, { maxBuffer: 2 ** 24 });
    runs.set(copies, JSON.parse(stdout.trim().split('\n').at(-1)!));
    console.log(`  ${copies} M points: ${(runs.get(copies)!.wallMs / 1000).toFixed(1)} s`);
  }
  return [...runs].flatMap(([copies, own]) => figuresOf(copies, own)).concat(growths(runs));
}

function figuresOf(copies: number, { stages, kept, ...times }: LinearRun): Figure[] {
  const points = copies * TILE_POINTS;
  const figure = (name: string, value: number, unit: string): Figure => ({
    name,
    of: `${copies} M`,
    value,
    unit,
  });
  return [
    ...stages.map(({ name, cpuMs }) => figure(name, cpuMs, 'ms of CPU')),
    figure('whole', times.cpuMs, 'ms of CPU'),
    figure('whole, by the clock', times.wallMs, 'ms of CPU'),
    figure('whole, first run on 1 M points, by the clock', times.firstMs, 'ms of CPU'),
    ...stages.map(({ name, cpuMs }) => figure(name, points / 1000 / cpuMs, 'M points/s of CPU')),
    figure('whole', points / 1000 / times.cpuMs, 'M points/s of CPU'),
    ...stages.map(({ name, peakMB }) => figure(name, peakMB, 'peak MB so far')),
    figure('kept, M points', kept / 1e6, 'peak MB so far'),
  ];
}

/** Time as a power of the points: 1 is linear. Of all sizes, and of the last step alone. */
function growths(runs: ReadonlyMap<number, LinearRun>): Figure[] {
  const names = [...runs.values()][0].stages.map(({ name }) => name);
  const timeOf = ({ stages, cpuMs }: LinearRun, name: string) =>
    name === 'whole' ? cpuMs : stages.find((stage) => stage.name === name)!.cpuMs;
  return [...names, 'whole'].flatMap((name) => {
    const points = [...runs]
      .map(([copies, own]): readonly [number, number] => [copies, timeOf(own, name)])
      .filter(([, ms]) => ms >= LEAST_MS);
    if (points.length < 2) return [];
    const figure = (of: string, value: number): Figure => ({
      name,
      of,
      value,
      unit: 'time as a power of points',
    });
    return [figure('all sizes', powerOf(points)), figure('last step', powerOf(points.slice(-2)))];
  });
}

/** Slope of the least-squares line through the logarithms. */
function powerOf(points: readonly (readonly [number, number])[]): number {
  const logs = points.map(([n, ms]) => [Math.log(n), Math.log(ms)]);
  const mean = (axis: 0 | 1) => logs.reduce((sum, log) => sum + log[axis], 0) / logs.length;
  const [x, y] = [mean(0), mean(1)];
  const above = logs.reduce((sum, log) => sum + (log[0] - x) * (log[1] - y), 0);
  return above / logs.reduce((sum, log) => sum + (log[0] - x) ** 2, 0);
}

/** An office floor in metres, float32 x, y, z a point, in the order of scanning; made once. */
async function officeTile(): Promise<string> {
  const path = join(cacheFolder, `office-${TILE_POINTS}.f32`);
  if (
    await access(path).then(
      () => true,
      () => false,
    )
  )
    return path;
  const { positions } = simulate({
    name: 'office',
    building: officeBuilding(1),
    scan: { voxel: 0, raysPerStation: 100_000 },
  }).scan;
  const count = positions.length / 3;
  if (count < TILE_POINTS)
    throw new Error(`Expected ${TILE_POINTS} points of the simulator, found ${count}.`);
  const tile = new Float32Array(3 * TILE_POINTS);
  for (let i = 0; i < TILE_POINTS; i++) {
    const from = 3 * Math.floor((i * count) / TILE_POINTS);
    for (let axis = 0; axis < 3; axis++) tile[3 * i + axis] = positions[from + axis];
  }
  await mkdir(cacheFolder, { recursive: true });
  await writeFile(path, new Uint8Array(tile.buffer));
  return path;
}
