import { FloorPlanError } from '../../core/errors.ts';
import type { PointChunk } from '../cloud-reader.ts';
import { CELLS_TOLD_APART } from './cell-hash.ts';
import { CellTable } from './cell-table.ts';
import { HashedRun, NAME_SHIFT, PRIORITY, RUN_POINTS } from './hashed-run.ts';
import { KeptAttributes } from './kept-attributes.ts';
import { PointSample } from './point-sample.ts';

/** Farther from 0 than this is no place in a building but a mark for "no return": a UTM northing in mm is 10¹⁰. */
export const FARTHEST = 1e12;
/** Finest cell tried when a cloud without cells is over its budget, as a share of its extent. */
const FIRST_SHARE = 2 / CELLS_TOLD_APART;

export interface ThinningOptions {
  /** Edge of the cells to start with, source units, a power of two; 0 keeps every distinct point. */
  readonly cell: number;
  /** Most points kept; past it cells coarsen. */
  readonly budget: number;
  /** Points that will come at most, as far as known: a table of the right size need not grow. */
  readonly expected?: number;
}

/**
 * Keeps one point a cell of a voxel lattice while points stream in; memory is bounded by the points kept.
 *
 * Cells have a power of two as edge, in source units, and the lattice goes through the source's 0, so lattices nest.
 * Of a cell's points the one with the smallest hash of its coordinates is kept (ties: smaller coordinates, then
 * attributes): no grid pattern, no bias to a scanner's order, and as the minimum of minima is the minimum, the points
 * kept are the same for every order of the points, and for coarsening later or starting coarse. When more than
 * `budget` points are kept the edge doubles. Cell 0 keeps every distinct point.
 *
 * {@link CELLS_TOLD_APART} cells apart, along an axis, two cells are taken for one. Points with cells of their own are
 * told apart by a 64-bit hash: among four million, two share one in 1 of 2 million clouds. Complexity: O(points).
 */
export class Thinning {
  /** Edge of a cell in source units, a power of two; 0 where every distinct point is kept. */
  cell: number;
  /** The cell it began with. */
  readonly firstCell: number;
  /** Points kept. */
  count = 0;
  /** Points seen, those dropped included. */
  read = 0;
  /** Points without a finite place. */
  dropped = 0;
  /** Whether the budget made the cells coarser than asked. */
  isOverBudget = false;
  /** Source coordinates of the points kept, x, y, z a point; entries past 3 · count are stale. */
  xyz = new Float64Array(0);
  /** Box around every point with a finite place, kept or not. */
  readonly bounds: Box = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  /** Of every point with a finite place, whatever the cells. */
  readonly sample = new PointSample();
  readonly #budget: number;
  #words = new Int32Array(0);
  #attributes: KeptAttributes | null = null;
  readonly #run = new HashedRun();
  #table: CellTable;

  constructor({ cell, budget, expected = 0 }: ThinningOptions) {
    this.cell = cell;
    this.firstCell = cell;
    this.#budget = budget;
    // Pages that nothing is written to cost no memory.
    const capacity = Math.ceil(Math.min(expected, budget)) + RUN_POINTS;
    this.#table = allocate(() => new CellTable(budget + RUN_POINTS, capacity));
    this.#growArrays(capacity);
  }

  /** Adds the points of a chunk. @throws environment/memory */
  add(chunk: PointChunk): void {
    this.#attributes ??= new KeptAttributes(chunk, this.xyz.length / 3);
    this.#attributes.open(chunk);
    const words = new Int32Array(chunk.xyz.buffer, chunk.xyz.byteOffset, 2 * chunk.xyz.length);
    for (let begin = 0; begin < chunk.count; begin += RUN_POINTS) {
      this.#makeRoom();
      const end = Math.min(chunk.count, begin + RUN_POINTS);
      const isAllPlaced = this.#takeIn(chunk.xyz, begin, end);
      this.#run.hash({ xyz: chunk.xyz, words }, { begin, end }, this.cell);
      this.#table.fetch(this.#run.names, end - begin);
      this.#addRun(chunk, begin, end, isAllPlaced);
      while (this.count > this.#budget) this.#coarsenForBudget();
    }
    this.read += chunk.count;
  }

  /** Thins what is kept to coarser cells: the very points that these cells would have kept from the start. */
  coarsen(cell: number): void {
    this.cell = cell;
    this.#rebuild();
  }

  /** Attributes of the points kept at `indices`. */
  attributesOf(indices: Uint32Array) {
    return this.#attributes?.pick(indices) ?? {};
  }

  /** Lets go of the table; no point can be added after. */
  close(): void {
    this.#table = new CellTable(0, 0);
  }

  #addRun(chunk: PointChunk, begin: number, end: number, isAllPlaced: boolean): void {
    const table = this.#table;
    const { names } = this.#run;
    let { limit } = this.sample;
    for (let i = begin; i < end; i++) {
      if (!isAllPlaced && !isPlace(chunk.xyz, 3 * i)) continue;
      const name = (i - begin) << NAME_SHIFT;
      const priority = names[name + PRIORITY];
      if (priority <= limit) {
        this.sample.add(chunk.xyz, i, priority);
        limit = this.sample.limit;
      }
      const kept = table.find(names, name);
      if (kept < 0) {
        table.insert(~kept, this.count, names, name);
        this.#put(chunk, i, this.count++);
        continue;
      }
      // Most points lose their cell to the one kept there.
      const lead = priority - table.priorityOf(kept);
      if (lead < 0 || (lead === 0 && this.#precedes(chunk, i, kept))) {
        table.replace(kept, priority);
        this.#put(chunk, i, kept);
      }
    }
  }

  /** Bounds grow, −0 becomes 0 (one place, different bits), and points without a place are counted; false where there are any. */
  #takeIn(xyz: Float64Array, begin: number, end: number): boolean {
    const { min, max } = this.bounds;
    let minX = min[0];
    let minY = min[1];
    let minZ = min[2];
    let maxX = max[0];
    let maxY = max[1];
    let maxZ = max[2];
    let dropped = 0;
    for (let i = 3 * begin; i < 3 * end; i += 3) {
      const x = xyz[i];
      const y = xyz[i + 1];
      const z = xyz[i + 2];
      if (!(Math.abs(x) <= FARTHEST && Math.abs(y) <= FARTHEST && Math.abs(z) <= FARTHEST)) {
        dropped++;
        continue;
      }
      if (x === 0) xyz[i] = 0;
      if (y === 0) xyz[i + 1] = 0;
      if (z === 0) xyz[i + 2] = 0;
      if (x < minX) minX = x;
      if (x > maxX) maxX = x;
      if (y < minY) minY = y;
      if (y > maxY) maxY = y;
      if (z < minZ) minZ = z;
      if (z > maxZ) maxZ = z;
    }
    [min[0], min[1], min[2]] = [minX, minY, minZ];
    [max[0], max[1], max[2]] = [maxX, maxY, maxZ];
    this.dropped += dropped;
    return dropped === 0;
  }

