import { viewOf } from '../bytes/view-of.ts';
import type { FieldColumn } from '../point-buffer.ts';
import type { PackedField } from './prototype.ts';

const FIRST_BYTES = 1 << 17;
/** Values are read by words of four bytes; the last ones may reach beyond what has come. */
const BYTES_BEYOND = 9;
/** Widest value that four bytes hold wherever in a byte it begins. */
const NARROW_BITS = 25;
const WORD = 2 ** 32;

/**
 * The bytestream of one field, gathered from packet after packet, and its values unpacked.
 *
 * A value is `bits` wide and follows the one before without a gap, lowest bit first; packets cut it anywhere
 * ([E2807] §9.5).
 */
export class PackedColumn {
  readonly field: PackedField;
  #bytes = new Uint8Array(FIRST_BYTES);
  #length = 0;
  /** Bit at which the next value begins. */
  #bit = 0;

  constructor(field: PackedField) {
    this.field = field;
  }

  /** Bytes that have come and are not unpacked. */
  get waiting(): number {
    return this.#length - (this.#bit >>> 3);
  }

  /** Values that can be unpacked. */
  get available(): number {
    const { bits } = this.field;
    return bits === 0 ? Number.POSITIVE_INFINITY : Math.floor((8 * this.#length - this.#bit) / bits);
  }

  append(bytes: Uint8Array): void {
    const needed = this.#length + bytes.length + BYTES_BEYOND;
    if (needed > this.#bytes.length) this.#makeRoom(needed);
    this.#bytes.set(bytes, this.#length);
    this.#length += bytes.length;
  }

  /** Unpacks `count` values, which must be available. Complexity: O(count). */
  unpack(column: FieldColumn, count: number): void {
    const { kind, bits } = this.field;
    if (kind === 'integer' && bits <= NARROW_BITS) this.#unpackNarrow(column, count);
    else if (kind === 'integer') this.#unpackWide(column, count);
    else this.#unpackFloats(column, count);
    this.#bit += count * bits;
  }

  #makeRoom(needed: number): void {
    const spent = this.#bit >>> 3;
    const grown = needed - spent > this.#bytes.length ? new Uint8Array(2 * (needed - spent)) : this.#bytes;
    grown.set(this.#bytes.subarray(spent, this.#length));
    this.#bytes = grown;
    this.#length -= spent;
    this.#bit &= 7;
  }

  #unpackNarrow({ into, first, step }: FieldColumn, count: number): void {
    const { bits, scale, shift, minimum } = this.field;
    const bytes = this.#bytes;
    const least = minimum.high * WORD + minimum.low;
    const mask = (1 << bits) - 1;
    const end = first + step * count;
    let bit = this.#bit;
    for (let to = first; to < end; to += step, bit += bits) {
      const at = bit >>> 3;
      const word = bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16) | (bytes[at + 3] << 24);
      into[to] = (((word >>> (bit & 7)) & mask) + least) * scale + shift;
    }
  }

  #unpackWide({ into, first, step }: FieldColumn, count: number): void {
    const { bits, scale, shift, minimum } = this.field;
    const lowMask = bits < 32 ? (1 << bits) - 1 : -1;
    const highMask = bits < 64 ? 2 ** Math.max(0, bits - 32) - 1 : -1;
    const view = viewOf(this.#bytes);
    const end = first + step * count;
    let bit = this.#bit;
    for (let to = first; to < end; to += step, bit += bits) {
      const at = bit >>> 3;
      const within = bit & 7;
      const word = view.getUint32(at, true);
      const next = view.getUint32(at + 4, true);
      // Shifts by 32 would be shifts by 0.
      const over = within > 0 ? next << (32 - within) : 0;
      const last = within > 0 ? view.getUint8(at + 8) << (32 - within) : 0;
      const low = (((word >>> within) | over) & lowMask) >>> 0;
      const high = (((next >>> within) | last) & highMask) >>> 0;
      into[to] = ((high + minimum.high) * WORD + (low + minimum.low)) * scale + shift;
    }
  }

  #unpackFloats({ into, first, step }: FieldColumn, count: number): void {
    const view = viewOf(this.#bytes);
    let at = this.#bit >>> 3;
    const end = first + step * count;
    if (this.field.kind === 'float32') {
      for (let to = first; to < end; to += step, at += 4) into[to] = view.getFloat32(at, true);
    } else {
      for (let to = first; to < end; to += step, at += 8) into[to] = view.getFloat64(at, true);
    }
  }
}
