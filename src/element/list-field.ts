import type { Field, FieldFacts } from './field.ts';
import { make } from './make.ts';
import { sayChoice } from './plain-words.ts';

/** One choice for each secondary boundary, in order; the last choice holds for all that follow. */
export function listField({ id, change }: FieldFacts, choices: readonly string[]): Field {
  const node = make('div', { class: 'list-field', id, role: 'group', 'aria-describedby': `${id}-hint` });
  const selects: HTMLSelectElement[] = [];
  const read = () =>
    change(
      selects.map(({ value }) => value),
      true,
    );
  const grow = (count: number) => {
    while (selects.length > count) selects.pop()!.parentElement!.remove();
    while (selects.length < count) {
      const select = make(
        'select',
        { on: { change: read } },
        ...choices.map((choice) => make('option', { value: choice }, sayChoice(choice))),
      );
      selects.push(select);
      node.append(make('label', {}, make('span', {}, `Structure ${selects.length}`), select));
    }
  };
  return {
    node,
    set(value, { options }) {
      const given = value as readonly string[];
      const { secondaryCount } = options;
      grow(Math.max(1, secondaryCount === 'auto' ? given.length : secondaryCount));
      for (const [i, select] of selects.entries()) select.value = given[Math.min(i, given.length - 1)];
    },
  };
}
