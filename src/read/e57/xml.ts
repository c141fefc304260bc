/** An element with the text directly in it; children in document order. */
export interface XmlElement {
  readonly name: string;
  readonly attributes: ReadonlyMap<string, string>;
  readonly children: readonly XmlElement[];
  readonly text: string;
}

/** What is wrong, and at which character. */
export class XmlError extends Error {
  readonly character: number;

  constructor(expected: string, character: number) {
    super(expected);
    this.character = character;
  }
}

interface OpenElement {
  readonly name: string;
  readonly attributes: Map<string, string>;
  readonly children: XmlElement[];
  text: string;
}

/** Elements within one another: E57 needs fewer than ten. */
const MOST_DEPTH = 64;
/** Five thousand scans; a text of nothing but tags would fill the memory. */
const MOST_TAGS = 1 << 20;
const NAME = /[^\s/>=<]+/y;
const ATTRIBUTE = /\s+([^\s=/><"']+)\s*=\s*(?:"([^"<]*)"|'([^'<]*)')/y;
const TAG_END = /\s*(\/?)>/y;
const ENTITIES: ReadonlyMap<string, string> = new Map(
  Object.entries({ lt: '<', gt: '>', amp: '&', quot: '"', apos: "'" }),
);
const LAST_CODE_POINT = 0x10ffff;

/**
 * The root element of an XML document; only what E57 uses: no document type, so no entities but XML's five and none
 * that grow. Complexity: O(characters).
 *
 * @throws XmlError
 */
export function parseXml(text: string): XmlElement {
  const document: OpenElement = { name: '', attributes: new Map(), children: [], text: '' };
  const open = [document];
  let at = 0;
  let tags = 0;
  while (at < text.length) {
    const top = open[open.length - 1];
    const begin = indexOrEnd(text, '<', at);
    if (++tags > MOST_TAGS) throw new XmlError(`at most ${MOST_TAGS} tags`, at);
    top.text += decodeEntities(text.slice(at, begin), at);
    if (begin === text.length) break;
    at = readMarkup(text, begin, open);
  }
  if (open.length > 1) throw new XmlError(`the end of <${open[open.length - 1].name}>`, text.length);
  const [root] = document.children;
  if (!root || document.children.length > 1 || document.text.trim() !== '')
    throw new XmlError('one root element', text.length);
  return root;
}

/** Reads what begins with `<` at `begin`, and returns where it ends. */
function readMarkup(text: string, begin: number, open: OpenElement[]): number {
  if (text.startsWith('<!--', begin)) return endOf(text, '-->', begin + 4);
  if (text.startsWith('<?', begin)) return endOf(text, '?>', begin + 2);
  if (text.startsWith('<![CDATA[', begin)) {
    const end = endOf(text, ']]>', begin + 9);
    open[open.length - 1].text += text.slice(begin + 9, end - 3);
    return end;
  }
  if (text.startsWith('<!', begin)) throw new XmlError('no document type', begin);
  return text[begin + 1] === '/' ? readEndTag(text, begin, open) : readTag(text, begin, open);
}

function readTag(text: string, begin: number, open: OpenElement[]): number {
  const name = match(NAME, text, begin + 1)?.[0];
  if (name === undefined) throw new XmlError('the name of an element', begin);
  if (open.length > MOST_DEPTH)
    throw new XmlError(`at most ${MOST_DEPTH} elements within one another`, begin);
  const element: OpenElement = { name, attributes: new Map(), children: [], text: '' };
  let at = begin + 1 + name.length;
  for (let found = match(ATTRIBUTE, text, at); found; found = match(ATTRIBUTE, text, at)) {
    element.attributes.set(found[1], decodeEntities(found[2] ?? found[3], at));
    at += found[0].length;
  }
  const end = match(TAG_END, text, at);
  if (!end) throw new XmlError(`an attribute or the end of the tag <${name}>`, at);
  open[open.length - 1].children.push(element);
  if (end[1] === '') open.push(element);
  return at + end[0].length;
}

function readEndTag(text: string, begin: number, open: OpenElement[]): number {
  const end = endOf(text, '>', begin);
  const { name } = open[open.length - 1];
  if (open.length === 1 || text.slice(begin + 2, end - 1).trimEnd() !== name)
    throw new XmlError(open.length === 1 ? 'no end tag' : `</${name}>`, begin);
  open.pop();
  return end;
}

function decodeEntities(text: string, at: number): string {
  if (!text.includes('&')) return text;
  return text.replace(/&([^;&]{0,8});?/g, (entity, name: string) => {
    const character = entity.endsWith(';') ? (ENTITIES.get(name) ?? numbered(name)) : undefined;
    if (character === undefined) throw new XmlError('one of the entities lt gt amp quot apos', at);
    return character;
  });
}

/** The character of `#233` or `#xe9`. */
function numbered(name: string): string | undefined {
  const digits = /^#(?:(\d+)|x([0-9a-f]+))$/i.exec(name);
  if (!digits) return undefined;
  const code = digits[1] === undefined ? Number.parseInt(digits[2], 16) : Number(digits[1]);
  return code <= LAST_CODE_POINT ? String.fromCodePoint(code) : undefined;
}

function match(pattern: RegExp, text: string, at: number): RegExpExecArray | null {
  pattern.lastIndex = at;
  return pattern.exec(text);
}

function indexOrEnd(text: string, mark: string, from: number): number {
  const at = text.indexOf(mark, from);
  return at < 0 ? text.length : at;
}

function endOf(text: string, mark: string, from: number): number {
  const at = text.indexOf(mark, from);
  if (at < 0) throw new XmlError(mark, text.length);
  return at + mark.length;
}
