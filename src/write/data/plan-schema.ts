import type { AutoNumberRow, NumberRow, ParamRow } from '../../core/param-rows.ts';
import { PARAM_NAMES, PARAMS } from '../../core/params.ts';
import { PLACE_LIMITS, PLAN_SHAPE, type Shape } from './plan-shape.ts';

type Schema = { readonly [key: string]: unknown };

/** A ring in plan.json. */
const RING: Schema = {
  description: 'Vertices x, y in metres, plan frame; open: the first is not repeated',
  type: 'array',
  minItems: 3,
  items: {
    type: 'array',
    minItems: 2,
    maxItems: 2,
    items: { type: 'number', minimum: PLACE_LIMITS.least, maximum: PLACE_LIMITS.most },
  },
};

/** Writes the JSON Schema of plan.json, which goes with the package as `grundriss/plan.schema.json`. */
export function writePlanSchema(): string {
  const schema = {
    $schema: 'https://json-schema.org/draft/2020-12/schema',
    $id: 'urn:grundriss:plan:1',
    title: 'Grundriss plan, version 1',
    description:
      'A floor plan found in a point cloud. Metres and radians, plan frame, where nothing else is said.',
    ...schemaOf(PLAN_SHAPE),
    $defs: { ring: RING },
  };
  return `${JSON.stringify(schema, null, 2)}\n`;
}

function schemaOf(shape: Shape): Schema {
  const description = shape.doc === undefined ? {} : { description: shape.doc };
  return { ...description, ...bareSchema(shape) };
}

function bareSchema(shape: Shape): Schema {
  switch (shape.kind) {
    case 'number': {
      const { isWhole, least, most, above } = shape;
      return limited({
        type: isWhole ? 'integer' : 'number',
        minimum: least,
        maximum: most,
        exclusiveMinimum: above,
      });
    }
    case 'text':
      return { type: 'string' };
    case 'choice':
      return shape.of.length === 1 ? { const: shape.of[0] } : { enum: shape.of };
    case 'list':
      return limited({
        type: 'array',
        minItems: shape.least || undefined,
        maxItems: shape.most,
        items: schemaOf(shape.of),
      });
    case 'ring':
      return { $ref: '#/$defs/ring' };
    case 'object': {
      const entries = Object.entries(shape.of);
      return {
        type: 'object',
        properties: Object.fromEntries(entries.map(([key, field]) => [key, schemaOf(field)])),
        required: entries.map(([key]) => key).filter((key) => !shape.mayLack.includes(key)),
        additionalProperties: false,
      };
    }
    case 'options': {
      const rows = PARAM_NAMES.map((name) => [name, paramSchema(PARAMS[name])]);
      return { type: 'object', properties: Object.fromEntries(rows), additionalProperties: false };
    }
  }
}

function paramSchema(row: ParamRow): Schema {
  return { description: row.doc, ...valueSchema(row) };
}

function valueSchema(row: ParamRow): Schema {
  switch (row.kind) {
    case 'number':
      return rangeSchema(row);
    case 'auto-number':
      return { anyOf: [{ const: 'auto' }, rangeSchema(row)] };
    case 'flag':
      return { type: 'boolean' };
    case 'choice':
      return { enum: row.choices };
    case 'choice-list':
      return { type: 'array', minItems: 1, items: { enum: row.choices } };
    default:
      return { type: 'string' };
  }
}

function rangeSchema({ min, max }: NumberRow | AutoNumberRow): Schema {
  return { type: 'number', minimum: min, maximum: max };
}

/** Without the limits that there are none of. */
function limited(schema: Schema): Schema {
  return Object.fromEntries(Object.entries(schema).filter(([, value]) => value !== undefined));
}
