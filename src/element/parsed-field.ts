import type { Field, FieldFacts } from './field.ts';
import { make, setAttribute } from './make.ts';
import type { Actions, Tool } from './model.ts';
import { makeInvitation } from './tools.ts';

/** How a parameter that is text of a form of its own is edited. */
export interface ParsedText {
  readonly placeholder: string;
  /** The value that an empty field stands for. */
  readonly empty: string;
  /** The text as it is kept. @throws where it is of another form */
  parse(text: string): string;
}

/** A parameter as text; what is of another form is marked and not taken. */
export function parsedField(
  { id, change }: FieldFacts,
  { placeholder, empty, parse }: ParsedText,
): Field & { readonly node: HTMLInputElement } {
  const input = make('input', {
    type: 'text',
    id,
    placeholder,
    dir: 'auto',
    spellcheck: 'false',
    'aria-describedby': `${id}-hint`,
    on: { change: () => read() },
  });
  const read = () => {
    const text = parsed(input.value.trim() || empty, parse);
    setAttribute(input, 'aria-invalid', text === null ? 'true' : null);
    if (text !== null) change(text, true);
  };
  return {
    node: input,
    set(value) {
      // Text under the hand is not overwritten.
      if (input.matches(':focus')) return;
      input.removeAttribute('aria-invalid');
      input.value = value === empty ? '' : String(value);
    },
  };
}

/** A field with the way to the tool in the drawing that does the same. */
export function withTool(field: Field, tool: Tool, actions: Actions): Field {
  const invitation = makeInvitation(tool, actions);
  return {
    node: make('div', { class: 'with-tool' }, field.node, invitation.node),
    set(value, model) {
      field.set(value, model);
      invitation.show(model);
    },
  };
}

/** Null where it is of another form. */
function parsed(text: string, parse: ParsedText['parse']): string | null {
  try {
    return parse(text);
  } catch {
    return null;
  }
}
