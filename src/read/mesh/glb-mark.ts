import { latin1 } from '../signatures.ts';

const MAGIC = 'glTF';

/** Whether the first bytes are those of a binary glTF. */
export function isGlb(head: Uint8Array): boolean {
  return latin1(head.subarray(0, MAGIC.length)) === MAGIC;
}
