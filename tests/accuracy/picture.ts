import { boundsOf, type XY } from '../../fixtures/simulator/ring.ts';
import type { TruthStorey } from '../../fixtures/simulator/truth.ts';
import type { CorpusTruth } from './classes.ts';
import type { PlanFile } from './facts.ts';

/** Long side of a picture, px. */
const SIZE = 1400;
const MARGIN = 24;
const HEAD = 54;
/** Points drawn at most; more only make the file heavy. */
const MOST_POINTS = 60_000;

type Style = Readonly<Record<string, string | number>>;

/** Truth is broad and pale, the plan thin and strong; equal things have equal colours. */
const STYLES = {
  outerWall: { fill: '#e9edf4', stroke: '#9fb0cc', 'stroke-width': 1 },
  trueRoom: { fill: '#ffffff', stroke: '#7f9ad0', 'stroke-width': 5, 'stroke-opacity': 0.45 },
  trueColumn: { fill: '#f6d9a8', stroke: '#e0a030', 'stroke-width': 4, 'stroke-opacity': 0.5 },
  trueHidden: { fill: 'none', stroke: '#ff9bc2', 'stroke-width': 10, 'stroke-opacity': 0.55 },
  points: {
    fill: 'none',
    stroke: '#1b1f24',
    'stroke-width': 1.2,
    'stroke-opacity': 0.45,
    'stroke-linecap': 'round',
  },
  wall: { fill: '#6b7280', 'fill-opacity': 0.28, stroke: 'none' },
  primary: { fill: 'none', stroke: '#e07000', 'stroke-width': 1.6 },
  room: { fill: 'none', stroke: '#1d3fae', 'stroke-width': 1.6 },
  structure: { fill: '#c07000', 'fill-opacity': 0.45, stroke: '#7a4500', 'stroke-width': 1.6 },
  inferred: { fill: 'none', stroke: '#d6006c', 'stroke-width': 3, 'stroke-dasharray': '9 6' },
} as const satisfies Record<string, Style>;

const OPENING_COLOURS: Readonly<Record<string, string>> = {
  door: '#0a8f3c',
  window: '#0092d6',
  passage: '#8a2be2',
};

const LEGEND: readonly (readonly [text: string, colour: string])[] = [
  ['broad and pale: truth; thin: plan', '#444444'],
  ['rooms', '#1d3fae'],
  ['primary boundary', '#e07000'],
  ['secondary boundary', '#a06000'],
  ['door', OPENING_COLOURS.door],
  ['window', OPENING_COLOURS.window],
  ['passage', OPENING_COLOURS.passage],
  ['inferred (dashed), hidden (pale)', '#d6006c'],
];

type Coordinates = readonly (readonly number[])[];

export interface Comparison {
  readonly plan: PlanFile;
  readonly name: string;
  /** Null where nobody knows it. */
  readonly truth: CorpusTruth | null;
  /** Of the slice, in the plan frame. */
  readonly points: readonly XY[];
  readonly storey: number;
  /** A line of figures under the name. */
  readonly figures: string;
}

