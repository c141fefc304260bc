import { malformedE57 } from './e57-error.ts';
import type { XmlElement } from './xml.ts';

/** An element of an E57 file's XML section with its path, for messages ([E2807] §8). */
export class E57Node {
  readonly name: string;
  readonly #element: XmlElement;
  readonly #path: string;
  readonly #file: string;

  constructor(element: XmlElement, file: string, path = element.name) {
    this.name = element.name;
    this.#element = element;
    this.#path = path;
    this.#file = file;
  }

  get type(): string {
    return this.#element.attributes.get('type') ?? '';
  }

  get text(): string {
    return this.#element.text.trim();
  }

  get children(): E57Node[] {
    return this.#element.children.map(
      (child, index) => new E57Node(child, this.#file, `${this.#path}/${child.name}[${index}]`),
    );
  }

  child(name: string): E57Node | undefined {
    const element = this.#element.children.find((child) => child.name === name);
    return element && new E57Node(element, this.#file, `${this.#path}/${name}`);
  }

  /** The number the element holds; a scaled integer in its own unit; empty is 0. @throws input/malformed */
  number(): number {
    const value = this.#parse(this.text, 'a number');
    return this.type === 'ScaledInteger'
      ? value * this.attribute('scale', 1) + this.attribute('offset', 0)
      : value;
  }

  /** @throws input/malformed */
  attribute(name: string, missing: number): number {
    const text = this.#element.attributes.get(name);
    return text === undefined ? missing : this.#parse(text, `a number for ${name}`);
  }

  hasAttribute(name: string): boolean {
    return this.#element.attributes.has(name);
  }

  attributeText(name: string): string | undefined {
    return this.#element.attributes.get(name);
  }

  /** @throws input/malformed */
  integerAttribute(name: string, missing: bigint): bigint {
    const text = this.#element.attributes.get(name)?.trim();
    if (text === undefined) return missing;
    // An int64 has at most 19 digits.
    if (!/^[+-]?\d{1,19}$/.test(text)) throw this.malformed(`a whole number for ${name}`, text);
    return BigInt(text);
  }

  /** A place in the file or a count: whole, exact, not negative. @throws input/malformed */
  sizeAttribute(name: string): number {
    const size = Number(this.integerAttribute(name, -1n));
    if (size < 0 || !Number.isSafeInteger(size)) throw this.malformed(`${name} of 0 or more`, String(size));
    return size;
  }

  malformed(expected: string, found: string) {
    const shown = found.slice(0, 40);
    return malformedE57(
      this.#file,
      `expected ${expected} in ${this.#path} of the XML section, found "${shown}"`,
      {
        path: this.#path,
        text: shown,
      },
    );
  }

  #parse(text: string, expected: string): number {
    const value = Number(text);
    if (!Number.isFinite(value)) throw this.malformed(expected, text);
    return value;
  }
}
