import { wasmError } from '../wasm.ts';
import type { Packing } from './packed-view.ts';

/**
 * Unpacks what meshopt has packed; the decoder is small and comes with the first such model.
 *
 * @returns null where the bytes make no sense
 * @throws environment/wasm
 */
export async function unpackMeshopt(
  packed: Uint8Array,
  { mode, filter, count, stride }: Packing,
): Promise<Uint8Array | null> {
  const { MeshoptDecoder } = await import('meshoptimizer/decoder');
  try {
    await MeshoptDecoder.ready;
  } catch (cause) {
    throw noWasm(cause);
  }
  if (!MeshoptDecoder.supported) throw noWasm();
  const bytes = new Uint8Array(count * stride);
  try {
    MeshoptDecoder.decodeGltfBuffer(bytes, count, stride, packed, mode, filter);
  } catch {
    return null;
  }
  return bytes;
}

function noWasm(cause?: unknown) {
  return wasmError('A model packed by meshopt', 'the model without meshopt compression', cause);
}
