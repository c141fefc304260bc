import type { LevelChoice } from '../core/params.ts';
import type { Level } from '../core/types.ts';
import { type DisplayUnit, formatCount, formatLength } from '../view/measure.ts';
import { icon } from './icon.ts';
import { make, setAttribute, setText } from './make.ts';
import type { Actions, Panel } from './model.ts';

/** Highest on top, as in the building. */
const ORDER = [2, 1, 0] as const;

/** The three height levels of [Stojanovic19] §3 with their counts and densities, and a band of one's own. */
export function makeLevelPicker(actions: Actions): Panel {
  const pick = (level: LevelChoice) => actions.change({ level }, true);
  const rows = ORDER.map((index) => makeLevel(index, () => pick(`${index}`)));
  const auto = make(
    'button',
    { type: 'button', class: 'chip', 'aria-pressed': 'true', on: { click: () => pick('auto') } },
    'Auto',
  );
  const low = bandField('From');
  const high = bandField('to');
  const band = make(
    'form',
    {
      class: 'band',
      'aria-label': 'Height band above the floor',
      on: {
        submit: (event: SubmitEvent) => {
          event.preventDefault();
          const [from, to] = [low.valueAsNumber, high.valueAsNumber];
          if (from < to) pick(`${from}:${to}`);
          else high.focus();
        },
      },
    },
    auto,
    make('label', {}, 'From', low),
    make('label', {}, 'to', high),
    make('span', { class: 'unit' }, 'm'),
    make('button', { type: 'submit', class: 'chip' }, 'Use'),
  );
  const node = make('div', { class: 'level-picker' }, ...rows.map((row) => row.node), band);
  return {
    node,
    show({ view, options, unit }) {
      const levels = view?.levels ?? [];
      const densest = Math.max(...levels.map(({ densityPerM2 }) => densityPerM2), Number.EPSILON);
      for (const [i, index] of ORDER.entries()) rows[i].show(levels[index], densest, unit);
      setAttribute(auto, 'aria-pressed', String(options.level === 'auto'));
      const [from, to] = options.level.includes(':') ? options.level.split(':') : ['', ''];
      if (!low.matches(':focus')) low.value = from;
      if (!high.matches(':focus')) high.value = to;
    },
  };
}

function makeLevel(index: number, onPick: () => void) {
  const range = make('span', { class: 'level-range' });
  const points = make('span', { class: 'level-points' });
  const density = make('span', { class: 'level-density' });
  const node = make(
    'button',
    {
      type: 'button',
      class: 'level',
      testid: `level-${index}`,
      'aria-pressed': 'false',
      on: { click: onPick },
    },
    make('span', { class: 'level-mark' }, icon('check')),
    range,
    points,
    density,
  );
  return {
    node,
    show(level: Level | undefined, densest: number, unit: DisplayUnit) {
      node.disabled = !level || level.points === 0;
      setAttribute(node, 'aria-pressed', String(level?.chosen ?? false));
      setText(range, level ? rangeOf(level, unit) : `Level ${index}`);
      setText(points, level ? `${formatCount(level.points)} points` : '');
      setText(density, level ? `${formatCount(level.densityPerM2)} per m²` : '');
      node.style.setProperty('--density', String(level ? level.densityPerM2 / densest : 0));
    },
  };
}

/** A ready slice has no heights. */
function rangeOf({ low, high, points }: Level, unit: DisplayUnit): string {
  if (low < high) return `${formatLength(low, unit)} to ${formatLength(high, unit)}`;
  return points > 0 ? 'The slice as it came' : 'Nothing here';
}

function bandField(name: string): HTMLInputElement {
  return make('input', {
    type: 'number',
    step: 'any',
    required: true,
    'aria-label': `${name}, metres above the floor`,
  });
}
