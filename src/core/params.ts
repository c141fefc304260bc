import type { AreaText, LengthText } from './quantity.ts';
import type { StageName } from './stages.ts';

/** A length or area in the paper's canvas pixels; `pixelsPerMetre` turns it into metres or square metres. */
export interface Pixels {
  readonly px: number;
  readonly power: 1 | 2;
}

interface RowFacts<T> {
  readonly default: T;
  /** Value under the preset `paper`, where it differs. */
  readonly paper?: T | Pixels;
  readonly stage: StageName;
  readonly label: string;
  readonly doc: string;
  /** Paper section or "ours". */
  readonly source: string;
  /** Shown only when a person asks for all parameters. */
  readonly advanced?: boolean;
}

export interface NumberRow extends RowFacts<number> {
  readonly kind: 'number';
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly unit: '' | 'm' | 'm²' | 'px/m' | 'points';
}
/** A number the pipeline works out by itself unless a person sets it. */
export interface AutoNumberRow extends RowFacts<number | 'auto'> {
  readonly kind: 'auto-number';
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly unit: NumberRow['unit'];
}
export interface FlagRow extends RowFacts<boolean> {
  readonly kind: 'flag';
}
export interface ChoiceRow<C extends string = string> extends RowFacts<C> {
  readonly kind: 'choice';
  readonly choices: readonly C[];
}
/** A comma-separated list of choices; the last one counts for all that follow. */
export interface ChoiceListRow<C extends string = string> extends RowFacts<readonly C[]> {
  readonly kind: 'choice-list';
  readonly choices: readonly C[];
}
/** `auto`, one of the three levels, or a height band `low:high` in metres above the floor. */
export interface LevelRow extends RowFacts<LevelChoice> {
  readonly kind: 'level';
}
/** `none`, `gaps`, or doors `x,y,width[,height]` joined by semicolons; `parseDoors` reads it. */
export interface DoorsRow extends RowFacts<string> {
  readonly kind: 'doors';
}
/** `none`, or a box `x0,y0,x1,y1[,z0,z1]` in source units and coordinates; `parseCrop` reads it. */
export interface CropRow extends RowFacts<string> {
  readonly kind: 'crop';
}
export type LevelChoice = 'auto' | '0' | '1' | '2' | `${number}:${number}`;

export type ParamRow =
  | NumberRow
  | AutoNumberRow
  | FlagRow
  | ChoiceRow
  | ChoiceListRow
  | LevelRow
  | DoorsRow
  | CropRow;

const px = (value: number): Pixels => ({ px: value, power: 1 });
const px2 = (value: number): Pixels => ({ px: value, power: 2 });
type In<U> = { readonly unit: U };
const number = <U extends NumberRow['unit']>(row: Omit<NumberRow, 'kind'> & In<U>): NumberRow & In<U> => ({
  kind: 'number',
  ...row,
});
const autoNumber = <U extends NumberRow['unit']>(
  row: Omit<AutoNumberRow, 'kind'> & In<U>,
): AutoNumberRow & In<U> => ({ kind: 'auto-number', ...row });
const flag = (row: Omit<FlagRow, 'kind'>): FlagRow => ({ kind: 'flag', ...row });
const choice = <const C extends string>(
  choices: readonly C[],
  row: Omit<ChoiceRow<C>, 'kind' | 'choices'>,
): ChoiceRow<C> => ({ kind: 'choice', choices, ...row });
const choiceList = <const C extends string>(
  choices: readonly C[],
  row: Omit<ChoiceListRow<C>, 'kind' | 'choices'>,
): ChoiceListRow<C> => ({ kind: 'choice-list', choices, ...row });
const level = (row: Omit<LevelRow, 'kind'>): LevelRow => ({ kind: 'level', ...row });
const doors = (row: Omit<DoorsRow, 'kind'>): DoorsRow => ({ kind: 'doors', ...row });
const crop = (row: Omit<CropRow, 'kind'>): CropRow => ({ kind: 'crop', ...row });

