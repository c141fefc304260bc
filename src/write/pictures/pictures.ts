import type { StageResults } from '../../core/stage-results.ts';
import { STAGES } from '../../core/stages.ts';
import type { WrittenFile } from '../plan-writer.ts';
import { drawCloud } from './cloud-picture.ts';
import { drawLevels } from './levels-picture.ts';
import { drawModel } from './model-picture.ts';
import { drawHull, drawPass, drawSlice, hasPass } from './outline-pictures.ts';
import { pageOf } from './page.ts';
import type { PictureFacts, PictureRow } from './picture.ts';
import { drawPlan } from './plan-picture.ts';
import {
  clustersOf,
  drawClusters,
  drawRegion,
  drawSecondary,
  drawSecondaryOutline,
  takenClusters,
} from './secondary-pictures.ts';

export type { PictureFacts, PictureRow } from './picture.ts';

/** Every picture of a run in the order of the chain: steps in the app, `--formats pictures`, the reproduction's figures. */
export const PICTURES = {
  cloud: {
    label: 'Cloud',
    doc: 'The upright cloud seen from above, coloured by height, without its ceiling.',
    stage: 'frame',
    figure: 'Fig. 1a',
    draw: drawCloud,
  },
  levels: {
    label: 'Levels',
    doc: 'Three height levels around the least, mean and greatest height, with their bounding boxes, points and densities.',
    stage: 'level',
    figure: 'Fig. 2',
    has: ({ frame }) => !frame.isFlat,
    draw: drawLevels,
  },
  slice: {
    label: 'Slice',
    doc: 'The points of the chosen level seen from above.',
    stage: 'slice',
    figure: 'Fig. 4a, 5a',
    draw: drawSlice,
  },
  hull: {
    label: 'Outline',
    doc: 'The concave outline around the slice before it is regularised; bridged gaps are marked.',
    stage: 'boundary',
    figure: 'Fig. 4b, 5b',
    draw: drawHull,
  },
  noise: {
    label: 'Noise',
    doc: 'Every vertex is on the wall beside it, no longer on its outermost points.',
    stage: 'regularise',
    figure: 'ours',
    has: ({ regularise }) => hasPass('noise', regularise),
    draw: (results) => drawPass('noise', results),
  },
  radial: {
    label: 'Radial distance',
    doc: 'Vertices closer than ε to the one before are gone.',
    stage: 'regularise',
    figure: 'Fig. 4c, 5c',
    has: ({ regularise }) => hasPass('radial', regularise),
    draw: (results) => drawPass('radial', results),
  },
  'douglas-peucker': {
    label: 'Douglas-Peucker',
    doc: 'Vertices closer than ε to the line between those kept are gone.',
    stage: 'regularise',
    figure: 'Fig. 4c, 5c',
    has: ({ regularise }) => hasPass('douglas-peucker', regularise),
    draw: (results) => drawPass('douglas-peucker', results),
  },
  visvalingam: {
    label: 'Visvalingam',
    doc: 'Vertices whose triangle with their neighbours is smaller than the area ε are gone.',
    stage: 'regularise',
    figure: 'Fig. 4c, 5c',
    has: ({ regularise }) => hasPass('visvalingam', regularise),
    draw: (results) => drawPass('visvalingam', results),
  },
  corners: {
    label: 'Corners',
    doc: 'Lines fitted to the points each edge stands for meet in sharp corners.',
    stage: 'regularise',
    figure: 'ours',
    has: ({ regularise }) => hasPass('corners', regularise),
    draw: (results) => drawPass('corners', results),
  },
  region: {
    label: 'Region',
    doc: 'The points taken for secondary boundaries, within the primary boundary.',
    stage: 'secondary',
    figure: 'Fig. 3a',
    has: ({ secondary }) => takenClusters(secondary).length > 0,
    draw: drawRegion,
  },
  clusters: {
    label: 'Clusters',
    doc: 'The points of the slice by cluster.',
    stage: 'secondary',
    figure: 'Fig. 3b',
    has: ({ secondary }) => clustersOf(secondary).length > 1,
    draw: drawClusters,
  },
  'secondary-outline': {
    label: 'Stroke filter',
    doc: 'The outline of the points near the centre of the cluster, and which of them the stroke along it drops.',
    stage: 'secondary',
    figure: 'Fig. 3c',
    has: ({ secondary }) => secondary.searches.some(({ rounds }) => (rounds.at(-1)?.near.length ?? 0) > 0),
    rounds: ({ secondary }) => Math.max(...secondary.searches.map(({ rounds }) => rounds.length)),
    draw: drawSecondaryOutline,
  },
  secondary: {
    label: 'Secondary boundaries',
    doc: 'The structures inside the primary boundary, with the points they were outlined from.',
    stage: 'secondary',
    figure: 'Fig. 3d',
    has: ({ secondary }) => secondary.boundaries.length > 0,
    draw: drawSecondary,
  },
  plan: {
    label: 'Plan',
    doc: 'Walls of a thickness, secondary boundaries hatched by what they do to the model.',
    stage: 'plan',
    figure: 'Fig. 1b',
    draw: drawPlan,
  },
  model: {
    label: 'Model',
    doc: 'The extruded walls with secondary boundaries cut out or added, seen from the south-east; what is cut out of the floor shows dashed through walls.',
    stage: 'solid',
    figure: 'Fig. 1c, 7, 8',
    draw: drawModel,
  },
} as const satisfies Record<string, PictureRow>;

