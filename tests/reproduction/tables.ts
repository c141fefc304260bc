import { type Cell, html, type Markup, table } from './html.ts';
import { OUTLINE_METHODS } from './outlines.ts';
import { PAPER_SETS, ROOMS } from './paper-sets.ts';
import { PASS_COMBINATIONS } from './passes.ts';
import type { Results } from './results.ts';
import { STRUCTURE_METHODS } from './structures.ts';
import type { Time, Times } from './timing.ts';

/** Mean times the paper gives, ms. */
const PAPER_PRIMARY_MS = 10.25;
const PAPER_SECONDARY_MS = 169;

const LABELS = PAPER_SETS.map(({ label }) => label);
const ROOM_LABELS = ROOMS.map(({ label }) => label);

export function setTable(): Markup {
  return table(
    'Each set has as many points as the paper’s of that name',
    ['set', 'points', words('what it is')],
    PAPER_SETS.map(({ label, points, what }) => [label, whole(points), words(what)]),
  );
}

export function outlineTable({ sets }: Results): Markup {
  const rows = OUTLINE_METHODS.map(({ label }, i) => [
    label,
    ...PAPER_SETS.map(({ name }) => scored(sets[name].outlines[i])),
  ]);
  return html`${table('IoU of the outline with the true room, and its vertices', ['method', ...LABELS], rows)}
<p>Every outline counts as filled, holes too. The noise of the points is 1.2 px in x and in y; a hull runs along its outside, so a perfect hull of noisy points is a little larger than the room.</p>`;
}

export function passTable({ sets }: Results, times: Times): Markup {
  const rows = PASS_COMBINATIONS.map(({ label }, i) => [
    label,
    ...PAPER_SETS.map(({ name }) => scored(sets[name].passes[i])),
    times.passes[i].toFixed(3),
  ]);
  return html`<h3>Each pass alone, in pairs, and all three</h3>
${table('IoU and vertices after gift opening and some of the passes; median time of the passes', ['passes', ...LABELS, 'ms'], rows)}
<p>The paper’s values: ε 2.4 px for radial distance and Douglas-Peucker, 0.2 px² for Visvalingam.</p>`;
}

export function structureTable({ sets }: Results): Markup {
  const rows = STRUCTURE_METHODS.map(({ label, face }, i) => [
    label,
    words(face === 'innerFace' ? 'inner' : 'outer'),
    ...ROOMS.map(({ name }) => fixed(sets[name].structures[i])),
  ]);
  return html`${table('IoU with the structure of the room', ['method', words('against its face'), ...ROOM_LABELS], rows)}
<p>The structures are hollow. The paper’s method keeps the innermost points, so it seeks the inner face; a plan wants the outer one, which is what stands in the room. Of an α-shape’s pieces the one that fits best is taken, filled.</p>`;
}

export function alphaTable({ sets }: Results): Markup {
  const ranges = ROOMS.map(({ name }) => sets[name].alpha!);
  const pixels = (value: number | null) => (value === null ? 'never' : `${value} px`);
  const rows: Cell[][] = [
    ['smallest α that sets the structure apart, whole', ...ranges.map((at) => pixels(at.separateFrom))],
    ['pieces of the α-shape there', ...ranges.map(({ pieces }) => whole(pieces))],
    ['largest α that sets it apart', ...ranges.map((at) => pixels(at.separateTo))],
    ['smallest α that leaves the walls in one piece', ...ranges.map((at) => pixels(at.wallsWholeFrom))],
  ];
  const apartAt = (alpha: number) =>
    ranges.filter((at) => at.separateFrom !== null && at.separateFrom <= alpha && alpha <= at.separateTo!)
      .length;
  const both = ranges
    .filter((at) => at.separateTo !== null && at.wallsWholeFrom !== null)
    .filter((at) => at.wallsWholeFrom! <= at.separateTo!).length;
  return html`<h3>Which α sets the structure apart</h3>
${table('α as the circumradius of the largest triangle kept, tried at every whole pixel up to 200', ['α', ...ROOM_LABELS], rows)}
<p>The paper takes the smallest α that detects the structure whole and apart from the room, and names 150 without a unit. As a radius of 150 px it sets the structure apart in ${apartAt(150)} of ${ranges.length} rooms here; as a squared radius, as some libraries count, √150 = 12.2 px does in ${apartAt(Math.sqrt(150))}. One α for structure and walls together exists in ${both} of ${ranges.length}.</p>`;
}

export function meshTable({ sets }: Results): Markup {
  const rows = PAPER_SETS.map(({ name, label, mesh }) => {
    const { slabs, bsp } = sets[name].meshes;
    return [
      label,
      ...(mesh ? [whole(mesh.vertices), whole(mesh.faces)] : ['–', '–']),
      whole(bsp.vertices),
      whole(bsp.faces),
      whole(slabs.vertices),
      whole(slabs.faces),
      words(
        bsp.isClosed && slabs.isClosed ? 'both' : slabs.isClosed ? 'slabs' : bsp.isClosed ? 'bsp' : 'none',
      ),
    ];
  });
  return html`${table(
    'Vertices and faces of the model of each set',
    [
      'set',
      'paper: vertices',
      'faces',
      'ours, bsp: vertices',
      'faces',
      'ours, slabs: vertices',
      'faces',
      words('closed'),
    ],
    rows,
  )}
<p>Walls and floor slab with the preset paper, the structure subtracted. bsp is the paper’s way, slabs our default: cut in the plane, then extruded. Closed: every edge has exactly two faces.</p>`;
}

export function timeTable({ primary, secondary, machine, runs }: Times): Markup {
  const spread = ({ mean, median, min, max }: Time): Cell[] => [
    mean.toFixed(2),
    median.toFixed(2),
    `${min.toFixed(2)} to ${max.toFixed(2)}`,
  ];
  const labelOf = (name: string) => PAPER_SETS.find((set) => set.name === name)!.label;
  const rows = [
    ...Object.entries(primary).map(([name, time]) => [
      'primary boundary',
      words(labelOf(name)),
      PAPER_PRIMARY_MS.toFixed(2),
      ...spread(time),
    ]),
    ...Object.entries(secondary).flatMap(([name, { paper, robust }]) => [
      [
        'secondary boundary, paper’s method',
        words(labelOf(name)),
        whole(PAPER_SECONDARY_MS),
        ...spread(paper),
      ],
      ['secondary boundary, robust', words(labelOf(name)), '–', ...spread(robust)],
    ]),
  ];
  return html`${table('Milliseconds', ['what', words('set'), 'paper: mean', 'ours: mean', 'median', 'min to max'], rows)}
<p>The paper gives one mean for its primary and one for its secondary boundaries, measured in Firefox 62 on an Intel Core i5-6500 at 3.2 GHz with 8 GB. Ours: ${machine}, ${runs} runs of warmed code, so the first runs of a page are slower; from slice to regularised outline, and from there to the structure with k = 2 clusters, the canvas call included.</p>`;
}

function scored({ iou, vertices }: { iou: number; vertices: number }): Markup {
  return html`${fixed(iou)} <small>${whole(vertices)}</small>`;
}

export const fixed = (share: number): string => share.toFixed(3);
export const whole = (n: number): string => n.toLocaleString('en-GB');

/** A cell of words among numbers. */
export const words = (text: string): Markup => html`<span class="words">${text}</span>`;
