import { sayCrs, sayScale } from '../core/source-coordinates.ts';
import { formatCount } from '../view/measure.ts';
import type { Layout } from './contract.ts';
import { makeFileChoice } from './file-choice.ts';
import { OPENED } from './formats.ts';
import { icon } from './icon.ts';
import { make, setText } from './make.ts';
import type { Actions, Model, Panel } from './model.ts';
import { makeSwitch } from './switch.ts';

const LAYOUT_LABELS: Readonly<Record<Layout, string>> = { '2d': 'Plan', split: 'Both', '3d': 'Model' };

/** The bar along the top: opening, the facts of the scan, which views are shown and in which unit. */
export function makeBar(actions: Actions): Panel {
  const facts = make('p', { class: 'facts' });
  const choice = makeFileChoice(actions);
  const layout = makeSwitch('View', LAYOUT_LABELS, (choice) => actions.setLayout(choice));
  const unit = makeSwitch('Unit', { m: 'm', ft: 'ft' }, (choice) => actions.setUnit(choice));
  layout.node.classList.add('layouts');
  unit.node.classList.add('units');
  const node = make(
    'div',
    { class: 'bar', part: 'bar' },
    make('slot', { name: 'bar-start' }),
    makeOpenButton(actions),
    make('slot', { name: 'bar-middle' }),
    choice.node,
    facts,
    layout.node,
    unit.node,
    make('slot', { name: 'bar-end' }),
  );
  return {
    node,
    show(model) {
      choice.show(model);
      setText(facts, factsOf(model));
      layout.set(model.layout);
      unit.set(model.unit);
    },
  };
}

/** A file input under a label: the picker of the platform, one click away. */
export function makeOpenButton(actions: Actions, testid = 'file-input'): HTMLLabelElement {
  const input = make('input', {
    type: 'file',
    class: 'visually-hidden',
    testid,
    multiple: true,
    accept: OPENED.flatMap(({ extensions }) => extensions).join(','),
    on: {
      change: () => {
        if (input.files?.length) actions.open([...input.files]);
        // The same file may be picked again.
        input.value = '';
      },
    },
  });
  return make('label', { class: 'button open' }, input, icon('open'), make('span', {}, 'Open'));
}

function factsOf({ view, name }: Model): string {
  if (!view) return name;
  const { pointsKept, pointsRead, unit, metresPerUnit, up } = view.report.input;
  const { storeys, frame } = view.plan;
  return [
    view.report.input.name,
    ...(view.isSavedPlan ? ['saved plan'] : []),
    `${formatCount(pointsKept)} of ${formatCount(pointsRead)} points`,
    sayScale(unit, metresPerUnit),
    `${up} up`,
    ...(frame.crs === undefined ? [] : [sayCrs(frame.crs)]),
    storeys.length === 1 ? '1 storey' : `${storeys.length} storeys`,
  ].join(' · ');
}
