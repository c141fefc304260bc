/** Below this the interval takes in another byte. */
const LEAST_LENGTH = 0x0100_0000;
const BIT_SHIFT = 13;
const SYMBOL_SHIFT = 15;
/** Largest numerator of a probability: 2³¹. */
const SCALE = 0x8000_0000;

/** A bit whose odds are learnt as it goes. */
export class BitModel {
  probability = 1 << (BIT_SHIFT - 1);
  untilUpdate = 4;
  #zeros = 1;
  #count = 2;
  #cycle = 4;

  seeZero(): void {
    this.#zeros++;
  }

  update(): void {
    this.#count += this.#cycle;
    if (this.#count > 1 << BIT_SHIFT) {
      this.#count = (this.#count + 1) >> 1;
      this.#zeros = (this.#zeros + 1) >> 1;
      if (this.#zeros === this.#count) this.#count++;
    }
    const scale = Math.floor(SCALE / this.#count);
    this.probability = Math.floor((this.#zeros * scale) / 2 ** (31 - BIT_SHIFT));
    this.#cycle = Math.min(64, (5 * this.#cycle) >> 2);
    this.untilUpdate = this.#cycle;
  }
}

/** A symbol whose odds are learnt as it goes. */
export class SymbolModel {
  /** Share of the interval before each symbol, of 2¹⁵. */
  readonly distribution: Uint32Array;
  untilUpdate: number;
  readonly #counts: Uint32Array;
  #total = 0;
  #cycle: number;

  constructor(symbols: number) {
    this.distribution = new Uint32Array(symbols);
    this.#counts = new Uint32Array(symbols).fill(1);
    this.#cycle = symbols;
    this.untilUpdate = 0;
    this.#update();
    this.#cycle = (symbols + 6) >> 1;
    this.untilUpdate = this.#cycle;
  }

  see(symbol: number): void {
    this.#counts[symbol]++;
    if (--this.untilUpdate === 0) this.#update();
  }

  #update(): void {
    const counts = this.#counts;
    this.#total += this.#cycle;
    if (this.#total > 1 << SYMBOL_SHIFT) {
      this.#total = 0;
      for (let k = 0; k < counts.length; k++) {
        counts[k] = (counts[k] + 1) >> 1;
        this.#total += counts[k];
      }
    }
    const scale = Math.floor(SCALE / this.#total);
    let sum = 0;
    for (let k = 0; k < counts.length; k++) {
      this.distribution[k] = Math.floor((scale * sum) / 2 ** (31 - SYMBOL_SHIFT));
      sum += counts[k];
    }
    this.#cycle = Math.min((counts.length + 6) << 3, (5 * this.#cycle) >> 2);
    this.untilUpdate = this.#cycle;
  }
}

/**
 * The adaptive range decoder of LASzip [Isenburg13] (after Said's FastAC). Past the end it reads zeros, so that it
 * always comes to an end; whoever uses it checks what it says.
 */
export class RangeDecoder {
  readonly #bytes: Uint8Array;
  #at: number;
  #value = 0;
  #length = 0xffff_ffff;

  constructor(bytes: Uint8Array, begin = 0) {
    this.#bytes = bytes;
    this.#at = begin;
    for (let i = 0; i < 4; i++) this.#value = this.#value * 256 + this.#next();
  }

  bit(model: BitModel): 0 | 1 {
    const split = model.probability * (this.#length >>> BIT_SHIFT);
    const bit = this.#value >= split ? 1 : 0;
    if (bit === 0) {
      this.#length = split;
      model.seeZero();
    } else {
      this.#value -= split;
      this.#length -= split;
    }
    this.#widen();
    if (--model.untilUpdate === 0) model.update();
    return bit;
  }

  symbol(model: SymbolModel): number {
    const { distribution } = model;
    let high = this.#length;
    const unit = this.#length >>> SYMBOL_SHIFT;
    let [low, symbol, end] = [0, 0, distribution.length];
    for (let middle = end >> 1; middle !== symbol; middle = (symbol + end) >> 1) {
      const place = unit * distribution[middle];
      if (place > this.#value) {
        end = middle;
        high = place;
      } else {
        symbol = middle;
        low = place;
      }
    }
    this.#value -= low;
    this.#length = high - low;
    this.#widen();
    model.see(symbol);
    return symbol;
  }

  /** A number of up to 32 bits, all values alike. */
  bits(count: number): number {
    if (count > 19) {
      const lower = this.bits(16);
      return this.bits(count - 16) * 2 ** 16 + lower;
    }
    this.#length >>>= count;
    const value = Math.floor(this.#value / this.#length);
    this.#value -= this.#length * value;
    this.#widen();
    return value;
  }

  #widen(): void {
    while (this.#length < LEAST_LENGTH) {
      this.#value = (this.#value * 256 + this.#next()) % 2 ** 32;
      this.#length = Math.max(1, this.#length) * 256;
    }
  }

  #next(): number {
    return this.#at < this.#bytes.length ? this.#bytes[this.#at++] : 0;
  }
}

const HIGH_BITS = 8;

/** A 32-bit number told as a correction of the one expected, by contexts [Isenburg13]. */
export class NumberDecoder {
  readonly #decoder: RangeDecoder;
  readonly #sizes: readonly SymbolModel[];
  readonly #smallest = new BitModel();
  readonly #corrections: readonly SymbolModel[];

  constructor(decoder: RangeDecoder, contexts: number) {
    this.#decoder = decoder;
    this.#sizes = Array.from({ length: contexts }, () => new SymbolModel(33));
    this.#corrections = Array.from({ length: 33 }, (_, k) => new SymbolModel(1 << Math.min(k, HIGH_BITS)));
  }

  /** @returns a whole number from 0 up to 2³² */
  next(expected: number, context: number): number {
    return (expected + this.#correction(context)) >>> 0;
  }

  #correction(context: number): number {
    const decoder = this.#decoder;
    const size = decoder.symbol(this.#sizes[context]);
    if (size === 0) return decoder.bit(this.#smallest);
    if (size === 32) return -(2 ** 31);
    let value = decoder.symbol(this.#corrections[size]);
    if (size > HIGH_BITS) {
      const low = size - HIGH_BITS;
      value = value * 2 ** low + decoder.bits(low);
    }
    return value >= 2 ** (size - 1) ? value + 1 : value - (2 ** size - 1);
  }
}
