import type { Options } from '../../core/params.ts';
import type {
  FloorPlan,
  Frame,
  Furniture,
  Gap,
  Opening,
  Polygon,
  Ring,
  RingArc,
  Room,
  SecondaryBoundary,
  SourceFacts,
  Storey,
  Vec2,
  Vec3,
  Wall,
  Warning,
} from '../../core/types.ts';

/** What a place in plan.json may hold: its reader and its JSON Schema are made from this. */
export type Shape = Kind & {
  /** What the schema says of it. */
  readonly doc?: string;
};

type Kind =
  | {
      readonly kind: 'number';
      readonly isWhole?: true;
      readonly least?: number;
      readonly most?: number;
      readonly above?: number;
    }
  | { readonly kind: 'text' }
  | { readonly kind: 'choice'; readonly of: readonly (string | number | boolean)[] }
  | { readonly kind: 'list'; readonly of: Shape; readonly least: number; readonly most?: number }
  | { readonly kind: 'ring' }
  | {
      readonly kind: 'object';
      readonly of: Readonly<Record<string, Shape>>;
      readonly mayLack: readonly string[];
    }
  | { readonly kind: 'options' };

/** A shape of what becomes a T; the type exists for the compiler only. */
type Shaped<T> = Shape & { readonly type?: T };
type Lacking<T> = { readonly mayLack: Shaped<T> };
/** Every property of a type, so that none is forgotten. */
type Fields<T> = {
  readonly [K in keyof T]-?: Record<never, never> extends Pick<T, K>
    ? Lacking<Exclude<T[K], undefined>>
    : Shaped<T[K]>;
};

/** Farther from its origin no plan reaches, m: a place there keeps a thousandth of a millimetre, its products are numbers. */
const FARTHEST = 1e6;
/** No coordinate in a source's own unit is larger: µm on Earth. */
const LARGEST = 1e14;

const number = (limits: Omit<Extract<Shape, { kind: 'number' }>, 'kind'> = {}): Shaped<number> => ({
  kind: 'number',
  ...limits,
});
const text: Shaped<string> = { kind: 'text' };
const ring: Shaped<Ring> = { kind: 'ring' };
const choice = <const T extends string | number | boolean>(...of: readonly T[]): Shaped<T> => ({
  kind: 'choice',
  of,
});
const list = <T>(of: Shaped<T>, least = 0): Shaped<readonly T[]> => ({ kind: 'list', of, least });
const tuple = <T>(of: Shape, size: number): Shaped<T> => ({ kind: 'list', of, least: size, most: size });
const mayLack = <T>(shape: Shaped<T>): Lacking<T> => ({ mayLack: shape });

function object<T extends object>(fields: Fields<T>): Shaped<T> {
  const entries = Object.entries<Shape | Lacking<unknown>>(fields);
  const of = entries.map(([key, field]) => [key, 'kind' in field ? field : field.mayLack] as const);
  const lacking = entries.filter(([, field]) => !('kind' in field)).map(([key]) => key);
  return { kind: 'object', of: Object.fromEntries(of), mayLack: lacking };
}

export const PLACE_LIMITS = { least: -FARTHEST, most: FARTHEST } as const;

const said = <T>(doc: string, shape: Shaped<T>): Shaped<T> => ({ ...shape, doc });

const place = number(PLACE_LIMITS);
const pair = tuple<Vec2>(place, 2);
const length = number({ least: 0, most: FARTHEST });
const count = number({ isWhole: true, least: 0 });
const share = number({ least: 0, most: 1 });
const confidence = said('0 to 1', share);
const sourcePlace = tuple<Vec3>(number({ least: -LARGEST, most: LARGEST }), 3);

const arc = object<RingArc>({
  ring: said('0 for the outer ring, then the holes in order', count),
  from: said('Number of its first vertex', count),
  to: said('Number of its last vertex', count),
  centre: pair,
  radius: said('m', number({ above: 0, most: FARTHEST })),
});

const polygon = object<Polygon>({
  outer: said('Counter-clockwise', ring),
  holes: list(said('Clockwise', ring)),
  arcs: mayLack(said('Runs of vertices on circles: curved walls', list(arc))),
});

const secondary = object<SecondaryBoundary>({
  outline: polygon,
  operation: said('What it does to walls and slabs', choice('subtract', 'add', 'independent')),
  type: choice('column', 'shaft', 'other'),
  points: said('How many slice points show it', count),
});

const wall = object<Wall>({
  outline: polygon,
  thickness: said('m', length),
  confidence,
  isThicknessInferred: mayLack(said('No point shows its other face', choice(true))),
});

const room = object<Room>({ name: text, outline: polygon, height: said('m', length), confidence });

const opening = object<Opening>({
  type: choice('door', 'window', 'passage'),
  from: said('Jamb, on the axis of the wall', pair),
  to: said('The other jamb', pair),
  sill: said('Above the floor, m', place),
  head: said('Above the floor, m', place),
  confidence,
});

const gap = object<Gap>({ from: pair, to: pair, width: length, room: mayLack(text) });

const furniture = object<Furniture>({
  outline: polygon,
  height: said('Of its top above the floor, m', length),
  confidence,
  room: said('Name of the room it stands in', text),
});

const storey = object<Storey>({
  index: said('0 for the lowest', count),
  floor: said("z of the floor above the frame's origin, m", place),
  height: said('Of the walls, m', number({ above: 0, most: FARTHEST })),
  primary: said('Primary boundary: all rooms and the walls between them', list(polygon)),
  secondary: said('Columns, shafts and other structures', list(secondary)),
  walls: list(wall),
  rooms: list(room),
  openings: list(opening),
  gaps: said('Stretches of the outlines that no point supports', list(gap)),
  furniture: mayLack(list(furniture)),
});

const source = object<SourceFacts>({
  name: text,
  format: text,
  bytes: count,
  pointsRead: count,
  pointsDropped: said('With a NaN or infinite coordinate', count),
  pointsKept: count,
});

const frame = object<Frame>({
  origin: said("Source point at the plan's (0, 0, 0), source units", sourcePlace),
  planOrigin: said(
    'The same point seen from above, source units: plan in source units = planOrigin + plan / metresPerUnit',
    sourcePlace,
  ),
  rotation: said(
    'Row-major 3 × 3, source axes to plan axes: right, ahead, up',
    tuple<readonly number[]>(number({ least: -1.001, most: 1.001 }), 9),
  ),
  metresPerUnit: number({ above: 0, most: FARTHEST }),
  unit: said("The source's", choice('m', 'cm', 'mm', 'ft', 'us-ft', 'px', 'custom')),
  up: said('The source axis that is up', choice('x', 'y', 'z', '-x', '-y', '-z')),
  tilt: said(
    'Angle by which levelling turned the cloud, radians',
    number({ least: -Math.PI, most: Math.PI }),
  ),
  crs: mayLack(said('EPSG code or WKT', text)),
});

const warning = object<Warning>({ code: text, message: text, hint: text });

/** plan.json is a {@link FloorPlan} with a mark of its own first. */
export interface PlanDocument extends FloorPlan {
  readonly format: 'grundriss-plan';
}

export const PLAN_SHAPE: Shaped<PlanDocument> = object<PlanDocument>({
  format: choice('grundriss-plan'),
  version: choice(1),
  source,
  frame,
  options: { kind: 'options' } as Shaped<Options>,
  storeys: said('Lowest first', list(storey, 1)),
  warnings: list(warning),
});
