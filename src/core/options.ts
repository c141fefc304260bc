import { parseDoors } from './doors.ts';
import { FloorPlanError } from './errors.ts';
import {
  type AutoNumberRow,
  type NumberRow,
  type Options,
  PARAM_NAMES,
  PARAMS,
  type ParamName,
  type ParamRow,
} from './params.ts';

/**
 * Completes and checks what a person gave: the preset's values, then theirs.
 *
 * @param given any subset of the parameters; `undefined` counts as not given
 * @param isSlice whether the scan is a ready slice, whose automatic preset is `paper`
 * @throws option/unknown, option/invalid
 */
export function resolveOptions(given: Partial<Options>, { isSlice = false } = {}): Options {
  for (const name of Object.keys(given)) {
    if (!Object.hasOwn(PARAMS, name)) throw unknownOption(name);
  }
  const preset = given.preset ?? PARAMS.preset.default;
  const resolved = preset === 'auto' ? (isSlice ? 'paper' : 'building') : preset;
  const pixelsPerMetre = given.pixelsPerMetre ?? PARAMS.pixelsPerMetre.default;
  const options: Record<string, unknown> = {};
  for (const name of PARAM_NAMES) {
    const value = given[name] ?? presetValue(PARAMS[name], resolved, pixelsPerMetre);
    checkValue(name, value);
    options[name] = value;
  }
  return { ...(options as Options), preset: resolved };
}

/** Reads a parameter written as text, as a flag or an attribute. @throws option/unknown, option/invalid */
export function parseParam(name: string, text: string): Partial<Options> {
  if (!Object.hasOwn(PARAMS, name)) throw unknownOption(name);
  const row: ParamRow = PARAMS[name as ParamName];
  const value = parseValue(row, text.trim());
  checkValue(name as ParamName, value);
  return { [name]: value };
}

function presetValue(row: ParamRow, preset: string, pixelsPerMetre: number): unknown {
  if (preset !== 'paper' || row.paper === undefined) return row.default;
  if (typeof row.paper !== 'object' || !('px' in row.paper)) return row.paper;
  return row.paper.px / pixelsPerMetre ** row.paper.power;
}

function parseValue(row: ParamRow, text: string): unknown {
  switch (row.kind) {
    case 'number':
      return text === '' ? Number.NaN : Number(text);
    case 'auto-number':
      return text === 'auto' ? 'auto' : text === '' ? Number.NaN : Number(text);
    case 'flag':
      return text === '' || text === 'true' ? true : text === 'false' ? false : text;
    case 'choice-list':
      return text.split(',').map((part) => part.trim());
    default:
      return text;
  }
}

function checkValue(name: ParamName, value: unknown): void {
  const row: ParamRow = PARAMS[name];
  // Of several doors it matters which one is wrong.
  if (row.kind === 'doors' && typeof value === 'string') parseDoors(value);
  const expected = expectation(row, value);
  if (expected === null) return;
  const found = Array.isArray(value) ? value.join(',') : String(value);
  throw new FloorPlanError('option/invalid', `${name}: expected ${expected}, found "${found}"`, {
    hint: `The default is ${String(row.default)}.`,
    detail: { option: name },
  });
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
  return `a ${isWhole(row) ? 'whole ' : ''}number from ${row.min} to ${row.max}`;
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
