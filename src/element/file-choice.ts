import { make } from './make.ts';
import type { Actions, Panel } from './model.ts';

const TOGETHER = 'all';

/** Which of several files opened together is shown: all as one scan, or one of them. */
export function makeFileChoice(actions: Actions): Panel {
  const list = make('select', {
    class: 'file-choice',
    testid: 'file-choice',
    'aria-label': 'Files opened together',
    title: 'All as one scan, or one of the files alone',
    hidden: true,
    on: { change: () => actions.pickFile(list.value === TOGETHER ? null : Number(list.value)) },
  });
  let shown: readonly string[] = [];
  return {
    node: list,
    show({ files: { names, picked } }) {
      list.hidden = names.length < 2;
      if (names !== shown) {
        shown = names;
        const each = names.map((name, i) => make('option', { value: String(i) }, name));
        list.replaceChildren(
          make('option', { value: TOGETHER }, `${names.length} files as one scan`),
          ...each,
        );
      }
      const value = picked === null ? TOGETHER : String(picked);
      if (list.value !== value) list.value = value;
    },
  };
}
