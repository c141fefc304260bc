import { MEASURE_NAMES, MEASURES, type MeasureName, type Measures, meanOfScenes, rowOf } from './measures.ts';

/** What became of one scene. */
export interface SceneResult {
  readonly name: string;
  /** Null when no plan came. */
  readonly measures: Measures | null;
  readonly seconds: number;
  /** What the command said when it failed. */
  readonly problem?: string;
}

/** Columns of the table; the rest stands in the list of means and in the JSON. */
const HEADLINE: readonly MeasureName[] = [
  'footprintIou',
  'footprintAreaErrorPct',
  'footprintP95',
  'boundaryVertices',
  'valid',
  'roomF1',
  'roomIou',
  'cornerF1At5cm',
  'cornerF1At10cm',
  'faceMedianMm',
  'structureF1',
  'doorF1',
  'windowF1',
];

/** A row a scene, a row of means, then every mean by name. */
export function formatTable(results: readonly SceneResult[]): string {
  const mean = meanOfScenes(results.map(({ measures }) => measures));
  const seconds = results.reduce((sum, result) => sum + result.seconds, 0) / results.length;
  const rows = [
    ['scene', ...HEADLINE.map((name) => MEASURES[name].label), 's'],
    ...results.map(({ name, measures, seconds: s }) => [name, ...cells(measures ?? {}), s.toFixed(1)]),
    ['mean', ...cells(mean), seconds.toFixed(1)],
  ];
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  const lines = rows.map((row) =>
    row.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  '),
  );
  const problems = results.flatMap(({ name, problem }) => (problem ? [`${name}: ${problem}`] : []));
  const all = MEASURE_NAMES.flatMap((name) =>
    mean[name] === undefined
      ? []
      : [`${MEASURES[name].label.padEnd(14)}${figure(name, mean[name]).padStart(9)}`],
  );
  return [...lines, ...problems, '', ...all].join('\n');
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
