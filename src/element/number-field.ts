import { resolveOptions } from '../core/options.ts';
import type { AutoNumberRow, NumberRow } from '../core/param-rows.ts';
import { PARAMS, type ParamName } from '../core/params.ts';
import type { Field, FieldFacts } from './field.ts';
import { make, setAttribute } from './make.ts';
import { fromTravel, hasSlider, toTravel } from './slider-scale.ts';

/** Fineness of a slider's travel. */
const TRAVEL_STEPS = 1000;

/**
 * A slider, a number field, and for auto-numbers a box that gives the choice back to the program. Lengths and areas may be
 * typed with a unit: 24mm.
 */
export function numberField(facts: FieldFacts, row: NumberRow | AutoNumberRow): Field {
  const { unit, label } = row;
  const { change } = facts;
  let pixelsPerMetre: number = PARAMS.pixelsPerMetre.default;
  const { node: number, isTyping } = makeTyped(facts, row, () => pixelsPerMetre);
  const slider = make('input', {
    type: 'range',
    min: 0,
    max: TRAVEL_STEPS,
    'aria-label': label,
    hidden: !hasSlider(row),
    on: {
      input: () => slide(false),
      change: () => slide(true),
    },
  });
  const slide = (isFinal: boolean) => {
    const value = fromTravel(slider.valueAsNumber / TRAVEL_STEPS, row);
    number.value = String(value);
    if (auto) auto.checked = false;
    change(value, isFinal);
  };
  const auto = row.kind === 'auto-number' ? makeAuto(label, () => toggle()) : null;
  const toggle = () => {
    if (auto?.checked) change('auto', true);
    // Without a slider there is no value to begin with but the one to be typed.
    else if (slider.hidden) number.focus();
    else slide(true);
  };
  const suffix = make('span', { class: 'unit' }, unit);
  const node = make('div', { class: 'number-field' }, auto?.parentElement ?? null, slider, number, suffix);
  return {
    node,
    set(value, { options }) {
      pixelsPerMetre = options.pixelsPerMetre;
      const isAuto = value === 'auto';
      if (auto) auto.checked = isAuto;
      node.classList.toggle('is-auto', isAuto);
      // Text under the hand is not overwritten.
      if (isTyping()) return;
      if (isAuto) number.value = '';
      if (isAuto || typeof value !== 'number') return;
      number.removeAttribute('aria-invalid');
      if (number.value.trim() === '' || Number(number.value) !== value) number.value = String(value);
      // A slider under the hand is not moved.
      if (!slider.matches(':active')) slider.valueAsNumber = toTravel(value, row) * TRAVEL_STEPS;
      slider.setAttribute('aria-valuetext', `${value} ${unit}`.trim());
    },
  };
}

/** The field for typing; what is typed counts once it is done. */
function makeTyped(
  { id, name, change }: FieldFacts,
  { min, max, step, unit }: NumberRow | AutoNumberRow,
  pixelsPerMetre: () => number,
) {
  const isQuantity = unit === 'm' || unit === 'm²';
  const isWhole = step % 1 === 0;
  let isTyping = false;
  const take = () => {
    isTyping = false;
    const value = isQuantity ? readQuantity(name, node.value, pixelsPerMetre()) : node.valueAsNumber;
    const isAllowed = value === 'auto' || (value >= min && value <= max);
    if (isAllowed) change(isWhole && value !== 'auto' ? Math.round(value) : value, true);
    setAttribute(node, 'aria-invalid', isAllowed ? null : 'true');
  };
  const node = make('input', {
    type: isQuantity ? 'text' : 'number',
    id,
    ...(!isQuantity && { min, max, step: 'any' }),
    // The decimal keyboard of a phone has no letters for a unit.
    inputmode: isQuantity ? null : isWhole ? 'numeric' : 'decimal',
    'aria-describedby': `${id}-hint`,
    on: {
      input: () => {
        isTyping = true;
      },
      blur: () => {
        isTyping = false;
      },
      change: take,
    },
  });
  return { node, isTyping: () => isTyping };
}

function makeAuto(label: string, onChange: () => void): HTMLInputElement {
  const box = make('input', { type: 'checkbox', 'aria-label': `${label}: auto`, on: { change: onChange } });
  make('label', { class: 'auto' }, box, 'Auto');
  return box;
}

/** Metres or square metres; NaN for what the parameter does not allow. */
function readQuantity(name: ParamName, text: string, pixelsPerMetre: number): number | 'auto' {
  try {
    return resolveOptions({ [name]: text.trim(), pixelsPerMetre })[name] as number | 'auto';
  } catch {
    return Number.NaN;
  }
}
