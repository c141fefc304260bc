import { SAVED } from './formats.ts';
import { icon } from './icon.ts';
import { make } from './make.ts';
import type { Actions, Panel } from './model.ts';

/** Every format as a button: one click, one file. */
export function makeExportMenu(actions: Actions): Panel {
  const buttons = SAVED.map(({ name, label, doc }) =>
    make(
      'button',
      {
        type: 'button',
        class: 'export',
        testid: `export-${name}`,
        title: doc,
        disabled: true,
        on: { click: () => actions.save(name) },
      },
      label,
    ),
  );
  const head = make('h2', { class: 'section-head' }, icon('download'), 'Export');
  const node = make(
    'section',
    { class: 'exports', 'aria-label': 'Export' },
    head,
    make('div', { class: 'export-buttons' }, ...buttons),
  );
  return {
    node,
    show({ view }) {
      for (const button of buttons) button.disabled = view === null;
    },
  };
}
