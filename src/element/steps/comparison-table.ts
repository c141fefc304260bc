import { formatCount, formatDuration, formatLength } from '../../view/measure.ts';
import type { ComparedPlan, Comparison } from '../../worker/protocol.ts';
import { clusterColour } from '../../write/pictures/palette.ts';
import { type DisplayUnit, formatArea } from '../../write/sheet/measure-words.ts';
import { make, setText } from '../make.ts';

type Row = readonly [label: string, read: (plan: ComparedPlan, unit: DisplayUnit) => string];

const ROWS: readonly Row[] = [
  ['Vertices', ({ vertices }) => formatCount(vertices)],
  ['Area', ({ areaM2 }, unit) => formatArea(areaM2, unit)],
  ['Triangles', ({ triangles }) => formatCount(triangles)],
  ['Time', ({ ms }) => formatDuration(ms)],
];
const SUBJECTS: Readonly<Record<Comparison['subject'], string>> = {
  primary: 'Outlines',
  secondary: 'Structures',
};
/** While the figures are not there. */
const UNKNOWN = '–';

/** Two plans of one scan in figures: each on its own, and how far they agree. */
export class ComparisonTable {
  readonly node: HTMLElement;
  readonly #heads = [make('th', { scope: 'col' }), make('th', { scope: 'col' })];
  readonly #subject = make('th', { scope: 'col' });
  readonly #cells = ROWS.map(() => [make('td'), make('td')]);
  readonly #overlap = make('td', { colspan: 2, testid: 'compare-iou' });
  readonly #distance = make('td', { colspan: 2 });
  #comparison: Comparison | null = null;
  #unit: DisplayUnit = 'm';

  constructor() {
    const rows = ROWS.map(([label], i) => make('tr', {}, head(label), ...this.#cells[i]));
    this.node = make(
      'table',
      { class: 'compare-table', testid: 'compare-table' },
      make('caption', { class: 'visually-hidden' }, 'The two plans in figures'),
      make('thead', {}, make('tr', {}, this.#subject, ...this.#heads)),
      make(
        'tbody',
        {},
        ...rows,
        make('tr', {}, head('Shared area (IoU)'), this.#overlap),
        make('tr', {}, head('95 % of the lines within'), this.#distance),
      ),
    );
  }

  /** What the two are called. */
  name(here: string, there: string): void {
    this.#heads[0].replaceChildren(swatch(0), `This plan: ${here}`);
    this.#heads[1].replaceChildren(swatch(1), there);
  }

  setUnit(unit: DisplayUnit): void {
    if (unit === this.#unit) return;
    this.#unit = unit;
    this.show(this.#comparison);
  }

  show(comparison: Comparison | null): void {
    this.#comparison = comparison;
    for (const [i, [, read]] of ROWS.entries()) {
      const plans = comparison ? [comparison.here, comparison.there] : [null, null];
      for (const [k, plan] of plans.entries())
        setText(this.#cells[i][k], plan ? read(plan, this.#unit) : UNKNOWN);
    }
    setText(this.#overlap, comparison ? `${(100 * comparison.iou).toFixed(1)} %` : UNKNOWN);
    const { distance } = comparison ?? { distance: Infinity };
    setText(this.#distance, Number.isFinite(distance) ? formatLength(distance, this.#unit) : UNKNOWN);
    setText(this.#subject, SUBJECTS[comparison?.subject ?? 'primary']);
  }
}

/** The colour of a side in the picture. */
function swatch(side: 0 | 1): HTMLElement {
  const node = make('span', { class: 'swatch' });
  node.style.setProperty('--swatch', clusterColour(side));
  return node;
}

function head(label: string): HTMLElement {
  return make('th', { scope: 'row' }, label);
}
