import { formatCrop, parseCrop } from '../../core/crop-box.ts';
import type { Field, FieldFacts } from '../field.ts';
import { make, setAttribute } from '../make.ts';
import type { Actions } from '../model.ts';
import { makeInvitation } from '../tools.ts';

/** The way to the tool in the drawing, and the box as text. */
export function cropField({ id, change }: FieldFacts, actions: Actions): Field {
  const box = make('input', {
    type: 'text',
    id,
    placeholder: 'x0,y0,x1,y1[,z0,z1][@heading]',
    spellcheck: 'false',
    'aria-describedby': `${id}-hint`,
    on: { change: () => read() },
  });
  const read = () => {
    const text = box.value.trim();
    const given = normalised(text === '' ? 'none' : text);
    setAttribute(box, 'aria-invalid', given === null ? 'true' : null);
    if (given !== null) change(given, true);
  };
  return {
    node: make('div', { class: 'with-tool' }, box, makeInvitation('crop', actions)),
    set(value) {
      // Text under the hand is not overwritten.
      if (box.matches(':focus')) return;
      box.removeAttribute('aria-invalid');
      box.value = value === 'none' ? '' : String(value);
    },
  };
}

/** Null where it is no box. */
function normalised(text: string): string | null {
  try {
    return formatCrop(parseCrop(text));
  } catch {
    return null;
  }
}
