import { parseClasses } from './classes.ts';
import { CROP_WORDS, parseCrop } from './crop-box.ts';
import { quoteText } from './cut-text.ts';
import { formatDoors, parseDoors } from './doors.ts';
import { FloorPlanError } from './errors.ts';
import { type AutoNumberRow, defaultWords, type NumberRow, type ParamRow } from './param-rows.ts';
import { type GivenValues, type Options, PARAM_NAMES, PARAMS, type ParamName } from './params.ts';
import { readQuantity, unitWords } from './quantity.ts';
import { parseRoomNames, ROOM_NAME_WORDS } from './room-names.ts';
import { OUTLINE_STAGES } from './stages.ts';

/**
 * Completes and checks what a person gave: the preset's values, then theirs. Lengths and areas become metres and square
 * metres, the paper's pixels by `pixelsPerMetre`; sizes of doors too.
 *
 * @param given any subset of the parameters; `undefined` counts as not given
 * @param isSlice whether the scan is a ready slice, whose automatic preset is `paper`
 * @throws option/unknown, option/invalid
 */
export function resolveOptions(given: GivenValues, { isSlice = false } = {}): Options {
  for (const name of Object.keys(given)) {
    if (!Object.hasOwn(PARAMS, name)) throw unknownOption(name);
  }
  const preset = given.preset ?? PARAMS.preset.default;
  const resolved = preset === 'auto' ? (isSlice ? 'paper' : 'building') : preset;
  const pixelsPerMetre = given.pixelsPerMetre ?? PARAMS.pixelsPerMetre.default;
  checkValue('pixelsPerMetre', pixelsPerMetre, pixelsPerMetre);
  const options: Record<string, unknown> = {};
  for (const name of PARAM_NAMES) {
    const row: ParamRow = PARAMS[name];
    const found = given[name] ?? presetValue(row, resolved, pixelsPerMetre);
    const value = typeof found === 'string' ? inMetres(row, found, pixelsPerMetre) : found;
    if (given[name] === undefined) checkPresetValue(name, value, pixelsPerMetre);
    else checkValue(name, value, found);
    options[name] = value;
  }
  const planMethod =
    options.planMethod === 'auto' ? methodFor(given) : (options.planMethod as Options['planMethod']);
  return { ...(options as Options), preset: resolved, planMethod };
}

/** Who changes how the outline is made wants to see it; else rooms tell more. */
function methodFor(given: GivenValues): 'rooms' | 'outline' {
  return outlineParams(given).length > 0 ? 'outline' : 'rooms';
}

/** The parameters given that make another outline than their defaults would. */
export function outlineParams(given: GivenValues): ParamName[] {
  return PARAM_NAMES.filter(
    (name) =>
      OUTLINE_STAGES.includes(PARAMS[name].stage) &&
      (given[name] ?? PARAMS[name].default) !== PARAMS[name].default,
  );
}

/**
 * Reads a parameter written as text, as a flag or an attribute. A quantity in pixels stays text: {@link resolveOptions}
 * knows how large they are.
 *
 * @throws option/unknown, option/invalid
 */
export function parseParam(name: string, text: string): GivenValues {
  if (!Object.hasOwn(PARAMS, name)) throw unknownOption(name);
  const row: ParamRow = PARAMS[name as ParamName];
  const trimmed = text.trim();
  const value = parseText(row, trimmed);
  if (value === 'pixels') return { [name]: trimmed };
  checkValue(name as ParamName, value, trimmed);
  return { [name]: value };
}

/** Quantities with a unit as metres; other texts as they are. */
function inMetres(row: ParamRow, text: string, pixelsPerMetre: number): unknown {
  // Of several doors it matters which one is wrong.
  if (row.kind === 'doors') return formatDoors(parseDoors(text, pixelsPerMetre));
  const isQuantity = (row.kind === 'number' || row.kind === 'auto-number') && powerOf(row) !== 0;
  return isQuantity ? parseNumber(row, text, pixelsPerMetre) : text;
}

function presetValue(row: ParamRow, preset: string, pixelsPerMetre: number): unknown {
  if (preset !== 'paper' || row.paper === undefined) return row.default;
  if (typeof row.paper !== 'object' || !('px' in row.paper)) return row.paper;
  return row.paper.px / pixelsPerMetre ** row.paper.power;
}

function parseText(row: ParamRow, text: string): unknown {
  switch (row.kind) {
    case 'number':
    case 'auto-number':
      return parseNumber(row, text, null);
    case 'flag':
      return text === '' || text === 'true' ? true : text === 'false' ? false : text;
    case 'choice-list':
      return text.split(',').map((part) => part.trim());
    case 'doors':
      return /px/i.test(text) ? 'pixels' : formatDoors(parseDoors(text));
    default:
      return text;
  }
}

