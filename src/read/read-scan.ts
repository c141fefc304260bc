import { parseClasses } from '../core/classes.ts';
import { countOf } from '../core/count-words.ts';
import { FloorPlanError } from '../core/errors.ts';
import { checkSpread } from '../core/frame/check-spread.ts';
import { judgeUnit, statedUnit } from '../core/frame/judge-unit.ts';
import type { Options } from '../core/params.ts';
import type { Scan, Warning } from '../core/types.ts';
import type { ByteSource } from './bytes/source.ts';
import { ClassFilter } from './class-filter.ts';
import type { OpenCloud, PointChunk } from './cloud-reader.ts';
import { assertPlane } from './geographic.ts';
import { FARTHEST } from './is-place.ts';
import { makeScan } from './make-scan.ts';
import { nextTurn } from './next-turn.ts';
import { openScan } from './open-scan.ts';
import { Preview } from './preview.ts';
import { scanName } from './scan-name.ts';
import { CELLS_TOLD_APART } from './thin/cell-blocks.ts';
import { diagonalOf, powerOfTwoBelow, Thinning } from './thin/thinning.ts';

export type ReadOptions = Pick<
  Options,
  'resolution' | 'pointBudget' | 'unit' | 'metresPerUnit' | 'pixelsPerMetre' | 'classes'
>;

export interface ReadStatus {
  /** Bytes fetched, those of a first reading too; never falls. */
  readonly bytesRead: number;
  /**
   * Bytes there are to fetch, where the source tells its size: twice that size where it is known from the start that
   * it is read twice. Another reading, which nobody could foresee, waits at the whole.
   */
  readonly totalBytes?: number;
  readonly points: number;
}

export interface ReadControl {
  onProgress?: ((status: ReadStatus) => void) | undefined;
  /** Now and then, up to 4,096 sampled points: x, y, z, source units, relative to the first. */
  onPreview?: ((positions: Float32Array) => void) | undefined;
  readonly signal?: AbortSignal | undefined;
}

/** Points after which a cancellation is listened for: some tens of milliseconds of the slowest decoder. */
const POINTS_A_TURN = 1 << 16;
/** Points enough to guess a unit from. */
const POINTS_TRIED = 1 << 13;
/** Clouds of fewer points are checked for lying on a line here, others when they are oriented. */
const CHECKED_POINTS = 1 << 16;

/**
 * Reads a point cloud and thins it to the working resolution; several sources, and the files of an archive, are parts of
 * one scan.
 *
 * Cells are the largest power of two, in source units, that is not above `resolution`; coarser where more than
 * `pointBudget` points would be kept. The unit is judged on the first chunk, to start with the right cell, and again at
 * the end: finer cells are then coarsened, and where coarser ones were used the source is read once more; so is an
 * adaptive cloud of unknown unit, and a cloud without any of the classes asked for: then all are taken. Ready slices
 * keep every distinct point up to the budget. The result does not depend on the order of the points.
 *
 * @throws input/…, environment/network, environment/memory, cancelled
 */
export async function readScan(
  source: ByteSource | readonly ByteSource[],
  options: ReadOptions,
  control: ReadControl = {},
): Promise<Scan> {
  const sources = 'name' in source ? [source] : source;
  const { format, cloud } = await openScan(sources);
  const classes = parseClasses(options.classes);
  const run: ReadRun = {
    name: scanName(sources),
    sources,
    cloud,
    options,
    control,
    readings: 1,
    readingsDone: 0,
    bytesRead: 0,
    told: 0,
    target: 0,
    classes,
    warnings: [],
  };
  const known = cloud.isAdaptive ? statedCell(run) : undefined;
  const isRough = cloud.isAdaptive === true && known === undefined;
  if (isRough) run.readings = 2;
  let thinning = await readOnce(run, known);
  assertPoints(run.name, thinning);
  if (!cloud.isSlice) {
    run.target = targetCell(run, thinning);
    if (isRough || isWrongStart(thinning, run.target)) {
      thinning = await readAgain(run, run.target);
    } else if (thinning.cell < run.target) {
      await listening(thinning.coarsening(run.target), control);
    }
  }
  await listen(control);
  const bytes = sizeOfAll(sources) ?? run.bytesRead;
  const { name, target, warnings } = run;
  const scan = await listening(makeScan(thinning, { name, format, bytes, cloud, target, warnings }), control);
  assertPlane(scan, options);
  assertEnough(scan);
  if (scan.facts.pointsKept <= CHECKED_POINTS) checkSpread(scan.positions);
  return scan;
}

interface ReadRun {
  readonly name: string;
  readonly sources: readonly ByteSource[];
  readonly cloud: OpenCloud;
  readonly options: ReadOptions;
  readonly control: ReadControl;
  /** How often the sources are read, as far as can be foreseen. */
  readings: number;
  readingsDone: number;
  /** In the present reading. */
  bytesRead: number;
  /** Bytes last reported. */
  told: number;
  /** Cell that the resolution asks for, source units; 0 for a slice. */
  target: number;
  /** 1 for each class code to keep; null for all. */
  classes: Uint8Array | null;
  readonly warnings: Warning[];
}

