/**
 * A small, strict XML 1.0 parser: refuses what is not well-formed, and gives just enough of the DOM for three's
 * SVGLoader, so that the real loader runs under Node. No DTDs, no CDATA, no namespaces: our files have none.
 */

const ENTITIES: Readonly<Record<string, string>> = { amp: '&', lt: '<', gt: '>', quot: '"', apos: "'" };
const NAME = /[A-Za-z_:][\w:.-]*/y;

export class XmlElement {
  readonly nodeType = 1;
  readonly nodeName: string;
  readonly attributes = new Map<string, string>();
  readonly childNodes: XmlElement[] = [];
  /** The loader asks for inline styles: there are none. */
  readonly style: Readonly<Record<string, string>> = {};
  text = '';

  constructor(nodeName: string) {
    this.nodeName = nodeName;
  }

  hasAttribute(name: string): boolean {
    return this.attributes.has(name);
  }

  getAttribute(name: string): string | null {
    return this.attributes.get(name) ?? null;
  }

  /** All elements below of that name, in order of the document. */
  all(name: string): XmlElement[] {
    return this.childNodes.flatMap((child) => [
      ...(child.nodeName === name ? [child] : []),
      ...child.all(name),
    ]);
  }

  querySelectorAll(names: string): XmlElement[] {
    return names.split(',').flatMap((name) => this.all(name.trim()));
  }

  byId(id: string): XmlElement | undefined {
    if (this.getAttribute('id') === id) return this;
    for (const child of this.childNodes) {
      const found = child.byId(id);
      if (found !== undefined) return found;
    }
    return undefined;
  }
}

/** @throws Error saying what is not well-formed, and where */
export function parseXml(text: string): XmlElement {
  return new Parser(text).document();
}

class Parser {
  readonly #text: string;
  #at = 0;

  constructor(text: string) {
    this.#text = text;
    for (const letter of text) {
      const code = letter.codePointAt(0)!;
      const isControl = code < 0x20 && ![0x9, 0xa, 0xd].includes(code);
      const isSurrogate = code >= 0xd800 && code <= 0xdfff;
      if (isControl || isSurrogate || code === 0xfffe || code === 0xffff) {
        throw new Error(`forbidden character U+${code.toString(16)}`);
      }
    }
  }

  document(): XmlElement {
    if (this.#text.startsWith('<?xml ')) this.#at = this.#text.indexOf('?>') + 2;
    this.#space();
    const root = this.#element();
    this.#space();
    if (this.#at !== this.#text.length) this.#fail('content after the root');
    return root;
  }

  #element(): XmlElement {
    this.#expect('<');
    const element = new XmlElement(this.#name());
    for (;;) {
      const hadSpace = this.#space();
      if (this.#take('/>')) return element;
      if (this.#take('>')) break;
      if (!hadSpace) this.#fail('no space before an attribute');
      const name = this.#name();
      this.#expect('="');
      const end = this.#text.indexOf('"', this.#at);
      if (end < 0) this.#fail('an open attribute');
      if (element.attributes.has(name)) this.#fail(`the attribute ${name} twice`);
      element.attributes.set(name, this.#unescape(this.#text.slice(this.#at, end)));
      this.#at = end + 1;
    }
    this.#content(element);
    if (this.#name() !== element.nodeName) this.#fail(`an end tag other than ${element.nodeName}`);
    this.#expect('>');
    return element;
  }

  #content(element: XmlElement): void {
    for (;;) {
      const next = this.#text.indexOf('<', this.#at);
      if (next < 0) this.#fail(`${element.nodeName} without an end`);
      element.text += this.#unescape(this.#text.slice(this.#at, next));
      this.#at = next;
      if (this.#take('</')) return;
      element.childNodes.push(this.#element());
    }
  }

  #unescape(raw: string): string {
    if (raw.includes('<') || raw.includes(']]>')) this.#fail('a bare <');
    return raw.replace(/&([^;]*);?/g, (whole, name: string) => {
      const letter = whole.endsWith(';') ? ENTITIES[name] : undefined;
      return letter ?? this.#fail(`a bare & or an unknown entity: ${whole}`);
    });
  }

  #name(): string {
    NAME.lastIndex = this.#at;
    const found = NAME.exec(this.#text);
    if (found === null) return this.#fail('no name');
    this.#at = NAME.lastIndex;
    return found[0];
  }

  #space(): boolean {
    const start = this.#at;
    while (/\s/.test(this.#text[this.#at] ?? '')) this.#at++;
    return this.#at > start;
  }

  #take(token: string): boolean {
    if (!this.#text.startsWith(token, this.#at)) return false;
    this.#at += token.length;
    return true;
  }

  #expect(token: string): void {
    if (!this.#take(token)) this.#fail(`no ${token}`);
  }

  #fail(what: string): never {
    throw new Error(`not well-formed at ${this.#at}: ${what}: ${this.#text.slice(this.#at, this.#at + 40)}`);
  }
}
