import { viewOf } from '../bytes/view-of.ts';
import { NUMBER_BYTES, NUMBER_READERS, type NumberType } from '../records.ts';
import type { GltfBytes } from './gltf-bytes.ts';
import type { Accessor, ValueBlock } from './gltf-json.ts';

/** Every value of an accessor, sparse ones in place, normalised where it says so. */
export function valuesOf(accessor: Accessor, bytes: GltfBytes): Float64Array {
  const { count, components, values, sparse, isNormalised } = accessor;
  const result = new Float64Array(count * components);
  if (values) readBlock(values, bytes, { count, components }, result);
  if (sparse) {
    const places = new Float64Array(sparse.count);
    const replaced = new Float64Array(sparse.count * components);
    readBlock(sparse.indices, bytes, { count: sparse.count, components: 1 }, places);
    readBlock(sparse.values, bytes, { count: sparse.count, components }, replaced);
    for (let i = 0; i < sparse.count; i++) {
      if (places[i] < count)
        result.set(replaced.subarray(components * i, components * (i + 1)), components * places[i]);
    }
  }
  const type = values?.type ?? sparse?.values.type;
  if (isNormalised && type) normalise(result, type);
  return result;
}

function readBlock(
  { range, type, offset, stride }: ValueBlock,
  bytes: GltfBytes,
  { count, components }: { readonly count: number; readonly components: number },
  into: Float64Array,
): void {
  const block = bytes.of(range);
  const view = viewOf(block);
  const size = NUMBER_BYTES[type];
  const read = NUMBER_READERS[type];
  for (let i = 0; i < count; i++) {
    const at = offset + i * stride;
    for (let part = 0; part < components; part++)
      into[i * components + part] = read(view, at + part * size, true);
  }
}

/** Integers to 0 … 1, or −1 … 1, glTF 2.0 §3.11. */
function normalise(values: Float64Array, type: NumberType): void {
  if (type === 'float32') return;
  const bits = 8 * NUMBER_BYTES[type] - (type.startsWith('u') ? 0 : 1);
  const most = 2 ** bits - 1;
  for (let i = 0; i < values.length; i++) values[i] = Math.max(-1, values[i] / most);
}
