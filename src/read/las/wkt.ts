/** A node of well-known text: `UNIT["metre",1]`. */
export interface WktNode {
  /** Upper case. */
  readonly keyword: string;
  /** Texts and numbers, in order. */
  readonly values: readonly (string | number)[];
  readonly children: readonly WktNode[];
}

/** Nodes nest a dozen deep in the largest coordinate system there is. */
const DEEPEST = 40;
const TOKEN = /\s*(?:([A-Za-z_]\w*)|"((?:[^"]|"")*)"|([-+]?\d[\d.]*(?:[eE][-+]?\d+)?)|([[\](),]))/y;

interface Token {
  readonly word?: string;
  readonly text?: string;
  readonly number?: string;
  readonly mark?: string;
}

/** Reads well-known text of either generation (OGC 01-009, ISO 19162); null where it is none. O(n). */
export function parseWkt(text: string): WktNode | null {
  const tokens = tokensOf(text);
  const reader = { tokens, at: 0 };
  return tokens && readNode(reader as Reader, 0);
}

interface Reader {
  readonly tokens: readonly Token[];
  at: number;
}

function tokensOf(text: string): Token[] | null {
  const tokens: Token[] = [];
  const end = text.trimEnd().length;
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < end) {
    const match = TOKEN.exec(text);
    if (!match) return null;
    const [, word, quoted, number, mark] = match;
    tokens.push({
      ...(word !== undefined && { word }),
      ...(quoted !== undefined && { text: quoted.replaceAll('""', '"') }),
      ...(number !== undefined && { number }),
      ...(mark !== undefined && { mark }),
    });
  }
  return tokens;
}

/** `KEYWORD[part, part, …]`, in either kind of brackets. */
function readNode(reader: Reader, depth: number): WktNode | null {
  const { tokens } = reader;
  const keyword = tokens[reader.at]?.word?.toUpperCase();
  const open = tokens[reader.at + 1]?.mark;
  if (keyword === undefined || (open !== '[' && open !== '(') || depth > DEEPEST) return null;
  reader.at += 2;
  const values: (string | number)[] = [];
  const children: WktNode[] = [];
  while (reader.at < tokens.length) {
    const { word, text, number } = tokens[reader.at];
    const isNode = word !== undefined && /[[(]/.test(tokens[reader.at + 1]?.mark ?? '');
    if (isNode) {
      const child = readNode(reader, depth + 1);
      if (!child) return null;
      children.push(child);
    } else {
      const value = text ?? word ?? (number === undefined ? undefined : Number(number));
      if (value === undefined) return null;
      values.push(value);
      reader.at++;
    }
    const mark = tokens[reader.at++]?.mark;
    if (mark === ']' || mark === ')') return { keyword, values, children };
    if (mark !== ',') return null;
  }
  return null;
}
