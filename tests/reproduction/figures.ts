import type { Options } from '../../src/core/params.ts';
import type { StageResults } from '../../src/core/stage-results.ts';
import { drawPicture, type PictureName } from '../../src/write/pictures/pictures.ts';
import { ALPHA_EPSILON, PAPER_ALPHA, SQUARED_ALPHA } from './outlines.ts';
import { drawPanel, drawRegularised } from './panel.ts';
import { PAPER_SETS, type PaperSet, ROOMS, runSet } from './paper-sets.ts';

/** One picture of a figure. */
export interface FigurePanel {
  /** Name of its files without ending. */
  readonly file: string;
  readonly label: string;
  readonly set: PaperSet;
  readonly given: Partial<Options>;
  readonly draw: (results: StageResults) => string;
}

export interface Figure {
  readonly number: number;
  readonly title: string;
  readonly doc: string;
  readonly panels: readonly FigurePanel[];
}

/** m; at the height of a room the near walls would hide what stands in it. */
const LOW_WALLS = 1;

const cutOut: Partial<Options> = { wallHeight: LOW_WALLS };
const standing: Partial<Options> = { ...cutOut, secondaryOperation: ['independent'] };

/** The paper's figures that show what its method makes of the six sets. */
export const FIGURES: readonly Figure[] = [
  {
    number: 3,
    title: 'From a cluster of points to a secondary boundary',
    doc: 'Room_1a, step by step: the structure lies within the primary boundary, k-means sets it apart, Algorithm 1 keeps the points near the centre of its cluster, and what the stroke along their outline does not cover makes the boundary.',
    panels: [
      stage('fig-3-a', '(a) The region of the structure', 'room-1a', 'region'),
      stage('fig-3-b', '(b) The clusters of k-means, k = 2', 'room-1a', 'clusters'),
      stage('fig-3-c', '(c) Outline and stroke of Algorithm 2', 'room-1a', 'secondary-outline'),
      stage('fig-3-d', '(d) Innermost points and their boundary', 'room-1a', 'secondary'),
    ],
  },
  {
    number: 4,
    title: 'Primary boundary of Hallway_1, with a curved wall',
    doc: 'Gift opening, then radial distance, Douglas-Peucker (both ε 2.4 px) and Visvalingam (ε 0.2 px²).',
    panels: hallwayPanels(4, 'hallway-1'),
  },
  {
    number: 5,
    title: 'Primary boundary of Hallway_2, with straight walls',
    doc: 'The same chain with the same values.',
    panels: hallwayPanels(5, 'hallway-2'),
  },
  {
    number: 6,
    title: 'Secondary boundaries: ours and the α-shape',
    doc: 'For each room, as in the paper: its method with ε 10 px, the α-shape with α 150, and the same regularised with ε 10 px. Below them our robust method, and the α-shape with 150 read as a squared radius, √150 = 12.2 px, since the paper does not say what its α measures; see the table after the figure.',
    panels: ROOMS.flatMap(roomPanels),
  },
  {
    number: 7,
    title: 'Models of the hallways',
    doc: 'The regularised outlines as walls, extruded, with a floor slab.',
    panels: [
      stage('fig-7-a', '(a) Hallway_2, square elements', 'hallway-2', 'model'),
      stage('fig-7-b', '(b) Hallway_1, a curved wall', 'hallway-1', 'model'),
    ],
  },
  {
    number: 8,
    title: 'Models with a secondary boundary',
    doc: "Walls and floor slab less the structure, by the paper's Boolean operations on BSP trees; then the structure as a solid of its own. The walls are cut at 1 m, so that they do not hide it.",
    panels: [
      stage('fig-8-a', '(a) Room_1a, subtracted', 'room-1a', 'model', cutOut),
      stage('fig-8-b', '(b) Room_2, subtracted', 'room-2', 'model', cutOut),
      stage('fig-8-a-solid', 'Room_1a, independent', 'room-1a', 'model', standing),
      stage('fig-8-b-solid', 'Room_2, independent', 'room-2', 'model', standing),
    ],
  },
];

/** Draws panels; sets and options that several of them share run once. */
export async function drawPanels(panels: readonly FigurePanel[]): Promise<Map<string, string>> {
  const runs = new Map<string, Promise<StageResults>>();
  const drawn = new Map<string, string>();
  for (const { file, set, given, draw } of panels) {
    const key = `${set.name} ${JSON.stringify(given)}`;
    const run = runs.get(key) ?? runSet(set, given);
    runs.set(key, run);
    drawn.set(file, draw(await run));
  }
  return drawn;
}

function stage(
  file: string,
  label: string,
  name: string,
  picture: PictureName,
  given: Partial<Options> = {},
): FigurePanel {
  const draw = (results: StageResults) => {
    const svg = drawPicture(picture, results);
    if (svg === null) throw new Error(`${file}: the chain made no picture "${picture}" of ${name}`);
    return svg;
  };
  return { file, label, set: setOf(name), given, draw };
}

function setOf(name: string): PaperSet {
  return PAPER_SETS.find((set) => set.name === name)!;
}

function hallwayPanels(figure: number, name: string): FigurePanel[] {
  return [
    stage(`fig-${figure}-a`, '(a) Slice', name, 'slice'),
    stage(`fig-${figure}-b`, '(b) Concave hull, not regularised', name, 'hull'),
    {
      file: `fig-${figure}-c`,
      label: '(c) After the three passes',
      set: setOf(name),
      given: {},
      draw: (results) => drawRegularised(`fig-${figure}-c`, results),
    },
  ];
}

/** Two rows of Fig. 6: the paper's, and how it would look better. */
function roomPanels(set: PaperSet): FigurePanel[] {
  const panel = (
    part: string,
    label: string,
    given: Partial<Options>,
    outline: 'boundary' | 'regularise' = 'regularise',
  ): FigurePanel => {
    const file = `fig-6-${set.name}-${part}`;
    const draw = ({ slice, secondary, ...results }: StageResults) =>
      drawPanel({
        name: file,
        label: `${set.label}, ${label}`,
        doc: '',
        points: slice.xy,
        primary: results[outline].polygons,
        secondary: secondary.boundaries.map((structure) => structure.outline),
      });
    return { file, label: `${set.label}: ${label}`, set, given, draw };
  };
  const alpha = (radius: number): Partial<Options> => ({
    boundary: 'alpha-shape',
    alpha: radius,
    epsilon: ALPHA_EPSILON,
    secondaryCount: 0,
  });
  return [
    panel('paper', "paper's method", {}),
    panel('alpha-150', 'α-shape, radius 150 px', alpha(PAPER_ALPHA), 'boundary'),
    panel('alpha-150-regularised', 'α 150 px, regularised', alpha(PAPER_ALPHA)),
    panel('robust', 'robust method', { secondaryMethod: 'robust' }),
    panel('alpha-squared', 'α-shape, radius √150 px', alpha(SQUARED_ALPHA), 'boundary'),
    panel('alpha-squared-regularised', 'α √150 px, regularised', alpha(SQUARED_ALPHA)),
  ];
}
