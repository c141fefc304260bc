import { FloorPlanError } from '../../core/errors.ts';
import type { Vec3 } from '../../core/types.ts';
import type { PointChunk } from '../cloud-reader.ts';
import { CellBlocks } from './cell-blocks.ts';
import type { AttributeSet } from './point-records.ts';
import { type Box, PointRun, RUN_POINTS } from './point-run.ts';
import { PointSample } from './point-sample.ts';
import { copyInOrder, type ThinnedPoints } from './thinned-points.ts';

/** Finest cell tried when a cloud without cells is over its budget, as a share of its extent. */
const FIRST_SHARE = 2 ** -20;
/** Cells that order a cloud without cells, as a share of its extent. */
const ORDER_SHARE = 2 ** -15;
/** Points held, as a share of the budget, before those that lose their cell are left out. */
const HELD_SHARE = 1.25;
/** Records laid out for a point that is held: last pages are not full. Memory that is not written to costs nothing. */
const RECORDS_PER_POINT = 1.125;

export interface ThinningOptions {
  /** Edge of the cells to start with, source units, a power of two; 0 keeps every distinct point. */
  readonly cell: number;
  /** Most points kept; past it cells coarsen. */
  readonly budget: number;
  /** Points that will come at most, as far as known: a store of the right size need not grow. */
  readonly expected?: number;
}

/**
 * Keeps one point a cell of a voxel lattice while points stream in; memory is bounded by the points kept.
 *
 * Cells have a power of two as edge, in source units, and the lattice goes through the source's 0, so lattices nest.
 * Of a cell's points the one with the smallest hash of its coordinates is kept (ties: smaller coordinates, then
 * attributes): no grid pattern, no bias to a scanner's order, and as the minimum of minima is the minimum, the points
 * kept are the same for every order of the points, and for coarsening later or starting coarse. When more than
 * `budget` points are kept the edge doubles. Cell 0 keeps every distinct point. Complexity: O(points).
 *
 * Not taken, in ms for 2 M points of 31 bytes, most of them kept, read and ordered in Node on two cores: a thread for each
 * half of the bytes, 199 → 239, as what one of them kept is added again, which takes as long as the other has saved; this
 * folder in WebAssembly, 241 → 209, with the decoding of records 160, but it needs a double where a page forbids WebAssembly.
 */
export class Thinning {
  /** Edge of a cell in source units, a power of two; 0 where every distinct point is kept. */
  cell: number;
  /** The cell it began with. */
  readonly firstCell: number;
  /** Points seen, those dropped included. */
  read = 0;
  /** Points without a finite place. */
  dropped = 0;
  /** Whether the budget made the cells coarser than asked. */
  isOverBudget = false;
  /** Box around every point with a finite place, kept or not. */
  readonly bounds: Box = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  /** Of every point with a finite place, whatever the cells. */
  readonly sample = new PointSample();
  readonly #budget: number;
  readonly #expected: number;
  readonly #run = new PointRun();
  #has: AttributeSet | null = null;
  #blocks: CellBlocks | null = null;

  constructor({ cell, budget, expected = 0 }: ThinningOptions) {
    this.cell = cell;
    this.firstCell = cell;
    this.#budget = budget;
    this.#expected = expected;
  }

