import type { PointAttributes } from '../../core/types.ts';
import { ATTRIBUTE_WIDTHS, ATTRIBUTES } from '../cloud-reader.ts';

type AttributeArray = Uint8Array | Uint16Array | Float32Array;

interface Column {
  readonly name: keyof PointAttributes;
  readonly width: number;
  values: AttributeArray;
  /** Of the chunk at hand. */
  source: AttributeArray | undefined;
}

/** The attributes of the points that thinning keeps: those that the first chunk has. */
export class KeptAttributes {
  readonly #columns: Column[] = [];

  constructor(like: PointAttributes, capacity: number) {
    for (const name of ATTRIBUTES) {
      const example = like[name];
      const width = ATTRIBUTE_WIDTHS[name];
      if (example)
        this.#columns.push({ name, width, values: makeLike(example, width * capacity), source: undefined });
    }
  }

  grow(capacity: number): void {
    for (const column of this.#columns) {
      const values = makeLike(column.values, column.width * capacity);
      values.set(column.values.subarray(0, values.length));
      column.values = values;
    }
  }

  /** Takes up a chunk, whose points the following calls speak of. */
  open(chunk: PointAttributes): void {
    for (const column of this.#columns) column.source = chunk[column.name];
  }

  /** Copies the attributes of the chunk's point `from` to place `to`. */
  put(from: number, to: number): void {
    const columns = this.#columns;
    for (let c = 0; c < columns.length; c++) {
      const { width, values, source } = columns[c];
      for (let i = 0; i < width; i++) values[width * to + i] = source ? source[width * from + i] : 0;
    }
  }

  move(from: number, to: number): void {
    for (const { width, values } of this.#columns) {
      for (let i = 0; i < width; i++) values[width * to + i] = values[width * from + i];
    }
  }

  /** Whether the chunk's point comes before a kept one of the same place: the first attribute that differs is smaller. */
  precedes(from: number, kept: number): boolean {
    for (const { width, values, source } of this.#columns) {
      for (let i = 0; i < width; i++) {
        const difference = (source?.[width * from + i] ?? 0) - values[width * kept + i];
        if (difference !== 0) return difference < 0;
      }
    }
    return false;
  }

  /** The attributes of the points at `indices`, in that order. */
  pick(indices: Uint32Array): PointAttributes {
    const picked: Record<string, AttributeArray> = {};
    for (const { name, width, values } of this.#columns) {
      const target = makeLike(values, width * indices.length);
      for (let i = 0; i < indices.length; i++) {
        for (let j = 0; j < width; j++) target[width * i + j] = values[width * indices[i] + j];
      }
      picked[name] = target;
    }
    return picked as PointAttributes;
  }
}

function makeLike(example: AttributeArray, length: number): AttributeArray {
  if (example instanceof Uint8Array) return new Uint8Array(length);
  return example instanceof Uint16Array ? new Uint16Array(length) : new Float32Array(length);
}