export type PictureName = keyof typeof PICTURES;

export const PICTURE_NAMES = Object.keys(PICTURES) as readonly PictureName[];

/**
 * One picture of a run as standalone SVG: 640 px wide, on white paper, in plan metres to scale, with caption and scale
 * bar. Equal results and facts give equal text. Linear in the points; the file stays under a megabyte.
 *
 * @param results what the stages made, as far as the run got
 * @returns null while the picture's stage has not run or there is nothing to show
 */
export function drawPicture(
  name: PictureName,
  results: Partial<StageResults>,
  facts: PictureFacts = {},
): string | null {
  const { label, doc, stage, draw }: PictureRow = PICTURES[name];
  const drawing = draw(results, facts);
  if (drawing === null) return null;
  const time = facts.ms === undefined ? [] : [`${STAGES[stage].label} ${timeWords(facts.ms)}`];
  return pageOf({ ...drawing, counts: [...drawing.counts, ...time] }, { name, label, doc });
}

/** Whether {@link drawPicture} has something to draw, without drawing it. */
export function hasPicture(name: PictureName, results: Partial<StageResults>): boolean {
  const { stage, has }: PictureRow = PICTURES[name];
  // A stage that ran has all before it.
  return results[stage] !== undefined && (has?.(results as StageResults) ?? true);
}

/** How many rounds of the search a picture can show; 1 where there is no choice. */
export function roundsOf(name: PictureName, results: Partial<StageResults>): number {
  const { rounds }: PictureRow = PICTURES[name];
  return rounds && hasPicture(name, results) ? rounds(results as StageResults) : 1;
}

function timeWords(ms: number): string {
  return ms < 1000 ? `${Number(ms.toPrecision(2))} ms` : `${(ms / 1000).toFixed(1)} s`;
}

/** Every picture there is, numbered as in the table; without times, so that equal runs give equal files. */
export function writePictures(results: Partial<StageResults>): WrittenFile[] {
  return PICTURE_NAMES.flatMap((name) => {
    const content = drawPicture(name, results);
    return content === null ? [] : [{ name: pictureFile(name), mime: 'image/svg+xml', content }];
  });
}

/** `picture-04-hull.svg`: files in order of the chain. */
export function pictureFile(name: PictureName): string {
  return `picture-${String(PICTURE_NAMES.indexOf(name) + 1).padStart(2, '0')}-${name}.svg`;
}
