import type { CaseShares, Experiments } from './experiments.ts';
import { html, type Markup, table } from './html.ts';
import { fixed, whole } from './tables.ts';

const metres = (value: number) => `${value.toFixed(2)} m`;
const percent = (share: number) => `${(100 * share).toFixed(1)} %`;

/** Kinds of cases whose own name a reader would puzzle over. */
const KIND_NAMES: Readonly<Record<string, string>> = { l: 'L-shaped' };

const ROOM_NAMES: Readonly<Record<string, string>> = { ell: 'L', tee: 'T', you: 'U', zed: 'Z' };

/** The experiments beyond the six sets. */
export function experimentSections(results: Experiments): Markup {
  return html`${narrowSection(results)}
${gapSection(results)}
${casesSection(results)}`;
}

function narrowSection({ narrowSpaces }: Experiments): Markup {
  const content = html`<p>The paper found α-shapes better at narrow spaces (§5). Rooms, ducts and corridors of one width, with several seeds, noises and spacings:</p>
${table(
  'Mean IoU of the outline',
  ['width', 'gift opening', 'α-shape', 'α-shape, regularised'],
  narrowSpaces.map((row) => [
    metres(row.width),
    fixed(row.giftOpening),
    fixed(row.alphaShape),
    fixed(row.alphaShapeRegularised),
  ]),
)}`;
  return html`<section id="narrow-spaces">
<h2>Narrow spaces</h2>
${content}
</section>`;
}

function gapSection({ doorGaps, recesses }: Experiments): Markup {
  const { byWidth, byOpeningLength } = doorGaps;
  const rooms = Object.keys(byOpeningLength[0].worst);
  const gaps = html`<p>Gift opening takes a missing piece of wall for a concave opening (§5). Ours bridges such gaps and says so; the safeguard must not close real niches. Rooms of many shapes, gaps in every kind of place, opening lengths from 5 cm to 5 m and noise up to 20 mm.</p>
<p>An opening length leaves edges up to itself closed, gap or none: at concave corners and across bays a long one adds to the room, and how much hangs on single points. The cost of a gap is what the outline misses beyond that and beyond the noise, which without a gap it misses too.</p>
${table(
  'Cost of a gap in the wall, share of the true area',
  ['gap', 'worst', 'mean', 'worst without safeguard', 'mean without'],
  byWidth.map((row) => [
    metres(row.width),
    percent(row.worst),
    percent(row.mean),
    percent(row.worstWithout),
    percent(row.meanWithout),
  ]),
)}
${table(
  'Worst cost of a gap by the opening length and the room; last, the worst error of the rooms without a gap',
  ['opening length', ...rooms.map((room) => ROOM_NAMES[room] ?? room), 'no gap'],
  byOpeningLength.map(({ openingLength, worst, own }) => [
    openingLength === 'auto' ? 'auto' : metres(openingLength),
    ...rooms.map((room) => percent(worst[room])),
    percent(own),
  ]),
)}`;
  const niches = table(
    'IoU of rooms with a niche whose sides are scanned',
    ['mouth', 'lowest', 'mean'],
    recesses.map(({ mouth, lowest, mean }) => [metres(mouth), fixed(lowest), fixed(mean)]),
  );
  return html`<section id="door-gaps">
<h2>Door gaps and recesses</h2>
${gaps}
${niches}
</section>`;
}

function casesSection({ structureCases }: Experiments): Markup {
  const row = (label: string, { cases, robust, paper, paperInner }: CaseShares) => [
    label,
    whole(cases),
    percent(robust),
    percent(paper),
    percent(paperInner),
  ];
  const content = html`<p>Seeded variations of the six rooms: one structure 0.1 to 1.5 m from the wall, any rotation, 0.5 to 3 px of noise, 200 to 5,000 points. Half of the cases were kept back while the method was made and looked at in sum only.</p>
${table(
  'Share of the cases whose structure is found with an IoU over 0.8',
  ['cases', 'number', 'ours: robust', 'paper’s method, outer face', 'paper’s method, inner face'],
  [
    row('made with', structureCases.development),
    row('kept back', structureCases.keptBack),
    ...Object.entries(structureCases.byDifficulty).map(([label, shares]) =>
      row(KIND_NAMES[label] ?? label, shares),
    ),
  ],
)}`;
  return html`<section id="structure-cases">
<h2>Structures in 200 rooms</h2>
${content}
</section>`;
}
