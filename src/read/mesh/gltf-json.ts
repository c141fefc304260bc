import { FloorPlanError } from '../../core/errors.ts';
import { NUMBER_BYTES, type NumberType } from '../records.ts';
import { type Packing, packedPart, readPacking } from './packed-view.ts';

/** A JSON object of unknown content. */
export type JsonObject = Readonly<Record<string, unknown>>;

/** Numbers of glTF 2.0 §5.1.3. */
const COMPONENT_TYPES: Readonly<Record<number, NumberType>> = {
  5120: 'int8',
  5121: 'uint8',
  5122: 'int16',
  5123: 'uint16',
  5125: 'uint32',
  5126: 'float32',
};
const COMPONENTS: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
/** Values that lie nowhere in the file are zeros; no model needs many. */
const MOST_ZEROS = 1 << 20;

/** Bytes of a buffer. */
export interface ByteRange {
  readonly buffer: number;
  readonly begin: number;
  readonly end: number;
  /** How they are packed, if they are. */
  readonly packing?: Packing;
}

/** Values in a buffer. */
export interface ValueBlock {
  /** The whole buffer view. */
  readonly range: ByteRange;
  readonly type: NumberType;
  /** Of the first value, from the begin of the view. */
  readonly offset: number;
  readonly stride: number;
}

/** An accessor whose every number was checked. */
export interface Accessor {
  readonly count: number;
  readonly components: number;
  /** Integers stand for −1 … 1 or 0 … 1. */
  readonly isNormalised: boolean;
  /** Undefined: zeros. */
  readonly values: ValueBlock | undefined;
  /** Values put in place of others. */
  readonly sparse:
    | { readonly count: number; readonly indices: ValueBlock; readonly values: ValueBlock }
    | undefined;
}

/** The JSON of a glTF 2.0 model; what is looked up is checked, for anybody may have written it. */
export class GltfJson {
  readonly root: JsonObject;
  readonly name: string;

  /** @throws input/malformed */
  constructor(name: string, text: string) {
    this.name = name;
    this.root = this.#parse(text);
    const version = this.object(this.root.asset, 'asset').version;
    if (!/^2\./.test(String(version)))
      throw this.malformed('version 2 in asset', `version ${String(version).slice(0, 20)}`);
  }

  /** An entry of the root that is a list; empty where there is none. */
  list(key: string): readonly unknown[] {
    return this.array(this.root[key] ?? [], key);
  }

  array(value: unknown, where: string): readonly unknown[] {
    if (Array.isArray(value)) return value;
    throw this.malformed(`a list at ${where}`, typeof value);
  }

  object(value: unknown, where: string): JsonObject {
    if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as JsonObject;
    throw this.malformed(`an object at ${where}`, typeof value);
  }

  /** The object of a list of the root that `index` points at. */
  item(key: string, index: unknown, from: string): JsonObject {
    const list = this.list(key);
    const isIndex = typeof index === 'number' && Number.isInteger(index) && index >= 0 && index < list.length;
    if (!isIndex)
      throw this.malformed(
        `an index below ${list.length} into ${key} at ${from}`,
        JSON.stringify(index) ?? 'none',
      );
    return this.object(list[index], `${key}[${index}]`);
  }

  /** A whole number, 0 or more. */
  count(value: unknown, where: string, otherwise?: number): number {
    if (value === undefined && otherwise !== undefined) return otherwise;
    if (typeof value === 'number' && Number.isSafeInteger(value) && value >= 0) return value;
    throw this.malformed(`a count at ${where}`, JSON.stringify(value) ?? 'none');
  }