/** Truth, plan and slice of one storey from above, as SVG without style sheet, so that every renderer draws it. */
export function drawComparison({ name, plan, truth, points, storey, figures }: Comparison): string {
  const facts = truth === null ? NOTHING_KNOWN : storeyOf(truth, storey);
  const features = plan.features.filter(({ properties }) => (properties.storey ?? 0) === storey);
  const drawn = features.flatMap(({ geometry }) =>
    geometry?.type === 'Polygon' ? (geometry.coordinates as Coordinates[])[0] : [],
  );
  const known = facts.outer[0] ?? [...drawn, ...points];
  const extent = known.length > 0 ? known : EMPTY_SHEET;
  const [minX, minY, maxX, maxY] = boundsOf(extent.map(([x, y]): XY => [x, y]));
  const scale = (SIZE - 2 * MARGIN) / Math.max(maxX - minX, maxY - minY);
  const at = ([x, y]: readonly number[]): string =>
    `${(MARGIN + (x - minX) * scale).toFixed(1)} ${(HEAD + (maxY - y) * scale).toFixed(1)}`;
  const path = (d: string, style: Style): string => `<path d="${d}"${attributes(style)}/>`;
  const area = (rings: readonly Coordinates[], style: Style): string =>
    path(rings.map((ring) => `M${ring.map(at).join('L')}Z`).join(''), { ...style, 'fill-rule': 'evenodd' });
  const line = (ends: Coordinates, style: Style): string => path(`M${ends.map(at).join('L')}`, style);
  const found = (kind: string) =>
    features.flatMap(({ geometry, properties }) =>
      geometry && properties.kind === kind ? [{ at: geometry.coordinates as never, properties }] : [],
    );
  const step = Math.ceil(points.length / MOST_POINTS);
  const dots = points.filter((_, i) => i % step === 0).map((point) => `M${at(point)}h0.1`);
  const width = Math.max(900, Math.round((maxX - minX) * scale + 2 * MARGIN));
  const height = Math.round((maxY - minY) * scale + HEAD + MARGIN);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}">`,
    `<rect width="${width}" height="${height}" fill="#ffffff"/>`,
    area(facts.outer, STYLES.outerWall),
    ...facts.rooms.map((room) => area(room, STYLES.trueRoom)),
    ...facts.columns.map((column) => area(column, STYLES.trueColumn)),
    ...(facts.hidden ?? []).map((stretch) => line(stretch, STYLES.trueHidden)),
    ...facts.openings.map(({ kind, seg }) => line(seg, openingStyle(kind, true))),
    path(dots.join(''), STYLES.points),
    ...found('wall').map((wall) => area(wall.at, STYLES.wall)),
    ...found('primary-boundary').map((boundary) => area(boundary.at, STYLES.primary)),
    ...found('room').map((room) => area(room.at, STYLES.room)),
    ...found('secondary-boundary').map((structure) => area(structure.at, STYLES.structure)),
    ...found('opening').map(({ at: ends, properties }) =>
      line(ends, openingStyle(String(properties.type), false)),
    ),
    ...found('inferred-stretch').map((stretch) => line(stretch.at, STYLES.inferred)),
    text(MARGIN, 18, `${name}, storey ${storey}${sceneText(truth)}   ${figures}`, '#1b1f24'),
    ...legend(),
    '</svg>',
  ].join('\n');
}

const EMPTY_SHEET: Coordinates = [
  [0, 0],
  [1, 1],
];

type Known = Pick<TruthStorey, 'outer' | 'rooms' | 'columns' | 'openings' | 'hidden'>;

const NOTHING_KNOWN: Known = { outer: [], rooms: [], columns: [], openings: [] };

/** A plan with more storeys than the building has some to be drawn alone. */
function storeyOf(truth: CorpusTruth, storey: number): Known {
  if ('storeys' in truth) return truth.storeys[storey] ?? NOTHING_KNOWN;
  return storey === 0 ? truth : NOTHING_KNOWN;
}

function openingStyle(kind: string, isTrue: boolean): Style {
  const stroke = OPENING_COLOURS[kind] ?? '#000000';
  return isTrue
    ? { fill: 'none', stroke, 'stroke-width': 12, 'stroke-opacity': 0.28 }
    : { fill: 'none', stroke, 'stroke-width': 3 };
}

function sceneText(truth: CorpusTruth | null): string {
  const scene = truth?.scene;
  if (scene === undefined) return '';
  const percent = (share: number): string => `${(100 * share).toFixed(0)} %`;
  return ` (${scene.class}: ${scene.scanner}, ${(scene.noise * 1000).toFixed(0)} mm, ${percent(scene.hiddenShare)} hidden)`;
}

function legend(): string[] {
  let x = MARGIN;
  return LEGEND.map(([label, colour]) => {
    const entry = text(x, 38, label, colour);
    // About the width of a letter of this size.
    x += label.length * 6.6 + 18;
    return entry;
  });
}

const text = (x: number, y: number, content: string, colour: string): string =>
  `<text x="${x.toFixed(0)}" y="${y}" font-family="sans-serif" font-size="13" fill="${colour}">${content}</text>`;

const attributes = (style: Style): string =>
  Object.entries(style)
    .map(([name, value]) => ` ${name}="${value}"`)
    .join('');
