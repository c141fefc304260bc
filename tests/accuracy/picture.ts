import { boundsOf, type XY } from '../../fixtures/simulator/ring.ts';
import type { Truth, TruthStorey } from '../../fixtures/simulator/truth.ts';
import type { PlanFile } from './facts.ts';

/** Long side of a picture, px. */
const SIZE = 1200;
const MARGIN = 30;
/** Points drawn at most; more only make the file heavy. */
const MOST_POINTS = 60_000;

const STYLE = `
.truth{fill:#2457d6;fill-opacity:.08;stroke:#2457d6;stroke-width:1}
.outline{fill:none;stroke:#2457d6;stroke-width:2;stroke-opacity:.5}
.room{fill:none;stroke:#b02020;stroke-width:1.2}
.primary{fill:none;stroke:#e08000;stroke-width:1.6}
.structure{fill:#b02020;fill-opacity:.3;stroke:#b02020}
.opening{stroke:#108040;stroke-width:3}
.true-opening{stroke:#2457d6;stroke-width:6;stroke-opacity:.25}
.points{stroke:#1b1f24;stroke-width:1.2;stroke-opacity:.6;stroke-linecap:round}
text{font:14px system-ui,sans-serif;fill:#1b1f24}`;

type Coordinates = readonly (readonly number[])[];

/** Truth in blue, plan in red and orange, slice points in ink: one storey seen from above. */
export function drawComparison(plan: PlanFile, truth: Truth, points: readonly XY[], storey: number): string {
  const facts: TruthStorey = 'storeys' in truth ? truth.storeys[storey] : truth;
  const features = plan.features.filter(({ properties }) => (properties.storey ?? 0) === storey);
  const outline = facts.outer[0].map(([x, y]): XY => [x, y]);
  const [minX, minY, maxX, maxY] = boundsOf(outline);
  const scale = (SIZE - 2 * MARGIN) / Math.max(maxX - minX, maxY - minY);
  const at = ([x, y]: readonly number[]): string =>
    `${(MARGIN + (x - minX) * scale).toFixed(1)} ${(MARGIN + (maxY - y) * scale).toFixed(1)}`;
  const polygon = (rings: readonly Coordinates[], name: string): string =>
    `<path class="${name}" fill-rule="evenodd" d="${rings.map((ring) => `M${ring.map(at).join('L')}Z`).join('')}"/>`;
  const line = (ends: Coordinates, name: string): string =>
    `<path class="${name}" d="M${ends.map(at).join('L')}"/>`;
  const found = (kind: string): readonly Coordinates[][] =>
    features.flatMap(({ geometry, properties }) =>
      geometry && properties.kind === kind ? [geometry.coordinates as Coordinates[]] : [],
    );
  const step = Math.ceil(points.length / MOST_POINTS);
  const dots = points.filter((_, i) => i % step === 0).map((point) => `M${at(point)}h0`);
  const width = Math.round((maxX - minX) * scale + 2 * MARGIN);
  const height = Math.round((maxY - minY) * scale + 2 * MARGIN);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}"><style>${STYLE}</style>`,
    '<rect width="100%" height="100%" fill="#fff"/>',
    ...facts.rooms.map((room) => polygon(room, 'truth')),
    ...facts.columns.map((column) => polygon(column, 'truth')),
    polygon(facts.interior_outline, 'outline'),
    `<path class="points" d="${dots.join('')}"/>`,
    ...facts.openings.map(({ seg }) => line(seg, 'true-opening')),
    ...found('room').map((room) => polygon(room, 'room')),
    ...found('primary-boundary').map((boundary) => polygon(boundary, 'primary')),
    ...found('secondary-boundary').map((structure) => polygon(structure, 'structure')),
    ...found('opening').map((opening) => line(opening as unknown as Coordinates, 'opening')),
    `<text x="${MARGIN}" y="20">${truth.name}, storey ${storey}: truth blue, boundary orange, rooms red</text></svg>`,
  ].join('\n');
}
