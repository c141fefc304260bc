import { parseDoors } from '../../core/doors.ts';
import { sayUnit } from '../../core/source-coordinates.ts';
import { formatLength } from '../../view/measure.ts';
import { make } from '../make.ts';
import type { Actions, Model, Panel } from '../model.ts';
import { lengthOf, type Stretch } from '../stretch.ts';
import { isLowest, PlanDoors } from './plan-doors.ts';

interface Entry {
  /** What it is, with its size. */
  readonly label: string;
  readonly place: string;
  readonly stretch: Stretch;
  /** The word on its button; null where no door fits. */
  readonly act: 'Make a door' | 'Remove' | null;
  /** The parameter `doors` after it. */
  readonly doors: string;
}

/** The gaps of the plan and its doors, each with a button: the way to doors without a pointer. */
export function makeDoorList(actions: Actions): Panel {
  const node = make('ul', { class: 'door-list', 'aria-label': 'Gaps and doors', hidden: true });
  let shown = '';
  return {
    node,
    show(model) {
      const entries = entriesOf(model);
      const key = JSON.stringify(entries);
      if (key === shown) return;
      shown = key;
      node.hidden = entries.length === 0;
      const place = placeOfFocus(node);
      actions.mark(null);
      node.replaceChildren(...entries.map((entry) => makeItem(entry, actions)));
      // The keyboard keeps its place when its button gives way to another.
      const buttons = node.querySelectorAll('button');
      if (place >= 0) buttons[Math.min(place, buttons.length - 1)]?.focus();
    },
  };
}

function entriesOf({ view, options, storey, unit }: Model): Entry[] {
  if (!view || !isLowest(view.plan, storey)) return [];
  const doors = new PlanDoors(view.plan, options.doors);
  const { cuts } = parseDoors(options.doors);
  const ofGaps = doors.gaps.map((gap): Entry => {
    const door = doors.inGap(gap);
    const label = `${door ? 'Door in a gap' : 'Gap'}, ${formatLength(gap.width, unit)} wide`;
    const opening = door?.opening ?? doors.fitGap(gap);
    const place = doors.sayPlace(gap);
    if (!opening) return { label, place, stretch: gap, act: null, doors: options.doors };
    if (!door) return { label, place, stretch: opening, act: 'Make a door', doors: doors.with(gap) };
    return { label, place, stretch: opening, act: 'Remove', doors: doors.without(door) };
  });
  const inGaps = doors.gaps.map((gap) => doors.inGap(gap));
  const byHand = doors.doors.filter((door) => !inGaps.includes(door));
  return [
    ...ofGaps,
    ...byHand.map((door): Entry => {
      const { opening, origin } = door;
      const size = [lengthOf(opening), opening.head].map((length) => formatLength(length, unit)).join(' × ');
      const { x, y } = cuts[origin.index];
      const place = `${x}, ${y} ${sayUnit(view.plan.frame.unit)}`;
      return {
        label: `Door, ${size}`,
        place,
        stretch: opening,
        act: 'Remove',
        doors: doors.without(door),
      };
    }),
  ];
}

function makeItem({ label, place, stretch, act, doors }: Entry, actions: Actions): HTMLElement {
  const mark = () => actions.mark(stretch);
  const unmark = () => actions.mark(null);
  const words = make('div', {}, make('p', {}, label), make('p', { class: 'hint' }, `at ${place}`));
  const button =
    act &&
    make(
      'button',
      {
        type: 'button',
        class: 'button',
        'aria-label': `${act}: ${label} at ${place}`,
        on: { click: () => actions.change({ doors }, true), focus: mark, blur: unmark },
      },
      act,
    );
  return make('li', { on: { pointerenter: mark, pointerleave: unmark } }, words, button);
}

function placeOfFocus(node: HTMLElement): number {
  const { activeElement } = node.getRootNode() as ShadowRoot | Document;
  return [...node.querySelectorAll('button')].indexOf(activeElement as HTMLButtonElement);
}
