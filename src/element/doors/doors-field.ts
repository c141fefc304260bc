import { type Doors, formatDoors, parseDoors } from '../../core/doors.ts';
import type { Field, FieldFacts } from '../field.ts';
import { make, setAttribute } from '../make.ts';
import type { Actions } from '../model.ts';
import { makeInvitation } from '../tools.ts';
import { makeDoorList } from './door-list.ts';

/** The way to the tool in the drawing, every gap and door with a button, and the doors cut by hand as text. */
export function doorsField({ id, row, change }: FieldFacts, actions: Actions): Field {
  let pixelsPerMetre: number | null = null;
  const gaps = make('input', { type: 'checkbox', on: { change: () => read() } });
  const cuts = make('input', {
    type: 'text',
    id,
    placeholder: 'x,y,width; x,y,width,height',
    spellcheck: 'false',
    'aria-describedby': `${id}-hint`,
    on: { change: () => read() },
  });
  const read = () => {
    const text = cuts.value.trim();
    const given = parsed(text === '' ? 'none' : text, pixelsPerMetre);
    setAttribute(cuts, 'aria-invalid', given === null ? 'true' : null);
    if (given !== null) change(formatDoors({ gaps: gaps.checked || given.gaps, cuts: given.cuts }), true);
  };
  const label = make('label', { class: 'auto' }, gaps, 'Cut all gaps');
  const list = makeDoorList(actions);
  const invitation = makeInvitation('doors', actions);
  const line = make('div', { class: 'doors-line' }, label, invitation.node);
  const node = make(
    'div',
    { class: 'doors-field', role: 'group', 'aria-label': row.label },
    line,
    list.node,
    cuts,
  );
  return {
    node,
    set(value, model) {
      const doors = parseDoors(String(value));
      gaps.checked = doors.gaps;
      pixelsPerMetre = model.options.pixelsPerMetre;
      list.show(model);
      invitation.show(model);
      // Text under the hand is not overwritten.
      if (cuts.matches(':focus')) return;
      cuts.removeAttribute('aria-invalid');
      cuts.value = doors.cuts.length === 0 ? '' : formatDoors({ gaps: false, cuts: doors.cuts });
    },
  };
}

function parsed(text: string, pixelsPerMetre: number | null): Doors | null {
  try {
    return parseDoors(text, pixelsPerMetre);
  } catch {
    return null;
  }
}
