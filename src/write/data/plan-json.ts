import { quoteText } from '../../core/cut-text.ts';
import { FloorPlanError } from '../../core/errors.ts';
import { resolveOptions } from '../../core/options.ts';
import type { Options } from '../../core/params.ts';
import type { FloorPlan, Polygon, Ring } from '../../core/types.ts';
import type { Product } from '../plan-writer.ts';
import { PLACE_LIMITS, PLAN_SHAPE, type PlanDocument, type Shape } from './plan-shape.ts';

type Json = null | boolean | number | string | readonly Json[] | { readonly [key: string]: Json };
type JsonObject = { readonly [key: string]: Json };

/** Values longer than this are cut where an error quotes them, characters. */
const QUOTED = 40;

/** Writes plan.json: the whole plan, rings as [[x, y], …] in metres, plan frame; {@link parsePlanJson} reads it back. */
export function writePlanJson({ plan }: Pick<Product, 'plan'>): string {
  const replace = (_key: string, value: unknown) =>
    value instanceof Float64Array
      ? Array.from({ length: value.length / 2 }, (_, i) => [...value.subarray(2 * i, 2 * i + 2)])
      : value;
  return `${JSON.stringify({ format: 'grundriss-plan', ...plan }, replace)}\n`;
}

/**
 * Reads what {@link writePlanJson} wrote; numbers come back bit for bit, but for −0, and properties in their order, so that
 * the plan is written again as the same bytes. What {@link PLAN_SHAPE} does not know is refused.
 *
 * @throws input/malformed naming the place, e.g. `storeys[0].walls[2].outline`
 * @throws option/unknown, option/invalid
 */
export function parsePlanJson(text: string): FloorPlan {
  const root = parseJson(text);
  checkFormat(root);
  const { format: _, ...plan } = readAs(PLAN_SHAPE, root, '') as PlanDocument;
  plan.storeys.forEach(({ index }, i) => {
    if (index !== i) throw malformed(`storeys[${i}].index`, `${i}`, index);
  });
  return plan;
}

/** Other versions are told of before all else that is other in them. */
function checkFormat(root: Json): void {
  const { format, version } = asObject(root, '');
  if (format === 'grundriss-plan' && version === 1) return;
  throw malformed('format', 'grundriss-plan, version 1', `${quoted(format)}, version ${quoted(version)}`);
}

function parseJson(text: string): Json {
  try {
    return JSON.parse(text) as Json;
  } catch (cause) {
    throw new FloorPlanError(
      'input/malformed',
      `plan.json: expected JSON, found ${(cause as Error).message}`,
      {
        hint: 'Give a plan.json as this program wrote it.',
        cause,
      },
    );
  }
}

function readAs(shape: Shape, value: Json | undefined, place: string): unknown {
  switch (shape.kind) {
    case 'number':
      return readNumber(shape, value, place);
    case 'text':
      if (typeof value === 'string') return value;
      throw malformed(place, 'a text', quoted(value));
    case 'choice':
      if (shape.of.includes(value as string)) return value;
      throw malformed(place, shape.of.length === 1 ? '' : 'one of ', quoted(value), shape.of.join(', '));
    case 'list': {
      const items = asList(value, place, shape.least, shape.most);
      return items.map((item, i) => readAs(shape.of, item, `${place}[${i}]`));
    }
    case 'ring':
      return readRing(value, place);
    case 'object':
      return readObject(shape, value, place);
    case 'options':
      return readOptions(asObject(value, place), place);
  }
}

/** Properties in the order in which they were written. */
function readObject(
  { of, mayLack }: Extract<Shape, { kind: 'object' }>,
  value: Json | undefined,
  place: string,
): object {
  const object = asObject(value, place);
  const at = (key: string) => (place === '' ? key : `${place}.${key}`);
  const entries = Object.entries(object).map(([key, item]): [string, unknown] => {
    if (!Object.hasOwn(of, key))
      throw malformed(place, `nothing but ${Object.keys(of).join(', ')}`, quoted(key));
    return [key, readAs(of[key], item, at(key))];
  });
  for (const key of Object.keys(of)) {
    if (!Object.hasOwn(object, key) && !mayLack.includes(key)) readAs(of[key], undefined, at(key));
  }
  const read = Object.fromEntries(entries);
  if (read.arcs !== undefined) checkArcs(read as unknown as Polygon, place);
  return read;
}

