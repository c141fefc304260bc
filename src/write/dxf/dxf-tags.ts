export type DxfTag = readonly [code: number, value: string | number];

/** Corners of a drawing in its own units, as written. */
export interface Extent {
  readonly min: readonly [string, string];
  readonly max: readonly [string, string];
}

/** What older readers take. */
const LONGEST_LINE = 255;

/** Characters of a piece of text of several lines, by the format. */
const LONGEST_PIECE = 250;
/** What must not be torn apart: an escaped letter, a control word, a caret and its blank, a letter. */
const TOKENS = /\\U\+[0-9A-F]{4}|\\.|\^ |./g;

/** Builds a DXF text tag by tag and hands out handles. */
export class DxfTags {
  readonly #lines: string[] = [];
  #lastHandle = 0;
  #seedLine = -1;

  /** A number of the drawing's own for an object, hexadecimal. */
  handle(): string {
    this.#lastHandle++;
    return this.#lastHandle.toString(16).toUpperCase();
  }

  add(...tags: readonly DxfTag[]): void {
    for (const [code, value] of tags) this.#lines.push(String(code).padStart(3), String(value));
  }

  /** Free text on one line. */
  addText(code: number, text: string): void {
    this.add([code, escaped(text)]);
  }

  /** Text of several lines, in as many pieces as it takes; the last has code 1. */
  addLongText(lines: readonly string[]): void {
    const pieces = [''];
    for (const token of lines.map(formatFree).join('\\P').match(TOKENS) ?? []) {
      if (pieces[pieces.length - 1].length + token.length > LONGEST_PIECE) pieces.push('');
      pieces[pieces.length - 1] += token;
    }
    pieces.forEach((piece, i) => {
      this.add([i === pieces.length - 1 ? 1 : 3, piece]);
    });
  }

  /** A comment, on as many lines as it takes. */
  addComment(text: string): void {
    const safe = escaped(text);
    for (let at = 0; at < safe.length; at += LONGEST_LINE) this.add([999, safe.slice(at, at + LONGEST_LINE)]);
  }

  section(name: string, write: () => void): void {
    this.add([0, 'SECTION'], [2, name]);
    write();
    this.add([0, 'ENDSEC']);
  }

  /** Opens an entity of the given owner on a layer; gives its handle. */
  entity(type: string, owner: string, layer: string): string {
    const handle = this.handle();
    this.add([0, type], [5, handle], [330, owner], [100, 'AcDbEntity'], [8, layer]);
    return handle;
  }

  /** The header's next free handle, filled in at the end. */
  addHandleSeed(): void {
    this.add([9, '$HANDSEED'], [5, '']);
    this.#seedLine = this.#lines.length - 1;
  }

  end(): string {
    this.add([0, 'EOF']);
    this.#lines[this.#seedLine] = this.handle();
    return `${this.#lines.join('\n')}\n`;
  }
}

/** A line of text of several lines, with what formats such text made harmless. */
function formatFree(line: string): string {
  const plain = line.replace(/[\\{}]/g, (sign) => `\\${sign}`);
  // Two per cent signs and a letter are a sign of the format's own, as a diameter's; an empty group parts them.
  return escaped(plain.replace(/%(?=%)/g, '%{}'));
}

/** Text beyond ASCII as \U+XXXX, with the caret and control characters made harmless. */
function escaped(text: string): string {
  let safe = '';
  for (let i = 0; i < text.length; i++) {
    const unit = text.charCodeAt(i);
    // What looks like such an escape already is to stay as it is.
    const isEscape = text[i - 1] === '\\' && text[i + 1] === '+';
    if (unit < 0x20 || unit === 0x7f) safe += ' ';
    else if (unit < 0x7f && !isEscape) safe += text[i];
    else safe += `\\U+${unit.toString(16).toUpperCase().padStart(4, '0')}`;
  }
  return safe.replaceAll('^', '^ ');
}
