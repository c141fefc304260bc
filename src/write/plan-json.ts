import { FloorPlanError } from '../core/errors.ts';
import { resolveOptions } from '../core/options.ts';
import type { FloorPlan, Polygon, Ring, RingArc, Storey, Vec2 } from '../core/types.ts';
import type { Product } from './plan-writer.ts';

type Json = null | boolean | number | string | readonly Json[] | { readonly [key: string]: Json };
type JsonObject = { readonly [key: string]: Json };

/** Writes plan.json: the whole plan, rings as [[x, y], …] in metres, plan frame; {@link parsePlanJson} reads it back. */
export function writePlanJson({ plan }: Product): string {
  const replace = (_key: string, value: unknown) =>
    value instanceof Float64Array
      ? Array.from({ length: value.length / 2 }, (_, i) => [...value.subarray(2 * i, 2 * i + 2)])
      : value;
  return `${JSON.stringify({ format: 'grundriss-plan', ...plan }, replace)}\n`;
}

/**
 * Reads what {@link writePlanJson} wrote; numbers come back bit for bit, but for −0.
 *
 * @throws input/malformed naming the place, e.g. `storeys[0].walls[2].outline`
 * @throws option/unknown, option/invalid
 */
export function parsePlanJson(text: string): FloorPlan {
  const root = asObject(parseJson(text), 'plan');
  if (root.format !== 'grundriss-plan' || root.version !== 1) {
    throw malformed('format', 'grundriss-plan, version 1', `${root.format}, version ${root.version}`);
  }
  const { frame, source } = root;
  checkFrame(asObject(frame, 'frame'));
  return {
    version: 1,
    source: asObject(source, 'source') as unknown as FloorPlan['source'],
    frame: frame as unknown as FloorPlan['frame'],
    options: resolveOptions(asObject(root.options, 'options') as Partial<FloorPlan['options']>),
    storeys: asList(root.storeys, 'storeys').map(readStorey),
    warnings: asList(root.warnings, 'warnings') as unknown as FloorPlan['warnings'],
  };
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

function readStorey(value: Json, index: number): Storey {
  const place = `storeys[${index}]`;
  const storey = asObject(value, place);
  for (const key of ['index', 'floor', 'height'] as const) asNumber(storey[key], `${place}.${key}`);
  const outlined = (key: 'secondary' | 'walls' | 'rooms' | 'furniture') =>
    asList(storey[key], `${place}.${key}`).map((item, i) => {
      const object = asObject(item, `${place}.${key}[${i}]`);
      return { ...object, outline: readPolygon(object.outline, `${place}.${key}[${i}].outline`) };
    });
  const stretches = (key: 'openings' | 'gaps', numbers: readonly string[]) =>
    asList(storey[key], `${place}.${key}`).map((item, i) => {
      const object = asObject(item, `${place}.${key}[${i}]`);
      readPair(object.from, `${place}.${key}[${i}].from`);
      readPair(object.to, `${place}.${key}[${i}].to`);
      for (const name of numbers) asNumber(object[name], `${place}.${key}[${i}].${name}`);
      return object;
    });
  return {
    ...storey,
    primary: asList(storey.primary, `${place}.primary`).map((item, i) =>
      readPolygon(item, `${place}.primary[${i}]`),
    ),
    secondary: outlined('secondary'),
    walls: outlined('walls'),
    rooms: outlined('rooms'),
    openings: stretches('openings', ['sill', 'head', 'confidence']),
    gaps: stretches('gaps', ['width']),
    ...(storey.furniture !== undefined && { furniture: outlined('furniture') }),
  } as unknown as Storey;
}

function checkFrame(frame: JsonObject): void {
  asNumber(frame.metresPerUnit, 'frame.metresPerUnit');
  for (const [key, length] of [
    ['origin', 3],
    ['planOrigin', 3],
    ['rotation', 9],
  ] as const) {
    const list = asList(frame[key], `frame.${key}`);
    if (list.length !== length) throw malformed(`frame.${key}`, `${length} numbers`, `${list.length}`);
    for (const value of list) asNumber(value, `frame.${key}`);
  }
}

function readPolygon(value: Json | undefined, place: string): Polygon {
  const { outer, holes, arcs } = asObject(value, place);
  const rings = {
    outer: readRing(outer, `${place}.outer`),
    holes: asList(holes, `${place}.holes`).map((hole, i) => readRing(hole, `${place}.holes[${i}]`)),
  };
  if (arcs === undefined) return rings;
  const read = asList(arcs, `${place}.arcs`).map((arc, i) => readArc(arc, `${place}.arcs[${i}]`, rings));
  return { ...rings, arcs: read };
}

function readArc(value: Json, place: string, { outer, holes }: Polygon): RingArc {
  const { ring, from, to, centre, radius } = asObject(value, place);
  const number = asIndex(ring, `${place}.ring`, 1 + holes.length);
  const count = [outer, ...holes][number].length / 2;
  return {
    ring: number,
    from: asIndex(from, `${place}.from`, count),
    to: asIndex(to, `${place}.to`, count),
    centre: readPair(centre, `${place}.centre`),
    radius: asNumber(radius, `${place}.radius`),
  };
}

function readRing(value: Json | undefined, place: string): Ring {
  const positions = asList(value, place);
  if (positions.length < 3) throw malformed(place, 'three positions or more', `${positions.length}`);
  return Float64Array.from(positions.flatMap((position, i) => readPair(position, `${place}[${i}]`)));
}

function readPair(value: Json | undefined, place: string): Vec2 {
  const pair = asList(value, place);
  if (pair.length !== 2) throw malformed(place, 'two numbers', `${pair.length}`);
  return [asNumber(pair[0], place), asNumber(pair[1], place)];
}

function asObject(value: Json | undefined, place: string): JsonObject {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as JsonObject;
  throw malformed(place, 'an object', typeOf(value));
}

function asList(value: Json | undefined, place: string): readonly Json[] {
  if (Array.isArray(value)) return value as readonly Json[];
  throw malformed(place, 'a list', typeOf(value));
}

function asNumber(value: Json | undefined, place: string): number {
  if (typeof value === 'number') return value;
  throw malformed(place, 'a number', typeOf(value));
}

/** A whole number below a count. */
function asIndex(value: Json | undefined, place: string, count: number): number {
  const index = asNumber(value, place);
  if (Number.isInteger(index) && index >= 0 && index < count) return index;
  throw malformed(place, `a whole number below ${count}`, `${index}`);
}

const typeOf = (value: Json | undefined): string => (value === null ? 'null' : typeof value);

function malformed(place: string, expected: string, found: string): FloorPlanError {
  return new FloorPlanError('input/malformed', `plan.json, ${place}: expected ${expected}, found ${found}`, {
    hint: 'Give a plan.json as this program wrote it.',
    detail: { place },
  });
}