  /** Room in arrays and table for one more run. */
  #makeRoom(): void {
    const needed = this.count + RUN_POINTS;
    if (3 * needed > this.xyz.length) this.#growArrays(needed);
    if (!this.#table.hasRoom(needed)) allocate(() => this.#table.growSlots(this.count));
  }

  #growArrays(needed: number): void {
    const capacity = Math.max(needed, Math.min(this.#budget + RUN_POINTS, 2 * this.count));
    const grown = allocate(() => new Float64Array(3 * capacity));
    grown.set(this.xyz.subarray(0, 3 * this.count));
    this.xyz = grown;
    this.#words = new Int32Array(grown.buffer);
    allocate(() => this.#table.growNames(capacity));
    allocate(() => this.#attributes?.grow(capacity));
  }

  #coarsenForBudget(): void {
    this.isOverBudget = true;
    this.coarsen(this.cell > 0 ? 2 * this.cell : powerOfTwoBelow(FIRST_SHARE * diagonalOf(this.bounds)));
  }

  /** Sorts the points kept into the emptied table by the present cell, and closes ranks. */
  #rebuild(): void {
    const { count } = this;
    this.count = 0;
    this.#table.clear();
    for (let begin = 0; begin < count; begin += RUN_POINTS) {
      const end = Math.min(count, begin + RUN_POINTS);
      this.#run.hash({ xyz: this.xyz, words: this.#words }, { begin, end }, this.cell);
      this.#table.fetch(this.#run.names, end - begin);
      this.#sortInRun(begin, end);
    }
  }

  #sortInRun(begin: number, end: number): void {
    const table = this.#table;
    const { names } = this.#run;
    for (let i = begin; i < end; i++) {
      const name = (i - begin) << NAME_SHIFT;
      const kept = table.find(names, name);
      if (kept < 0) {
        table.insert(~kept, this.count, names, name);
        this.#move(i, this.count++);
        continue;
      }
      const lead = names[name + PRIORITY] - table.priorityOf(kept);
      if (lead < 0 || (lead === 0 && isBefore(this.xyz, i, this.xyz, kept))) {
        table.replace(kept, names[name + PRIORITY]);
        this.#move(i, kept);
      }
    }
  }

  #put(chunk: PointChunk, from: number, to: number): void {
    const kept = this.xyz;
    const { xyz } = chunk;
    kept[3 * to] = xyz[3 * from];
    kept[3 * to + 1] = xyz[3 * from + 1];
    kept[3 * to + 2] = xyz[3 * from + 2];
    this.#attributes?.put(from, to);
  }

  #move(from: number, to: number): void {
    if (from === to) return;
    const { xyz } = this;
    xyz[3 * to] = xyz[3 * from];
    xyz[3 * to + 1] = xyz[3 * from + 1];
    xyz[3 * to + 2] = xyz[3 * from + 2];
    this.#attributes?.move(from, to);
  }

  #precedes(chunk: PointChunk, at: number, kept: number): boolean {
    if (isBefore(chunk.xyz, at, this.xyz, kept)) return true;
    if (isBefore(this.xyz, kept, chunk.xyz, at)) return false;
    return this.#attributes?.precedes(at, kept) ?? false;
  }
}

function isBefore(a: Float64Array, at: number, b: Float64Array, bt: number): boolean {
  for (let axis = 0; axis < 3; axis++) {
    const difference = a[3 * at + axis] - b[3 * bt + axis];
    if (difference !== 0) return difference < 0;
  }
  return false;
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

/** Corners of a box that grows. */
interface Box {
  readonly min: [x: number, y: number, z: number];
  readonly max: [x: number, y: number, z: number];
}

/** Whether a point is somewhere, `at` its x; false for NaN too. */
export function isPlace(xyz: Float64Array, at: number): boolean {
  return (
    Math.abs(xyz[at]) <= FARTHEST && Math.abs(xyz[at + 1]) <= FARTHEST && Math.abs(xyz[at + 2]) <= FARTHEST
  );
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