  /** Points kept. */
  get count(): number {
    atOnce(this.#settle());
    return this.#blocks?.held ?? 0;
  }

  /** Adds the points of a chunk at once; see {@link adding}. */
  add(chunk: PointChunk): void {
    atOnce(this.adding(chunk));
  }

  /** Adds the points of a chunk, step by step where many must be looked through; attributes are those that the first chunk has. @throws environment/memory */
  *adding(chunk: PointChunk): Generator<void> {
    this.#has ??= attributesIn(chunk);
    const run = this.#run;
    const { xyz } = chunk;
    const places = { xyz, stride: 3 };
    const bits = new Int32Array(xyz.buffer, xyz.byteOffset, 2 * xyz.length);
    for (let begin = 0; begin < chunk.count; begin += RUN_POINTS) {
      const end = Math.min(chunk.count, begin + RUN_POINTS);
      run.take(chunk, bits, { begin, end }, this.bounds);
      this.dropped += end - begin - run.count;
      this.#addToSample(xyz, run);
      this.#blocks ??= this.#makeBlocks(this.#has);
      const blocks = this.#blocks;
      allocate(() => blocks.append(places, run, (records) => records.setAttributes(run, chunk)));
      if (blocks.held > this.#budget * HELD_SHARE) yield* this.#settle();
    }
    this.read += chunk.count;
  }

  /** Thins what is kept to coarser cells: the very points that these cells would have kept from the start. */
  coarsen(cell: number): void {
    atOnce(this.coarsening(cell));
  }

  /** The same, step by step. */
  *coarsening(cell: number): Generator<void> {
    this.cell = cell;
    yield* this.#rebuild();
  }

  /** Copies out the points kept, relative to `origin`. */
  inOrder<T extends Float32Array | Float64Array>(
    origin: Vec3,
    make: (length: number) => T,
  ): ThinnedPoints<T> {
    return atOnce(this.ordering(origin, make));
  }

  /** The same, step by step. */
  *ordering<T extends Float32Array | Float64Array>(
    origin: Vec3,
    make: (length: number) => T,
  ): Generator<void, ThinnedPoints<T>> {
    if (this.#blocks && this.#blocks.held > this.#budget) yield* this.#settle();
    // The first points gave a cloud without cells its lattice.
    if (this.cell === 0 && this.#blocks && this.#blocks.cell !== this.#lattice()) yield* this.#rebuild();
    const blocks = this.#blocks ?? this.#makeBlocks(attributesIn({}));
    return yield* allocating(copyInOrder(blocks, origin, make));
  }

  #addToSample(xyz: Float64Array, { count, points, priorities }: PointRun): void {
    let { limit } = this.sample;
    for (let k = 0; k < count; k++) {
      if (priorities[k] > limit) continue;
      this.sample.add(xyz, 3 * points[k], priorities[k]);
      limit = this.sample.limit;
    }
  }

  /** Leaves out the points that lose their cell, and coarsens while too many are left. */
  *#settle(): Generator<void> {
    const blocks = this.#blocks;
    if (!blocks) return;
    yield* blocks.settling();
    while (this.#blocks && this.#blocks.held > this.#budget) {
      this.isOverBudget = true;
      yield* this.coarsening(
        this.cell > 0 ? 2 * this.cell : powerOfTwoBelow(FIRST_SHARE * diagonalOf(this.bounds)),
      );
    }
  }

  #makeBlocks(has: AttributeSet): CellBlocks {
    const expected = Math.min(this.#expected, HELD_SHARE * this.#budget);
    const capacity = Math.ceil(RECORDS_PER_POINT * expected);
    return allocate(
      () => new CellBlocks({ cell: this.cell || this.#lattice(), keepsAll: this.cell === 0, has, capacity }),
    );
  }

  /** Cells for points that need none. */
  #lattice(): number {
    return powerOfTwoBelow(ORDER_SHARE * diagonalOf(this.bounds)) || 1;
  }

  *#rebuild(): Generator<void> {
    const old = this.#blocks;
    if (!old) return;
    this.#blocks = this.#makeBlocks(old.records.has);
    const blocks = this.#blocks;
    yield* allocating(old.moving(blocks));
    yield* blocks.settling();
  }
}

function attributesIn(chunk: Partial<PointChunk>): AttributeSet {
  const { colour, intensity, classification, station } = chunk;
  return {
    colour: colour !== undefined,
    intensity: intensity !== undefined,
    classification: classification !== undefined,
    station: station !== undefined,
  };
}

/** The largest power of two that is not above `value`. */
export function powerOfTwoBelow(value: number): number {
  const power = 2 ** Math.floor(Math.log2(value));
  if (power > value) return power / 2;
  return 2 * power <= value ? 2 * power : power;
}

/** Diagonal of a box, source units; 0 where it is empty. */
export function diagonalOf({ min, max }: Box): number {
  return Math.hypot(...max.map((high, axis) => Math.max(0, high - min[axis])));
}

function atOnce<T>(steps: Generator<void, T>): T {
  let step = steps.next();
  while (!step.done) step = steps.next();
  return step.value;
}

function* allocating<T>(steps: Generator<void, T>): Generator<void, T> {
  let step = allocate(() => steps.next());
  while (!step.done) {
    yield;
    step = allocate(() => steps.next());
  }
  return step.value;
}

function allocate<T>(make: () => T): T {
  try {
    return make();
  } catch (cause) {
    throw new FloorPlanError('environment/memory', 'There is not enough memory for the points to be kept.', {
      hint: 'Lower the point budget.',
      cause,
    });
  }
}
