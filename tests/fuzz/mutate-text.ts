import type { Random } from '../../fixtures/simulator/random.ts';

/** Characters that a repetition makes at most. */
const LONGEST = 1_000_000;
const NUMBERS = [
  ...[
    'nan',
    'NaN',
    'inf',
    '-Infinity',
    '1e999',
    '-1e999',
    '1e-999',
    '-0',
    '0',
    '1',
    '-1',
    '1.5',
    '2',
    '',
    '""',
  ],
  ...['255', '256', '65536', '2147483647', '2147483648', '4294967295', '4294967296', '9007199254740993'],
  ...[
    '1e9',
    '1e12',
    '1e13',
    '1e38',
    '1e300',
    '0.1.2',
    '1,5',
    '0x10',
    '١',
    '99999999999999999999999',
    '+',
    '-',
    '.',
  ],
  ...[
    '1e',
    '1e+',
    '.5',
    '5.',
    '007',
    '1_000',
    '12abc',
    '-2147483649',
    '1.7976931348623157e308',
    '0.000000000000000001',
  ],
];
const MARKS = [
  '\0',
  '\n',
  '\r',
  '\r\n',
  ' ',
  '\t',
  ',',
  ';',
  '"',
  '<',
  '>',
  '/',
  '#',
  '\\',
  '{',
  '}',
  'é',
  '\u00ff',
];
/** A number that stands alone or in quotes, brackets and the like. */
const NUMBER = /[-+]?\d[\d.]*(?:[eE][-+]?\d+)?/g;
const WORD = /[A-Za-z_]\w*/g;
const LINE = /[^\r\n]*(?:\r\n|\r|\n|$)/g;

type TextEdit = (text: string, random: Random) => string;

/** One in so many counts is a count of its own: what stands in the first lines. */
const HEAD_CHARACTERS = 400;

const EDITS: readonly TextEdit[] = [
  (text, random) => replaceOne(text, NUMBER, random, () => random.pick(NUMBERS)),
  (text, random) => replaceOne(text, NUMBER, random, () => random.pick(NUMBERS)),
  // A count that lies, by one or by much.
  (text, random) =>
    replaceOne(text.slice(0, HEAD_CHARACTERS), /\b\d+\b/g, random, (word) => {
      const value = Number(word);
      return String(random.pick([value + 1, value - 1, 2 * value, 1000 * value, 0, 2 ** 31, 2 ** 52]));
    }) + text.slice(HEAD_CHARACTERS),
  (text, random) => replaceOne(text, WORD, random, () => pickWord(text, random)),
  (text, random) => replaceOne(text, /[^\w\s]/g, random, () => random.pick(MARKS)),
  (text, random) => replaceOne(text, LINE, random, () => ''),
  (text, random) => replaceOne(text, LINE, random, (line) => repeated(line, random.pick([2, 3, 50]))),
  (text, random) => replaceOne(text, LINE, random, (line) => line + random.pick(MARKS)),
  (text, random) => replaceOne(text, LINE, random, () => `${pickMatch(text, LINE, random)}`),
  (text, random) => replaceOne(text, /\S+/g, random, (word) => random.pick([`${word} ${word}`, ''])),
  (text, random) => replaceOne(text, /\S+/g, random, (word) => repeated(word, random.pick([2, 400]))),
  (text, random) => {
    const at = random.integer(0, text.length);
    return text.slice(0, at) + random.pick(MARKS) + text.slice(at);
  },
  (text, random) => text.slice(0, random.integer(0, text.length)),
  (text, random) =>
    random.chance(0.3) ? text.replaceAll('\n', random.pick(['\r', '\r\n', '\n\n', ' \n'])) : text,
];

/** Spoils a text: numbers, counts, words, marks and lines. */
export function mutateText(text: string, random: Random): string {
  let spoilt = text;
  for (let edits = random.pick([1, 1, 1, 2, 4]); edits > 0; edits--)
    spoilt = random.pick(EDITS)(spoilt, random);
  return spoilt;
}

function replaceOne(text: string, pattern: RegExp, random: Random, make: (found: string) => string): string {
  const found = [...text.matchAll(pattern)].filter(([match]) => match !== '');
  if (found.length === 0) return text;
  const { 0: match, index } = random.pick(found);
  return text.slice(0, index) + make(match) + text.slice(index + match.length);
}

function pickMatch(text: string, pattern: RegExp, random: Random): string {
  return random.pick([...text.matchAll(pattern)])?.[0] ?? '';
}

function pickWord(text: string, random: Random): string {
  return random.chance(0.8)
    ? pickMatch(text, WORD, random)
    : random.pick(['', 'x', 'nan', '__proto__', 'constructor']);
}

/** Spoils a value of JSON: numbers, indices, lists, keys, cycles of indices. */
export function mutateJson(json: unknown, random: Random): unknown {
  const copy = { root: structuredClone(json) };
  for (let edits = random.pick([1, 1, 2, 4]); edits > 0; edits--) spoilOne(copy, random);
  return copy.root ?? null;
}

type Holder = Record<string, unknown>;

function spoilOne(root: Holder, random: Random): void {
  const places: [holder: Holder, key: string][] = [];
  const collect = (holder: Holder) => {
    for (const key of Object.keys(holder)) {
      places.push([holder, key]);
      if (typeof holder[key] === 'object' && holder[key] !== null) collect(holder[key] as Holder);
    }
  };
  collect(root);
  // An edit before has taken the root itself away.
  if (places.length === 0) return;
  const [holder, key] = random.pick(places);
  const value = holder[key];
  const [other, otherKey] = random.pick(places);
  const die = random.next();
  if (die < 0.15) delete holder[key];
  else if (die < 0.3) holder[key] = structuredClone(other[otherKey]);
  else if (die < 0.4 && Array.isArray(value)) holder[key] = [...value, ...structuredClone(value)];
  else if (typeof value === 'number')
    holder[key] = random.pick([...JSON_NUMBERS, value + 1, value - 1, -value, 2 * value]);
  else if (typeof value === 'string')
    holder[key] = random.pick(['', 'SCALAR', 'VEC3', 'VEC4', 'MAT4', `${value}x`, 7]);
  else holder[key] = random.pick([null, [], {}, 0, 1, 'x', [0], [[0]], true]);
}

const JSON_NUMBERS = [
  0,
  1,
  2,
  3,
  4,
  5,
  6,
  -1,
  0.5,
  255,
  5120,
  5121,
  5123,
  5125,
  5126,
  65_536,
  2 ** 31,
  2 ** 53,
  1e300,
  null,
];

/** Several times the same, as long as that stays a text: mutations of mutations would grow past what a string may hold. */
function repeated(text: string, times: number): string {
  return text.repeat(Math.max(1, Math.min(times, Math.floor(LONGEST / text.length))));
}
