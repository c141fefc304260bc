import { CLASSES, type SceneClass, type SceneFacts } from './classes.ts';
import { MEASURE_NAMES, MEASURES, type MeasureName, type Measures, meanOfScenes, rowOf } from './measures.ts';

/** What became of one scene. */
export interface SceneResult {
  readonly name: string;
  /** As written down with it. */
  readonly class?: SceneClass;
  /** Null when no plan came. */
  readonly measures: Measures | null;
  readonly seconds: number;
  /** What can be said where the truth is not known. */
  readonly note?: string;
  /** What the command said when it failed. */
  readonly problem?: string;
}

/** Columns of the table; the rest stands in the list of means and in the JSON. */
const HEADLINE: readonly MeasureName[] = [
  'footprintIou',
  'roomF1',
  'roomAreaErrorPct',
  'cornerF1At5cm',
  'cornerF1At10cm',
  'faceMedianMm',
  'structureF1',
  'doorF1',
  'windowF1',
  'passageF1',
  'openingWidthErrorMm',
  'wallThicknessErrorMm',
  'inferredPrecision',
  'inferredRecall',
  'invalidCount',
];

/** A row a scene and a row of means. */
export function formatTable(results: readonly SceneResult[]): string {
  const mean = meanOfScenes(results.map(({ measures }) => measures));
  const seconds = results.reduce((sum, result) => sum + result.seconds, 0) / results.length;
  const lines = aligned([
    ['scene', 'class', ...HEADLINE.map((name) => MEASURES[name].label), 's'],
    ...results.map((result) => [
      result.name,
      result.class ?? '–',
      ...cells(result.measures ?? {}),
      result.seconds.toFixed(1),
    ]),
    ['mean', '', ...cells(mean), seconds.toFixed(1)],
  ]);
  const problems = results.flatMap(({ name, problem = '', note = '' }) =>
    problem || note ? [`${name}: ${problem}${note}`] : [],
  );
  return [...lines, ...problems].join('\n');
}

/** The figures that decide, in one line. */
export function formatFigures(measures: Measures): string {
  return HEADLINE.flatMap((name) => {
    const value = measures[name];
    return value === undefined ? [] : [`${MEASURES[name].label} ${figure(name, value)}`];
  }).join('   ');
}

/** Means of some scenes. */
export interface ClassMeans {
  readonly name: SceneClass | 'all';
  readonly scenes: number;
  readonly seconds: number;
  readonly mean: Measures;
}

/** Of all scenes, then of each class that occurs. */
export function meansByClass(results: readonly SceneResult[]): ClassMeans[] {
  return (['all', ...CLASSES] as const).flatMap((name) => {
    const chosen = results.filter((result) => name === 'all' || result.class === name);
    if (chosen.length === 0) return [];
    const seconds = chosen.reduce((sum, result) => sum + result.seconds, 0) / chosen.length;
    return [
      { name, scenes: chosen.length, seconds, mean: meanOfScenes(chosen.map(({ measures }) => measures)) },
    ];
  });
}

/** A row a measure, a column a class. */
export function formatMeans(means: readonly ClassMeans[]): string {
  const row = (label: string, value: (of: ClassMeans) => string): string[] => [label, ...means.map(value)];
  const named = MEASURE_NAMES.filter((name) => means.some(({ mean }) => mean[name] !== undefined));
  return aligned([
    row('means', ({ name }) => name),
    row('scenes', ({ scenes }) => String(scenes)),
    ...named.map((name) =>
      row(MEASURES[name].label, ({ mean }) => {
        const value = mean[name];
        return value === undefined ? '–' : figure(name, value);
      }),
    ),
    row('s', ({ seconds }) => seconds.toFixed(1)),
  ]).join('\n');
}

/** A row a scene: what is written down with it. */
export function formatList(scenes: readonly { name: string; facts?: SceneFacts | undefined }[]): string {
  const percent = (share: number): string => `${(100 * share).toFixed(0)} %`;
  return aligned([
    ['scene', 'class', 'scanner', 'noise mm', 'voxel cm', 'furniture', 'hidden', 'ceilings'],
    ...scenes.map(({ name, facts }) =>
      facts === undefined
        ? [name, ...Array(7).fill('–')]
        : [
            name,
            facts.class,
            facts.scanner,
            (facts.noise * 1000).toFixed(0),
            (facts.voxel * 100).toFixed(1),
            percent(facts.furnitureShare),
            percent(facts.hiddenShare),
            facts.ceilings ? 'yes' : 'no',
          ],
    ),
  ]).join('\n');
}

function aligned(rows: readonly (readonly string[])[]): string[] {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  return rows.map((row) =>
    row.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  '),
  );
}

function cells(measures: Measures): string[] {
  return HEADLINE.map((name) => {
    const value = measures[name];
    return value === undefined ? '–' : figure(name, value);
  });
}

function figure(name: MeasureName, value: number): string {
  return value.toFixed(rowOf(name).digits);
}
