import type { ParamRow } from '../core/param-rows.ts';
import { type GivenValues, PARAMS, type ParamName } from '../core/params.ts';
import { classesField } from './classes-field.ts';
import { doorsField } from './doors/doors-field.ts';
import type { Field, FieldFacts } from './field.ts';
import { icon } from './icon.ts';
import { listField } from './list-field.ts';
import { make, setAttribute } from './make.ts';
import type { Actions, Panel } from './model.ts';
import { numberField } from './number-field.ts';
import { sayChoice } from './plain-words.ts';

/** The control of a parameter, made from its row: number, auto-number, flag, choice, choice-list, doors, classes. */
export function makeControl(name: ParamName, actions: Actions): Panel {
  const row: ParamRow = PARAMS[name];
  const id = `param-${name}`;
  const change = (value: unknown, isFinal: boolean) =>
    actions.change({ [name]: value } as GivenValues, isFinal);
  const field = makeField({ id, name, row, change }, actions);
  const reset = make(
    'button',
    {
      type: 'button',
      class: 'icon-button reset',
      'aria-label': `Reset ${row.label}`,
      title: 'Reset',
      on: { click: () => actions.reset([name]) },
    },
    icon('reset'),
  );
  const label = make('label', { for: id, class: 'control-label' }, row.label);
  const help = make('p', { class: 'hint', id: `${id}-hint` }, row.doc);
  const head = make('div', { class: 'control-head' }, label, reset);
  const node = make(
    'div',
    { class: `control control-${row.kind}`, 'data-param': name },
    head,
    field.node,
    help,
  );
  return {
    node,
    show(model) {
      reset.hidden = model.given[name] === undefined;
      field.set(model.options[name], model);
      setAttribute(node, 'data-given', model.given[name] !== undefined);
    },
  };
}

function makeField(facts: FieldFacts, actions: Actions): Field {
  switch (facts.row.kind) {
    case 'number':
    case 'auto-number':
      return numberField(facts, facts.row);
    case 'flag':
      return flagField(facts);
    case 'choice':
      return choiceField(facts, facts.row.choices);
    case 'choice-list':
      return listField(facts, facts.row.choices);
    case 'doors':
      return doorsField(facts, actions);
    case 'classes':
      return classesField(facts);
    case 'level':
      throw new TypeError('The level has a picker of its own.');
  }
}

function flagField({ id, change }: FieldFacts): Field {
  const box = make('input', {
    type: 'checkbox',
    id,
    class: 'switch',
    'aria-describedby': `${id}-hint`,
    on: { change: () => change(box.checked, true) },
  });
  return {
    node: box,
    set(value) {
      box.checked = value === true;
    },
  };
}

function choiceField({ id, change }: FieldFacts, choices: readonly string[]): Field {
  const select = make(
    'select',
    { id, 'aria-describedby': `${id}-hint`, on: { change: () => change(select.value, true) } },
    ...choices.map((choice) => make('option', { value: choice }, sayChoice(choice))),
  );
  return {
    node: select,
    set(value) {
      select.value = String(value);
    },
  };
}