  accessor(index: unknown, from: string): Accessor {
    const json = this.item('accessors', index, from);
    const where = `accessors[${index}]`;
    const count = this.count(json.count, `${where}.count`);
    const components = COMPONENTS[String(json.type)];
    if (!components)
      throw this.malformed(`SCALAR or VEC2 to VEC4 at ${where}.type`, String(json.type).slice(0, 20));
    const values =
      json.bufferView === undefined ? undefined : this.#block(json, { where, count, components });
    if (!values && count > MOST_ZEROS)
      throw this.malformed(`a buffer view at ${where} of ${count} values`, 'none');
    const isNormalised = json.normalized === true;
    return {
      count,
      components,
      isNormalised,
      values,
      sparse: this.#sparse(json, { where, count, components }),
    };
  }

  /** The bytes of a buffer view, which lie within the length its buffer states. */
  range(index: unknown, where: string): ByteRange {
    const view = this.item('bufferViews', index, where);
    const from = `bufferViews[${index}]`;
    const packed = packedPart(view, from, this);
    const part = packed ?? view;
    const buffer = this.count(part.buffer, `${from}.buffer`);
    const length = this.count(this.item('buffers', buffer, from).byteLength, `buffers[${buffer}].byteLength`);
    const begin = this.count(part.byteOffset, `${from}.byteOffset`, 0);
    const end = begin + this.count(part.byteLength, `${from}.byteLength`);
    if (end > length)
      throw this.malformed(`${from} within the ${length} bytes of its buffer`, `its end at ${end}`);
    return { buffer, begin, end, ...(packed && { packing: readPacking(packed, from, this) }) };
  }

  malformed(expected: string, found: string): FloorPlanError {
    return new FloorPlanError(
      'input/malformed',
      `${this.name}: expected ${expected}, found ${found.slice(0, 60)}`,
      {
        hint: 'Export the model again; a glTF validator shows what is wrong with it.',
      },
    );
  }

  #parse(text: string): JsonObject {
    try {
      return this.object(JSON.parse(text), 'the root');
    } catch (cause) {
      if (cause instanceof FloorPlanError) throw cause;
      throw new FloorPlanError(
        'input/malformed',
        `${this.name}: expected JSON, found ${String(cause).slice(0, 80)}`,
        {
          hint: 'The file seems damaged; copy or export it again.',
          cause,
        },
      );
    }
  }

  #sparse(json: JsonObject, { where, count, components }: BlockShape): Accessor['sparse'] {
    if (json.sparse === undefined) return undefined;
    const at = `${where}.sparse`;
    const sparse = this.object(json.sparse, at);
    const some = this.count(sparse.count, `${at}.count`);
    if (some > count) throw this.malformed(`at most ${count} values at ${at}`, `${some}`);
    const indices = this.object(sparse.indices, `${at}.indices`);
    const values = { componentType: json.componentType, ...this.object(sparse.values, `${at}.values`) };
    return {
      count: some,
      indices: this.#block(indices, { where: `${at}.indices`, count: some, components: 1 }),
      values: this.#block(values, { where: `${at}.values`, count: some, components }),
    };
  }

  /** Checks that all values lie within the view. */
  #block(json: JsonObject, { where, count, components }: BlockShape): ValueBlock {
    const type = COMPONENT_TYPES[Number(json.componentType)];
    if (!type) throw this.malformed(`a component type at ${where}`, String(json.componentType));
    const view = this.item('bufferViews', json.bufferView, where);
    const from = `bufferViews[${json.bufferView}]`;
    const range = this.range(json.bufferView, where);
    const { packing } = range;
    const length = packing ? packing.count * packing.stride : range.end - range.begin;
    const size = components * NUMBER_BYTES[type];
    const stride = this.count(view.byteStride, `${from}.byteStride`, size);
    const offset = this.count(json.byteOffset, `${where}.byteOffset`, 0);
    const needed = count === 0 ? 0 : offset + (count - 1) * stride + size;
    if (stride < size || needed > length)
      throw this.malformed(`${count} values of ${size} bytes at ${where} within ${from}`, `${length} bytes`);
    return { range, type, offset, stride };
  }
}

interface BlockShape {
  readonly where: string;
  readonly count: number;
  readonly components: number;
}