/** `auto`, a number, or a quantity with its unit. */
function parseNumber(
  row: NumberRow | AutoNumberRow,
  text: string,
  pixelsPerMetre: number | null,
): number | 'auto' | 'pixels' {
  if (row.kind === 'auto-number' && text === 'auto') return 'auto';
  const power = powerOf(row);
  if (power !== 0) return readQuantity(text, power, pixelsPerMetre);
  return text === '' ? Number.NaN : Number(text);
}

/** 1 for lengths, 2 for areas, 0 for plain numbers. */
function powerOf({ unit }: NumberRow | AutoNumberRow): 0 | 1 | 2 {
  return unit === 'm' ? 1 : unit === 'm²' ? 2 : 0;
}

/** @param found what the person gave, for the message */
function checkValue(name: ParamName, value: unknown, found: unknown): void {
  const row: ParamRow = PARAMS[name];
  if (row.kind === 'classes' && typeof value === 'string') parseClasses(value);
  if (row.kind === 'crop' && typeof value === 'string') parseCrop(value);
  if (row.kind === 'room-names' && typeof value === 'string') parseRoomNames(value);
  const expected = expectation(row, value);
  if (expected === null) return;
  const words = Array.isArray(found) ? found.join(',') : String(found);
  throw new FloorPlanError('option/invalid', `${name}: expected ${expected}, found ${quoteText(words)}`, {
    hint: `The default is ${defaultWords(row)}.`,
    detail: { option: name },
  });
}

/** The paper's sizes are pixels: `pixelsPerMetre` may make them larger or smaller than any a person may give. */
function checkPresetValue(name: ParamName, value: unknown, pixelsPerMetre: number): void {
  const expected = expectation(PARAMS[name], value);
  if (expected === null) return;
  throw new FloorPlanError(
    'option/invalid',
    `pixelsPerMetre: expected ${name} of the paper to be ${expected}, found ${String(value)} at ${pixelsPerMetre} px/m`,
    { hint: `Set ${name} too, or another pixelsPerMetre.`, detail: { option: 'pixelsPerMetre' } },
  );
}

/** What the row allows, or null when `value` is allowed. */
function expectation(row: ParamRow, value: unknown): string | null {
  switch (row.kind) {
    case 'auto-number':
      if (value === 'auto') return null;
      return inRange(row, value) ? null : `auto or ${rangeOf(row)}`;
    case 'number':
      return inRange(row, value) ? null : rangeOf(row);
    case 'flag':
      return typeof value === 'boolean' ? null : 'true or false';
    case 'choice':
      return row.choices.includes(value as string) ? null : `one of ${row.choices.join(', ')}`;
    case 'choice-list': {
      const isList = Array.isArray(value) && value.length > 0;
      return isList && value.every((v) => row.choices.includes(v))
        ? null
        : `a list of ${row.choices.join(', ')}`;
    }
    case 'level':
      return isLevelChoice(value) ? null : 'auto, 0, 1, 2 or low:high in metres';
    case 'doors':
      return typeof value === 'string' ? null : 'none, gaps or x,y,width[,height];…';
    case 'classes':
      return typeof value === 'string' ? null : 'all or class codes: 2,6';
    case 'crop':
      return typeof value === 'string' ? null : CROP_WORDS;
    case 'room-names':
      return typeof value === 'string' ? null : `none or ${ROOM_NAME_WORDS};…`;
    case 'text':
      return typeof value === 'string' && value.length <= row.longest
        ? null
        : `text of at most ${row.longest} letters`;
  }
}

function inRange(row: NumberRow | AutoNumberRow, value: unknown): boolean {
  return (
    typeof value === 'number' &&
    value >= row.min &&
    value <= row.max &&
    (!isWhole(row) || Number.isInteger(value))
  );
}

function rangeOf(row: NumberRow | AutoNumberRow): string {
  const range = `a ${isWhole(row) ? 'whole ' : ''}number from ${row.min} to ${row.max}`;
  const power = powerOf(row);
  return power === 0 ? range : `${range} ${row.unit}, or with a unit (${unitWords(power)})`;
}

function isWhole({ step, unit }: NumberRow | AutoNumberRow): boolean {
  return step % 1 === 0 && unit !== 'px/m';
}

function isLevelChoice(value: unknown): boolean {
  if (typeof value !== 'string') return false;
  if (['auto', '0', '1', '2'].includes(value)) return true;
  const parts = value.split(':').map((part) => (part.trim() === '' ? Number.NaN : Number(part)));
  return parts.length === 2 && parts.every(Number.isFinite) && parts[0] < parts[1];
}

function unknownOption(name: string): FloorPlanError {
  return new FloorPlanError('option/unknown', `${name}: no such option`, {
    hint: `Options are ${PARAM_NAMES.join(', ')}.`,
    detail: { option: name },
  });
}
