/** A view of bytes, from byte `begin` on. */
export function viewOf(bytes: Uint8Array, begin = 0): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset + begin, bytes.byteLength - begin);
}
