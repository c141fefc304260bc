import { parseClasses } from '../core/classes.ts';
import { CROP_FORM, formatCrop, parseCrop } from '../core/crop-box.ts';
import type { ParamRow, TextRow } from '../core/param-rows.ts';
import { type GivenValues, PARAMS, type ParamName } from '../core/params.ts';
import { formatRoomNames, parseRoomNames, ROOM_NAME_WORDS } from '../core/room-names.ts';
import { doorsField } from './doors/doors-field.ts';
import type { Field, FieldFacts } from './field.ts';
import { icon } from './icon.ts';
import { listField } from './list-field.ts';
import { make, setAttribute, setText } from './make.ts';
import type { Actions, Model, Panel } from './model.ts';
import { numberField } from './number-field.ts';
import { type ParsedText, parsedField, withTool } from './parsed-field.ts';
import { sayChoice } from './plain-words.ts';

/** Why a value that was found for the scan is what it is, beside the control that changes it. */
const REASONS: Readonly<Partial<Record<ParamName, (model: Model) => string | undefined>>> = {
  unit: ({ view }) => view?.reasons.unit,
  up: ({ view }) => view?.reasons.up,
};

/** A unit named by hand ends a scale set by hand, which would count for more. */
const TAKES_PLACE_OF: Readonly<Partial<Record<ParamName, object>>> = { unit: { metresPerUnit: undefined } };

const CLASSES: ParsedText = {
  placeholder: 'all',
  empty: 'all',
  parse(text) {
    parseClasses(text);
    return text;
  },
};
const CROP: ParsedText = {
  placeholder: CROP_FORM,
  empty: 'none',
  parse: (text) => formatCrop(parseCrop(text)),
};
const ROOM_NAMES: ParsedText = {
  placeholder: `${ROOM_NAME_WORDS};…`,
  empty: 'none',
  parse: (text) => formatRoomNames(parseRoomNames(text)),
};

/** The control of a parameter, made from its row: number, auto-number, flag, choice, choice-list, doors, classes, crop, room-names, text. */
export function makeControl(name: ParamName, actions: Actions): Panel {
  const row: ParamRow = PARAMS[name];
  const id = `param-${name}`;
  const change = (value: unknown, isFinal: boolean) =>
    actions.change({ [name]: value, ...(TAKES_PLACE_OF[name] ?? {}) } as GivenValues, isFinal);
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
  const reason = make('p', { class: 'reason', testid: `reason-${name}` });
  const help = make('p', { class: 'hint', id: `${id}-hint` }, row.doc);
  const head = make('div', { class: 'control-head' }, label, reset);
  const node = make(
    'div',
    { class: `control control-${row.kind}`, 'data-param': name },
    head,
    field.node,
    ...(name in REASONS ? [reason] : []),
    help,
  );
  return {
    node,
    show(model) {
      reset.hidden = model.given[name] === undefined;
      field.set(model.options[name], model);
      setText(reason, REASONS[name]?.(model) ?? '');
      setAttribute(node, 'data-given', model.given[name] !== undefined);
    },
  };
}

function makeField(facts: FieldFacts, actions: Actions): Field {
  switch (facts.row.kind) {
    case 'number':
    case 'auto-number': {
      const field = numberField(facts, facts.row);
      return facts.name === 'metresPerUnit' ? withTool(field, 'measure', actions) : field;
    }
    case 'flag':
      return flagField(facts);
    case 'choice':
      return choiceField(facts, facts.row.choices);
    case 'choice-list':
      return listField(facts, facts.row.choices);
    case 'doors':
      return doorsField(facts, actions);
    case 'classes':
      return parsedField(facts, CLASSES);
    case 'crop':
      return withTool(parsedField(facts, CROP), 'crop', actions);
    case 'room-names':
      return withTool(parsedField(facts, ROOM_NAMES), 'names', actions);
    case 'text':
      return textField(facts, facts.row);
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

function textField({ id, change }: FieldFacts, { longest }: TextRow): Field {
  const input = make('input', {
    type: 'text',
    id,
    maxlength: longest,
    'aria-describedby': `${id}-hint`,
    on: { change: () => change(input.value === '' ? undefined : input.value, true) },
  });
  return {
    node: input,
    set(value) {
      // What is being typed stays.
      if (!input.matches(':focus')) input.value = String(value);
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