/** Options stand in a plan as they were resolved; those that its writer did not know have their defaults. */
function readOptions(given: JsonObject, place: string): Options {
  const options = resolveOptions(given as Partial<Options>);
  for (const [name, value] of Object.entries(given)) {
    const resolved = JSON.stringify(options[name as keyof Options]);
    if (JSON.stringify(value) !== resolved) throw malformed(`${place}.${name}`, resolved, quoted(value));
  }
  return options;
}

/** Arcs name rings and vertices that there are. */
function checkArcs({ outer, holes, arcs = [] }: Polygon, place: string): void {
  const rings = [outer, ...holes];
  arcs.forEach(({ ring, from, to }, i) => {
    const at = `${place}.arcs[${i}]`;
    checkIndex(ring, `${at}.ring`, rings.length);
    checkIndex(from, `${at}.from`, rings[ring].length / 2);
    checkIndex(to, `${at}.to`, rings[ring].length / 2);
  });
}

function checkIndex(index: number, place: string, count: number): void {
  if (index >= count) throw malformed(place, `a whole number below ${count}`, index);
}

function readRing(value: Json | undefined, place: string): Ring {
  const positions = asList(value, place, 3);
  const ring = new Float64Array(2 * positions.length);
  positions.forEach((position, i) => {
    const at = `${place}[${i}]`;
    const pair = asList(position, at, 2, 2);
    ring[2 * i] = readNumber(PLACE_LIMITS, pair[0], at);
    ring[2 * i + 1] = readNumber(PLACE_LIMITS, pair[1], at);
  });
  return ring;
}

function readNumber(
  limits: Omit<Extract<Shape, { kind: 'number' }>, 'kind'>,
  value: Json | undefined,
  place: string,
): number {
  const { isWhole, least = -Infinity, most = Infinity, above = -Infinity } = limits;
  // JSON knows no infinity, but 1e999 reads as one.
  const isNumber = typeof value === 'number' && Number.isFinite(value);
  const isRight = isNumber && value >= least && value <= most && value > above;
  if (isRight && (!isWhole || Number.isInteger(value))) return value;
  const range = [
    ...(limits.least === undefined ? [] : [`from ${least}`]),
    ...(limits.above === undefined ? [] : [`above ${above}`]),
    ...(limits.most === undefined ? [] : [`up to ${most}`]),
  ];
  throw malformed(
    place,
    [`a ${isWhole ? 'whole ' : ''}number`, ...(isNumber ? range : [])].join(' '),
    quoted(value),
  );
}

function asObject(value: Json | undefined, place: string): JsonObject {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as JsonObject;
  throw malformed(place, 'an object', quoted(value));
}

function asList(value: Json | undefined, place: string, least: number, most = Infinity): readonly Json[] {
  if (!Array.isArray(value)) throw malformed(place, 'a list', quoted(value));
  if (value.length >= least && value.length <= most) return value as readonly Json[];
  throw malformed(place, most === least ? `a list of ${least}` : `${least} or more in it`, value.length);
}

/** A value in short: a kind of thing, or itself. */
function quoted(value: Json | undefined): string {
  if (value === undefined) return 'nothing';
  if (typeof value === 'object' && value !== null) return Array.isArray(value) ? 'a list' : 'an object';
  return typeof value === 'string' ? quoteText(value, QUOTED) : String(value);
}

function malformed(place: string, expected: string, found: string | number, choices = ''): FloorPlanError {
  const where = place === '' ? 'plan.json' : `plan.json, ${place}`;
  return new FloorPlanError('input/malformed', `${where}: expected ${expected}${choices}, found ${found}`, {
    hint: 'Give a plan.json as this program wrote it.',
    detail: { place },
  });
}
