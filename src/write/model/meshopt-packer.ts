import { FloorPlanError } from '../../core/errors.ts';
import type { ViewPacker } from './glb-buffers.ts';

/**
 * Packs buffer views by meshopt (EXT_meshopt_compression), without loss: every number comes back bit for bit, triangles in
 * their order. The encoder is small and comes with the first model that is packed.
 *
 * @throws environment/wasm
 */
export async function meshoptPacker(): Promise<ViewPacker> {
  const { MeshoptEncoder } = await import('meshoptimizer/encoder');
  try {
    await MeshoptEncoder.ready;
  } catch (cause) {
    throw noWasm(cause);
  }
  if (!MeshoptEncoder.supported) throw noWasm();
  return {
    extension: 'EXT_meshopt_compression',
    pack: (bytes, { stride, isIndices }) => {
      const [count, mode] = [bytes.length / stride, isIndices ? 'TRIANGLES' : 'ATTRIBUTES'];
      // The extension knows the first version of the codecs alone.
      const packed = MeshoptEncoder.encodeGltfBuffer(bytes, count, stride, mode, 0);
      return { bytes: packed, facts: { byteStride: stride, count, mode } };
    },
  };
}

function noWasm(cause?: unknown): FloorPlanError {
  return new FloorPlanError(
    'environment/wasm',
    'A model is packed by meshopt with WebAssembly, which may not be used here.',
    {
      hint: "Allow 'wasm-unsafe-eval' in the page's content security policy, or leave the model unpacked.",
      cause,
    },
  );
}
