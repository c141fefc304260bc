import type { LevelChoice } from '../core/param-rows.ts';
import type { Level } from '../core/types.ts';
import { formatBand, formatCount, formatDensity, fromMetres, toMetres } from '../view/measure.ts';
import type { DisplayUnit } from '../write/sheet/measure-words.ts';
import { icon } from './icon.ts';
import { make, setAttribute, setText } from './make.ts';
import type { Actions, Panel } from './model.ts';

/** Highest on top, as in the building. */
const ORDER = [2, 1, 0] as const;

/** The three height levels of [Stojanovic19] §3 with their counts and densities, and a band of one's own. */
export function makeLevelPicker(actions: Actions): Panel {
  const pick = (level: LevelChoice) => actions.change({ level }, true);
  const rows = ORDER.map((index) => makeLevel(index, () => pick(`${index}`)));
  const band = makeBand(pick);
  const node = make('div', { class: 'level-picker' }, ...rows.map((row) => row.node), band.node);
  return {
    node,
    show(model) {
      const { view, unit } = model;
      const levels = view?.levels ?? [];
      const densest = Math.max(...levels.map(({ densityPerM2 }) => densityPerM2), Number.EPSILON);
      for (const [i, index] of ORDER.entries()) rows[i].show(levels[index], densest, unit);
      band.show(model);
    },
  };
}

/** Back to the level found, or a height band of one's own. */
function makeBand(pick: (level: LevelChoice) => void): Panel {
  const auto = make(
    'button',
    { type: 'button', class: 'chip', 'aria-pressed': 'true', on: { click: () => pick('auto') } },
    'Auto',
  );
  let shownUnit: DisplayUnit | null = null;
  let shownLevel: LevelChoice | null = null;
  const suffix = make('span', { class: 'unit' });
  const low = bandField('From');
  const high = bandField('to');
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    const [from, to] = [low, high].map((field) => toMetres(field.valueAsNumber, shownUnit ?? 'm'));
    if (from < to) pick(`${from}:${to}`);
    else high.focus();
  };
  const node = make(
    'form',
    { class: 'band', 'aria-label': 'Height band above the floor', on: { submit } },
    auto,
    make('label', {}, 'From', low),
    make('label', {}, 'to', high),
    suffix,
    make('button', { type: 'submit', class: 'chip' }, 'Use'),
  );
  return {
    node,
    show({ options, unit }) {
      setAttribute(auto, 'aria-pressed', String(options.level === 'auto'));
      // What is being typed stays until the band or its unit is another.
      if (unit === shownUnit && options.level === shownLevel) return;
      [shownUnit, shownLevel] = [unit, options.level];
      setText(suffix, unit);
      const [from, to] = options.level.includes(':') ? options.level.split(':') : ['', ''];
      for (const [field, metres] of [
        [low, from],
        [high, to],
      ] as const) {
        field.value = metres === '' ? '' : String(fromMetres(Number(metres), unit));
      }
    },
  };
}

function makeLevel(index: number, onPick: () => void) {
  const name = make('span', { class: 'level-name' }, `Level ${index}`);
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
    name,
    range,
    points,
    density,
  );
  return {
    node,
    show(level: Level | undefined, densest: number, unit: DisplayUnit) {
      node.disabled = !level || level.points === 0;
      setAttribute(node, 'aria-pressed', String(level?.chosen ?? false));
      setText(range, level ? rangeOf(level, unit) : '');
      setText(points, level ? `${formatCount(level.points)} points` : '');
      setText(density, level ? formatDensity(level.densityPerM2, unit) : '');
      node.style.setProperty('--density', String(level ? level.densityPerM2 / densest : 0));
    },
  };
}

/** A ready slice has no heights. */
function rangeOf({ low, high, points }: Level, unit: DisplayUnit): string {
  if (low < high) return formatBand(low, high, unit);
  return points > 0 ? 'The slice as it came' : 'Nothing here';
}

function bandField(name: string): HTMLInputElement {
  return make('input', {
    type: 'number',
    step: 'any',
    required: true,
    'aria-label': `${name}, above the floor`,
  });
}
