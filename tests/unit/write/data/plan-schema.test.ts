import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import Ajv from 'ajv/dist/2020.js';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createStrokeTest } from '../../../../src/cli/canvas-stroke.ts';
import { FloorPlanError } from '../../../../src/core/errors.ts';
import { blobSource } from '../../../../src/read/bytes/blob-source.ts';
import { Session } from '../../../../src/session/session.ts';
import { parsePlanJson, writePlanJson } from '../../../../src/write/data/plan-json.ts';
import { writePlanSchema } from '../../../../src/write/data/plan-schema.ts';
import { schemaPath } from '../../../tables.ts';
import { planOf } from '../../solid/plans.ts';

const sample = join(import.meta.dirname, '../../../../public/samples/home.ply');
const validate = new Ajv({ strict: true, allErrors: false }).compile(JSON.parse(writePlanSchema()));

/** A plan with every property that a plan can have. */
function fullPlan() {
  const arcs = [{ ring: 0, from: 0, to: 2, centre: [0, 0] as const, radius: 4 }];
  const outer = Float64Array.of(0, 0, 4, 0, 4, 3);
  const outline = { outer, holes: [Float64Array.of(1, 1, 1, 2, 2, 1)], arcs };
  const storey = {
    primary: [outline],
    secondary: [{ outline, operation: 'add' as const, type: 'column' as const, points: 10 }],
    rooms: [{ name: '<script>"&]]> 🏠 غرفة', outline, height: 2.5, confidence: 1 }],
    walls: [{ outline, thickness: 0.3, confidence: 0.5, isThicknessInferred: true as const }],
    openings: [
      {
        type: 'window' as const,
        from: [0, 0] as const,
        to: [1, 0] as const,
        sill: 0.9,
        head: 2,
        confidence: 1,
      },
    ],
    gaps: [{ from: [0, 0] as const, to: [1, 0] as const, width: 1, room: 'Room 1' }],
    furniture: [{ outline, height: 0.7, confidence: 0.5, room: 'Room 1' }],
  };
  const plan = planOf({ storeys: [storey], frame: { crs: 'EPSG:25832' } });
  return { ...plan, warnings: [{ code: 'a/b', message: 'c', hint: '' }] };
}

const text = writePlanJson({ plan: fullPlan() });

/** What the reader says of a document: null where it takes it. */
function refusal(document: string): FloorPlanError | null {
  try {
    parsePlanJson(document);
    return null;
  } catch (error) {
    if (error instanceof FloorPlanError) return error;
    throw error;
  }
}

describe('the schema of plan.json', () => {
  it('is the one in the package; npm run tables writes it', () => {
    expect(JSON.parse(readFileSync(schemaPath, 'utf8'))).toEqual(JSON.parse(writePlanSchema()));
  });

  it('takes plans as they are written', () => {
    expect(validate(JSON.parse(text)), JSON.stringify(validate.errors)).toBe(true);
    expect(validate(JSON.parse(writePlanJson({ plan: planOf() })))).toBe(true);
  });

  it('takes the plan of a scan', async () => {
    const session = new Session({ strokeTest: createStrokeTest() });
    await session.load(blobSource(new Blob([readFileSync(sample)]), 'home.ply'), { furniture: true });
    const [{ content }] = await session.write('json');
    expect(validate(JSON.parse(content as string)), JSON.stringify(validate.errors)).toBe(true);
    expect(writePlanJson({ plan: parsePlanJson(content as string) })).toBe(content);
  });

  it('knows no property that plans do not have', () => {
    const { properties } = JSON.parse(writePlanSchema());
    const missing = missingOf(properties, JSON.parse(text), '');
    expect(missing).toEqual([]);
  });
});

/** Properties of a schema that a document with all of them lacks. */
function missingOf(
  properties: Record<string, { properties?: object; items?: object }>,
  value: object,
  at: string,
): string[] {
  return Object.entries(properties).flatMap(([key, schema]) => {
    const item = (value as Record<string, unknown>)[key];
    if (item === undefined) return [`${at}${key}`];
    const [inner, found] = Array.isArray(item) ? [schema.items, item[0]] : [schema, item];
    const deeper = (inner as { properties?: Record<string, object> } | undefined)?.properties;
    return deeper ? missingOf(deeper, found as object, `${at}${key}.`) : [];
  });
}

type Path = readonly string[];

function pathsOf(value: unknown, path: Path = []): Path[] {
  if (typeof value !== 'object' || value === null) return [path];
  return [path, ...Object.entries(value).flatMap(([key, item]) => pathsOf(item, [...path, key]))];
}

/** The document with another value, or none, at a place. */
function changed(path: Path, value: unknown): unknown {
  const document = JSON.parse(text);
  const parent = path.slice(0, -1).reduce((at, key) => at[key], document);
  if (value === undefined && !Array.isArray(parent)) delete parent[path.at(-1)!];
  else parent[path.at(-1)!] = value;
  return JSON.parse(JSON.stringify(document));
}

const paths = pathsOf(JSON.parse(text)).filter((path) => path.length > 0);

describe('a changed document', () => {
  const value = fc.oneof(
    fc.jsonValue(),
    fc.constantFrom(-1, 0.5, 2e6, 1e15, 'x', true, null, [], {}, [[1, 2]], '__proto__'),
  );

  it('is refused by the reader wherever the schema refuses it, and by no other error', () => {
    let refused = 0;
    fc.assert(
      fc.property(fc.constantFrom(...paths), value, fc.boolean(), (path, other, isGone) => {
        const document = changed(path, isGone ? undefined : other);
        const error = refusal(JSON.stringify(document));
        const isValid = validate(document);
        if (!isValid) {
          refused++;
          expect(error, JSON.stringify(validate.errors)).toBeInstanceOf(FloorPlanError);
        }
        // What a schema cannot say: arcs name vertices that there are, storeys are in order, options go together.
        if (isValid && error !== null) expect(`${error.code} ${error.message}`).toMatch(/arcs|index|option/);
      }),
      { numRuns: 600 },
    );
    expect(refused).toBeGreaterThan(200);
  });

  it('of any JSON at all is no crash', () => {
    fc.assert(
      fc.property(fc.json(), (document) => {
        expect(refusal(document)).toBeInstanceOf(FloorPlanError);
      }),
      { numRuns: 300 },
    );
  });

  it.each<[string, string, unknown]>([
    ['a property of nobody', 'storeys.0.walls.0.colour', 'red'],
    ['a number that is none', 'frame.metresPerUnit', null],
    ['a number below', 'storeys.0.height', 0],
    ['no storey', 'storeys', []],
    ['another kind of opening', 'storeys.0.openings.0.type', 'hatch'],
    ['an option of nobody', 'options.nonsense', 1],
    ['an option out of range', 'options.slabThickness', 99],
    ['an option as text', 'options.slabThickness', '10cm'],
    ['an option that is nothing', 'options.seed', null],
    ['a place in three', 'storeys.0.rooms.0.outline.outer.0', [0, 0, 0]],
  ])('with %s is refused by both', (_, place, other) => {
    const draft = changed(place.split('.'), other);
    expect(validate(draft)).toBe(false);
    expect(refusal(JSON.stringify(draft))).not.toBeNull();
  });
});
