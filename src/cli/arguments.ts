import { FloorPlanError } from '../core/errors.ts';
import { parseParam } from '../core/options.ts';
import { type GivenValues, kebabCase, PARAM_NAMES, PARAMS, type ParamName } from '../core/params.ts';
import {
  SIDECARS,
  WRITE_FORMAT_NAMES,
  WRITE_FORMATS,
  type WriteFormatName,
  zipOf,
} from '../write/formats.ts';
import type { WriteFormat } from '../write/plan-writer.ts';

/** What a person asked of the command. */
export interface Command {
  readonly inputs: readonly string[];
  readonly folder: string;
  /** The inputs are parts of one scan. */
  readonly isMerge: boolean;
  readonly formats: readonly string[];
  /** The formats were named, so each of them is wanted; else what can be written is. */
  readonly hasNamedFormats: boolean;
  readonly options: GivenValues;
  readonly task: 'run' | 'help' | 'version';
}

const PARAM_OF_FLAG = new Map<string, ParamName>(PARAM_NAMES.map((name) => [`--${kebabCase(name)}`, name]));

/**
 * Reads the words after the command's name. A flag's value follows it or stands behind `=`; a flag parameter needs none.
 *
 * @throws option/unknown, option/invalid
 */
export function parseArguments(words: readonly string[]): Command {
  const inputs: string[] = [];
  const options: GivenValues = {};
  let folder = '';
  let formats: readonly string[] = WRITE_FORMAT_NAMES.filter((name) => !isOnRequest(name));
  let [isMerge, hasNamedFormats] = [false, false];
  let task: Command['task'] = 'run';

  const queue = [...words];
  while (queue.length > 0) {
    const word = queue.shift()!;
    const [flag, inline] = splitFlag(word);
    const value = (): string => inline ?? nextValue(flag, queue);
    const param = PARAM_OF_FLAG.get(flag);
    if (param) {
      const needsValue = PARAMS[param].kind !== 'flag' || queue[0] === 'true' || queue[0] === 'false';
      Object.assign(options, parseParam(param, needsValue ? value() : (inline ?? '')));
    } else if (flag.startsWith('--no-') && isFlagParam(flag)) {
      Object.assign(options, parseParam(PARAM_OF_FLAG.get(`--${flag.slice(5)}`)!, 'false'));
    } else if (flag === '-o' || flag === '--out') folder = value();
    else if (flag === '--formats') [formats, hasNamedFormats] = [parseFormats(value()), true];
    else if (flag === '--merge') isMerge = true;
    else if (flag === '-h' || flag === '--help') task = 'help';
    else if (flag === '--version') task = 'version';
    // Looked for by whoever tells of errors: words that cannot be read are told of as JSON too.
    else if (flag === '--json') continue;
    else if (word.startsWith('-') && word !== '-') unknownFlag(flag);
    else inputs.push(word);
  }
  if (task === 'run') checkComplete(inputs, folder);
  return { inputs, folder, formats, hasNamedFormats, options, isMerge, task };
}

function splitFlag(word: string): [flag: string, inline: string | undefined] {
  const at = word.startsWith('--') ? word.indexOf('=') : -1;
  return at < 0 ? [word, undefined] : [word.slice(0, at), word.slice(at + 1)];
}

function isFlagParam(noFlag: string): boolean {
  const param = PARAM_OF_FLAG.get(`--${noFlag.slice(5)}`);
  return param !== undefined && PARAMS[param].kind === 'flag';
}

function parseFormats(text: string): readonly string[] {
  const names = text.split(',').map((name) => name.trim());
  for (const name of names) {
    if (name === 'report' || Object.hasOwn(WRITE_FORMATS, name)) continue;
    throw new FloorPlanError('option/invalid', `--formats: no format "${name}"`, {
      hint: `Formats are ${Object.keys(WRITE_FORMATS).join(', ')}.`,
    });
  }
  const wanted = names.filter((name) => name !== 'report') as WriteFormatName[];
  const all = [...new Set(wanted.flatMap((name) => [name, ...(SIDECARS[name] ?? [])]))];
  const others = all.filter((name) => name !== 'zip');
  // Beside others, a ZIP holds these.
  return all.map((name) => (name === 'zip' && others.length > 0 ? zipOf(others) : name));
}

function isOnRequest(name: WriteFormatName): boolean {
  const row: WriteFormat = WRITE_FORMATS[name];
  return row.isOnRequest ?? false;
}

function checkComplete(inputs: readonly string[], folder: string): void {
  const usage = 'grundriss INPUT… -o DIR; see grundriss --help.';
  if (inputs.length === 0) throw new FloorPlanError('option/invalid', 'No input was named.', { hint: usage });
  if (!folder) throw new FloorPlanError('option/invalid', 'No output folder was named.', { hint: usage });
}

/** A value may start with one dash, as negative numbers and `-x` do, but with two it is the next flag. */
function nextValue(flag: string, queue: string[]): string {
  const value = queue.shift();
  if (value !== undefined && !value.startsWith('--') && value !== '-o') return value;
  throw new FloorPlanError('option/invalid', `${flag}: expected a value, found ${value ?? 'the end'}`, {
    hint: 'See grundriss --help.',
  });
}

function unknownFlag(flag: string): never {
  throw new FloorPlanError('option/unknown', `${flag}: no such option`, { hint: 'See grundriss --help.' });
}