/**
 * Every number a person may set: options, ranges, controls, attributes, flags and docs are made from this table,
 * and a changed value runs the pipeline again from its stage. Lengths in metres.
 */
export const PARAMS = {
  preset: choice(['auto', 'building', 'paper'], {
    default: 'auto',
    stage: 'read',
    label: 'Preset',
    doc: "Start values: building for 3D scans, paper for ready slices (the paper's own numbers); auto picks between them.",
    source: 'ours',
  }),
  resolution: number({
    default: 0.01,
    min: 0.001,
    max: 0.5,
    step: 0.001,
    unit: 'm',
    stage: 'read',
    label: 'Working resolution',
    doc: 'Uniform down-sampling: points closer together than about this are thinned to one while reading.',
    source: 'ours',
  }),
  pointBudget: number({
    default: 4_000_000,
    min: 1_000,
    max: 50_000_000,
    step: 1_000,
    unit: 'points',
    stage: 'read',
    label: 'Point budget',
    doc: 'At most this many points are kept; past it the thinning coarsens.',
    source: 'ours',
    advanced: true,
  }),
  unit: choice(['auto', 'm', 'cm', 'mm', 'ft', 'us-ft', 'px'], {
    default: 'auto',
    stage: 'read',
    label: 'Unit',
    doc: 'Unit of the source coordinates; auto takes it from the file, else judges it from storey height and extent.',
    source: 'ours',
  }),
  metresPerUnit: autoNumber({
    default: 'auto',
    min: 1e-6,
    max: 10_000,
    step: 1e-6,
    unit: 'm',
    stage: 'read',
    label: 'Scale: length of one unit',
    doc: 'True length of one source unit, for scans without a scale, as photogrammetry makes them: a known distance over the same distance in source units. It takes the place of the unit; auto goes by the unit.',
    source: 'ours',
  }),
  pixelsPerMetre: number({
    default: 100,
    min: 1,
    max: 10_000,
    step: 1,
    unit: 'px/m',
    stage: 'read',
    label: 'Pixels per metre',
    doc: "Scale between the paper's canvas pixels and metres.",
    source: '[Stojanovic19] §4',
    advanced: true,
  }),
  up: choice(['auto', 'x', 'y', 'z', '-x', '-y', '-z'], {
    default: 'auto',
    stage: 'frame',
    label: 'Up axis',
    doc: 'Source axis that points up; auto finds it from floor and ceiling.',
    source: '[Stojanovic19] §3',
  }),
  levelling: flag({
    default: true,
    stage: 'frame',
    label: 'Level the scan',
    doc: 'A scan tilted by a few degrees is turned upright by its floor plane.',
    source: 'ours',
    advanced: true,
  }),
  crop: crop({
    default: 'none',
    stage: 'crop',
    label: 'Crop box',
    doc: 'Only the points in this box are used: x0,y0,x1,y1, seen from above as in plan.geojson, and where heights count ,z0,z1; all in source units and coordinates.',
    source: 'ours',
  }),
  outlierNeighbours: number({
    default: 8,
    min: 2,
    max: 64,
    step: 1,
    unit: '',
    stage: 'outliers',
    label: 'Outlier neighbours',
    doc: 'Neighbours whose mean distance decides whether a point is an outlier.',
    source: '[Stojanovic19] §3',
    advanced: true,
  }),
  outlierDeviations: number({
    default: 3,
    min: 0,
    max: 20,
    step: 0.1,
    unit: '',
    stage: 'outliers',
    label: 'Outlier deviations',
    doc: 'A point is an outlier when that distance is this many standard deviations above the mean; 0 keeps all points.',
    source: '[Stojanovic19] §3',
  }),
  level: level({
    default: 'auto',
    stage: 'level',
    label: 'Level',
    doc: 'Height level the plan is made from: auto, 0, 1, 2, or low:high in metres above the floor.',
    source: '[Stojanovic19] §3',
  }),
  levelRule: choice(['density', 'count'], {
    default: 'density',
    paper: 'count',
    stage: 'level',
    label: 'Level rule',
    doc: 'Auto takes the level with the most points per area of its bounding box, or with the most points.',
    source: '[Stojanovic19] §3',
  }),
  keepFloorAndCeiling: flag({
    default: false,
    stage: 'level',
    label: 'Keep floor and ceiling',
    doc: 'Leave the points of the floor and ceiling planes in the levels.',
    source: '[Stojanovic19] §3.1',
    advanced: true,
  }),
  wallReach: number({
    default: 0.6,
    paper: 0,
    min: 0,
    max: 1,
    step: 0.05,
    unit: '',
    stage: 'slice',
    label: 'Wall reach',
    doc: 'Points count as wall when something stands over them in this share of the height from the level to the ceiling; keeps window reveals and furniture out and closes windows by their lintels; 0 takes the level as it is.',
    source: 'ours',
  }),
  samplesPer50M2: number({
    default: 50_000,
    min: 100,
    max: 5_000_000,
    step: 100,
    unit: 'points',
    stage: 'slice',
    label: 'Samples per 50 m²',
    doc: 'Uniform down-sampling of the slice: points kept per 50 m² of its bounding box.',
    source: '[Stojanovic19] §4',
  }),
  seed: number({
    default: 1,
    min: 0,
    max: 4_294_967_295,
    step: 1,
    unit: '',
    stage: 'slice',
    label: 'Seed',
    doc: 'Start of every random choice; equal seeds give equal plans.',
    source: 'ours',
    advanced: true,
  }),
  boundary: choice(['gift-opening', 'convex', 'alpha-shape', 'concaveman'], {
    default: 'gift-opening',
    stage: 'boundary',
    label: 'Outline method',
    doc: 'How the primary boundary is found.',
    source: '[Stojanovic19] §3',
  }),
  openingLength: autoNumber({
    default: 'auto',
    min: 0.001,
    max: 100,
    step: 0.01,
    unit: 'm',
    stage: 'boundary',
    label: 'Opening length',
    doc: 'Gift opening opens hull edges longer than this; auto takes a multiple of the mean point spacing.',
    source: '[Rosén14] §4',
  }),
  bridgeGap: number({
    default: 3.5,
    min: 0,
    max: 20,
    step: 0.1,
    unit: 'm',
    stage: 'boundary',
    label: 'Bridge gaps up to',
    doc: 'Gaps in a wall up to this width are bridged when the outline would fall through them into the room; 0 never bridges.',
    source: 'ours',
  }),
  alpha: autoNumber({
    default: 'auto',
    paper: px(150),
    min: 0.001,
    max: 1000,
    step: 0.01,
    unit: 'm',
    stage: 'boundary',
    label: 'Alpha',
    doc: 'α-shape: largest circumradius of a Delaunay triangle inside the shape; auto takes a multiple of the mean spacing.',
    source: '[Stojanovic19] §4',
    advanced: true,
  }),
  concavity: number({
    default: 2,
    min: 1,
    max: 100,
    step: 0.1,
    unit: '',
    stage: 'boundary',
    label: 'Concavity',
    doc: 'Concaveman: relative concavity, 1 follows every dent.',
    source: '[Park12]',
    advanced: true,
  }),
  radialPass: flag({
    default: true,
    stage: 'regularise',
    label: 'Radial distance pass',
    doc: 'Drop vertices closer than ε to the one before.',
    source: '[Stojanovic19] §3',
  }),
  douglasPeuckerPass: flag({
    default: true,
    stage: 'regularise',
    label: 'Douglas-Peucker pass',
    doc: 'Drop vertices closer than ε to the line between those kept.',
    source: '[Stojanovic19] §3',
  }),
  visvalingamPass: flag({
    default: true,
    stage: 'regularise',
    label: 'Visvalingam pass',
    doc: 'Drop vertices whose triangle with their neighbours is smaller than the area ε.',
    source: '[Stojanovic19] §3',
  }),
  cornerPass: flag({
    default: true,
    paper: false,
    stage: 'regularise',
    label: 'Corner pass',
    doc: 'Fit a line to the points of each edge and let neighbouring lines meet: sharp corners, without the outer noise.',
    source: 'ours',
  }),
  epsilon: autoNumber({
    default: 'auto',
    paper: px(2.4),
    min: 0,
    max: 10,
    step: 0.001,
    unit: 'm',
    stage: 'regularise',
    label: 'Epsilon',
    doc: 'Tolerance of the radial distance and Douglas-Peucker passes; auto takes a multiple of the mean spacing.',
    source: '[Stojanovic19] §4, §5',
  }),
  visvalingamEpsilon: autoNumber({
    default: 'auto',
    paper: px2(0.2),
    min: 0,
    max: 10,
    step: 0.0001,
    unit: 'm²',
    stage: 'regularise',
    label: 'Visvalingam epsilon',
    doc: 'Area tolerance of the Visvalingam pass; auto takes ε².',
    source: '[Stojanovic19] §4',
    advanced: true,
  }),
  secondaryCount: autoNumber({
    default: 'auto',
    paper: 0,
    min: 0,
    max: 16,
    step: 1,
    unit: '',
    stage: 'secondary',
    label: 'Secondary boundaries',
    doc: 'How many columns, shafts or cubicles stand inside the outline; the paper method runs k-means with one cluster more. auto proposes: robust takes what is surely hollow and no piece of wall, paper the number of clusters with the best silhouette, less one.',
    source: '[Stojanovic19] §3.1',
  }),
  secondaryMethod: choice(['robust', 'paper'], {
    default: 'robust',
    paper: 'paper',
    stage: 'secondary',
    label: 'Secondary method',
    doc: 'robust outlines point groups detached from the walls by their outer face; paper is k-means with the stroke filter, which keeps the innermost points.',
    source: '[Stojanovic19] §3.1',
  }),
  secondaryCluster: autoNumber({
    default: 'auto',
    min: 0,
    max: 16,
    step: 1,
    unit: '',
    stage: 'secondary',
    label: 'Structure cluster',
    doc: 'Paper method: the cluster, numbered from left to right from 0, that is taken for the first structure; auto takes the one with the most points.',
    source: '[Stojanovic19] §3.1',
    advanced: true,
  }),
  secondaryOperation: choiceList(['subtract', 'add', 'independent'], {
    default: ['subtract'],
    stage: 'secondary',
    label: 'Secondary operation',
    doc: 'What each secondary boundary does to the model, in order; the last counts for all that follow.',
    source: '[Stojanovic19] §3.2',
  }),
  secondarySample: number({
    default: 0.75,
    min: 0.05,
    max: 1,
    step: 0.05,
    unit: '',
    stage: 'secondary',
    label: 'Secondary sample',
    doc: "Share of a cluster's points the average distance is taken from.",
    source: '[Stojanovic19] §3.1',
    advanced: true,
  }),
  strokeWidth: number({
    default: 0.1,
    paper: px(10),
    min: 0.001,
    max: 5,
    step: 0.001,
    unit: 'm',
    stage: 'secondary',
    label: 'Stroke width',
    doc: 'Points within a stroke this wide along the boundary are dropped to leave the innermost ones.',
    source: '[Stojanovic19] §3.1',
    advanced: true,
  }),
  secondaryEpsilon: number({
    default: 0.05,
    paper: px(10),
    min: 0,
    max: 5,
    step: 0.001,
    unit: 'm',
    stage: 'secondary',
    label: 'Secondary epsilon',
    doc: 'Tolerance of the passes on secondary boundaries (5 to 10 px in the paper).',
    source: '[Stojanovic19] §4',
    advanced: true,
  }),
  secondaryRounds: number({
    default: 1,
    min: 1,
    max: 10,
    step: 1,
    unit: '',
    stage: 'secondary',
    label: 'Refinement rounds',
    doc: 'How often the paper method runs, each time inside the boundary it found before.',
    source: '[Stojanovic19] §3.1',
    advanced: true,
  }),
  wallThickness: number({
    default: 0.2,
    paper: px(10),
    min: 0.01,
    max: 5,
    step: 0.01,
    unit: 'm',
    stage: 'plan',
    label: 'Wall thickness',
    doc: 'Width of the contour drawn along the primary boundary.',
    source: '[Stojanovic19] §3',
  }),
  wallSide: choice(['outside', 'centre'], {
    default: 'outside',
    paper: 'centre',
    stage: 'plan',
    label: 'Wall side',
    doc: 'The wall lies outside the boundary, which is its inner face, or is centred on it as a canvas stroke is.',
    source: 'ours',
    advanced: true,
  }),
  wallHeight: autoNumber({
    default: 'auto',
    min: 0.01,
    max: 100,
    step: 0.01,
    unit: 'm',
    stage: 'plan',
    label: 'Wall height',
    doc: 'Height of the extruded walls; auto takes it from the scan.',
    source: '[Stojanovic19] §3.2',
  }),
  doors: doors({
    default: 'none',
    stage: 'plan',
    label: 'Doors',
    doc: 'Doors cut out of the walls: gaps takes every bridged gap 0.6 to 3 m wide; x,y,width[,height] cuts one at the wall nearest that place (source coordinates; width and height in metres); both join by semicolons.',
    source: '[Stojanovic19] §3',
  }),
  floorSlab: flag({
    default: true,
    stage: 'solid',
    label: 'Floor slab',
    doc: 'Add a slab under the walls.',
    source: 'ours',
  }),
  ceilingSlab: flag({
    default: false,
    stage: 'solid',
    label: 'Ceiling slab',
    doc: 'Add a slab over the walls.',
    source: 'ours',
  }),
  slabThickness: number({
    default: 0.1,
    min: 0.01,
    max: 2,
    step: 0.01,
    unit: 'm',
    stage: 'solid',
    label: 'Slab thickness',
    doc: 'Thickness of floor and ceiling slabs.',
    source: 'ours',
    advanced: true,
  }),
  csg: choice(['slabs', 'bsp'], {
    default: 'slabs',
    paper: 'bsp',
    stage: 'solid',
    label: 'Solid engine',
    doc: "slabs cuts in the plane and extrudes, exact and closed; bsp is the paper's Boolean operations on BSP trees.",
    source: '[Stojanovic19] §3.2',
    advanced: true,
  }),
} as const satisfies Record<string, ParamRow>;

export type ParamName = keyof typeof PARAMS;
type ValueOf<Row> = Row extends RowFacts<infer T> ? T : never;

/** One value for every row of {@link PARAMS}. */
export type Options = { readonly [K in ParamName]: ValueOf<(typeof PARAMS)[K]> };

type GivenValue<Row> = Row extends { readonly unit: 'm' }
  ? ValueOf<Row> | LengthText
  : Row extends { readonly unit: 'm²' }
    ? ValueOf<Row> | AreaText
    : ValueOf<Row>;

/** What a person may give: any of the {@link Options}, lengths and areas also as text with a unit: `24mm`, `2.4px`. */
export type GivenValues = { readonly [K in ParamName]?: GivenValue<(typeof PARAMS)[K]> };

export const PARAM_NAMES = Object.keys(PARAMS) as readonly ParamName[];

/** `wallThickness` → `wall-thickness`: a parameter's spelling as a flag and as an attribute. */
export function kebabCase(name: string): string {
  return name.replace(/(?<=[a-z])(?=[A-Z])|(?<=[a-z])(?=\d)|(?<=\d)(?=[A-Z])/g, '-').toLowerCase();
}