async function readOnce(run: ReadRun, cell?: number): Promise<Thinning> {
  const { cloud, options, control } = run;
  const preview = control.onPreview && run.readingsDone === 0 ? new Preview(control.onPreview) : null;
  let thinning: Thinning | null = null;
  const filter = run.classes && new ClassFilter(run.classes);
  const tell = (bytesRead: number) => {
    run.bytesRead = bytesRead;
    report(run, thinning?.read ?? 0);
  };
  const chunks = cloud.chunks(tell, cell ?? 0, options.pointBudget);
  const expected = cloud.pointsAnnounced ?? 0;
  let unheard = 0;
  for await (const read of chunks) {
    const chunk = filter ? filter.apply(read) : read;
    if (chunk.count === 0) continue;
    thinning ??= new Thinning({ cell: cell ?? firstCell(run, chunk), budget: options.pointBudget, expected });
    await listening(thinning.adding(chunk), control);
    preview?.add(chunk);
    unheard += chunk.count;
    if (unheard >= POINTS_A_TURN) {
      unheard = 0;
      await listen(control);
    }
  }
  preview?.flush();
  const objection = filter?.objection;
  if (objection) {
    run.classes = null;
    run.warnings.push(objection);
    if (!thinning) return readAgain(run, cell);
  }
  if (!thinning) throw noPoints(run.name);
  // A reader need not look at what comes after the points, an index say.
  run.bytesRead = Math.max(run.bytesRead, sizeOfAll(run.sources) ?? 0);
  report(run, thinning.read);
  return thinning;
}

/** From the first byte on; progress goes on where it stands. */
function readAgain(run: ReadRun, cell?: number): Promise<Thinning> {
  run.readingsDone++;
  return readOnce(run, cell);
}

function report(run: ReadRun, points: number): void {
  const { sources, control, readings, readingsDone, bytesRead } = run;
  throwIfCancelled(control);
  const size = sizeOfAll(sources);
  const total = size === undefined ? Infinity : readings * size;
  run.told = Math.max(run.told, Math.min(total, readingsDone * (size ?? 0) + bytesRead));
  control.onProgress?.({
    bytesRead: run.told,
    ...(size !== undefined && { totalBytes: total }),
    points,
  });
}

/** Hears a cancellation that waits for its turn. @throws cancelled */
async function listen(control: ReadControl): Promise<void> {
  if (control.signal) await nextTurn();
  throwIfCancelled(control);
}

/** Takes steps to their end and hears a cancellation between them. @throws cancelled */
async function listening<T>(steps: Generator<void, T>, control: ReadControl): Promise<T> {
  let step = steps.next();
  while (!step.done) {
    await listen(control);
    step = steps.next();
  }
  return step.value;
}

function throwIfCancelled({ signal }: ReadControl): void {
  if (signal?.aborted) throw new FloorPlanError('cancelled', 'Reading was cancelled.');
}

function sizeOfAll(sources: readonly ByteSource[]): number | undefined {
  let sum = 0;
  for (const { size } of sources) {
    if (size === undefined) return undefined;
    sum += size;
  }
  return sum;
}

/** A guess that only speed depends on: the cell that the unit of the first points asks for, of which some are looked at. */
function firstCell(run: ReadRun, chunk: PointChunk): number {
  if (run.cloud.isSlice) return 0;
  const step = Math.max(1, Math.floor(chunk.count / POINTS_TRIED));
  const count = Math.floor(chunk.count / step);
  const xyz = new Float64Array(3 * count);
  for (let i = 0; i < count; i++) xyz.set(chunk.xyz.subarray(3 * i * step, 3 * i * step + 3), 3 * i);
  const trial = new Thinning({ cell: 0, budget: count });
  trial.add({ count, xyz });
  return diagonalOf(trial.bounds) > 0 ? targetCell(run, trial) : 0;
}

/** The cell, where the unit need not be judged. */
function statedCell({ cloud, options }: ReadRun): number | undefined {
  const stated = statedUnit(cloud, options);
  return stated ? powerOfTwoBelow(options.resolution / stated.metresPerUnit) : undefined;
}

/** Whether points were lost that cells of `target` keep: to cells too coarse, or too fine to be told apart. */
function isWrongStart({ cell, firstCell, isOverBudget, bounds }: Thinning, target: number): boolean {
  const isFiner = firstCell > 0 && firstCell < target;
  if (isFiner && diagonalOf(bounds) / firstCell >= CELLS_TOLD_APART) return true;
  return cell > target && !isOverBudget;
}

function targetCell(run: ReadRun, { sample }: Thinning): number {
  const { resolution } = run.options;
  const positions = sample.positions(sample.middle());
  const judged = { positions, isSlice: false, ...(run.cloud.unit && { unit: run.cloud.unit }) };
  const { metresPerUnit } = judgeUnit(judged, { ...run.options, up: 'auto' });
  return powerOfTwoBelow(resolution / metresPerUnit);
}

/** @throws input/empty, input/not-finite */
function assertPoints(name: string, thinning: Thinning): void {
  const { read, dropped } = thinning;
  if (read === 0) throw noPoints(name);
  if (dropped === read) {
    throw new FloorPlanError(
      'input/not-finite',
      `${name}: expected coordinates of up to ±${FARTHEST.toExponential(0)}, found none in ${countOf(read, 'point')}`,
      {
        hint: 'Export the cloud again, without invalid points.',
        detail: { dropped },
      },
    );
  }
}

/** @throws input/too-few-points */
function assertEnough({ facts: { name, pointsKept } }: Scan): void {
  if (pointsKept >= 3) return;
  throw new FloorPlanError(
    'input/too-few-points',
    `${name}: expected at least 3 distinct points, found ${countOf(pointsKept, 'point')}`,
    { hint: 'Check that the file holds the whole cloud.', detail: { points: pointsKept } },
  );
}

function noPoints(name: string): FloorPlanError {
  return new FloorPlanError('input/empty', `${name}: expected points, found no points`, {
    hint: 'Export the cloud again, with its points.',
  });
}
