import { parseClasses } from '../core/classes.ts';
import type { Field, FieldFacts } from './field.ts';
import { make, setAttribute } from './make.ts';

/** Class codes as text; what is none is marked and not taken. */
export function classesField({ id, change }: FieldFacts): Field {
  const codes = make('input', {
    type: 'text',
    id,
    placeholder: 'all',
    spellcheck: 'false',
    'aria-describedby': `${id}-hint`,
    on: { change: () => read() },
  });
  const read = () => {
    const text = codes.value.trim() || 'all';
    const isSound = isClasses(text);
    setAttribute(codes, 'aria-invalid', !isSound);
    if (isSound) change(text, true);
  };
  return {
    node: codes,
    set(value) {
      // Text under the hand is not overwritten.
      if (codes.matches(':focus')) return;
      codes.removeAttribute('aria-invalid');
      codes.value = String(value);
    },
  };
}

function isClasses(text: string): boolean {
  try {
    parseClasses(text);
    return true;
  } catch {
    return false;
  }
}
