import { FloorPlanError } from '../core/errors.ts';
import { icon } from './icon.ts';
import { make, setText } from './make.ts';
import type { Actions, Panel } from './model.ts';
import { sayLabels, saySentence } from './plain-words.ts';

/** What went wrong, where, and one thing to try. */
export function makeErrorPanel(actions: Actions): Panel {
  const code = make('code', { class: 'error-code' });
  const message = make('p', { class: 'error-message' });
  const hint = make('p', { class: 'error-hint' });
  const before = make(
    'button',
    {
      type: 'button',
      class: 'button step-before',
      testid: 'step-before',
      on: { click: () => actions.turnSteps('failed') },
    },
    'Show the step before',
  );
  const close = make(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': 'Close', on: { click: () => actions.dismiss() } },
    icon('close'),
  );
  const node = make(
    'section',
    { class: 'error-panel', part: 'error', testid: 'error', role: 'alert', hidden: true },
    icon('alert'),
    make('div', { class: 'error-words' }, message, hint, code, before),
    close,
  );
  return {
    node,
    show({ error, failed }) {
      node.hidden = error === null;
      before.hidden = !failed || failed.error !== error || failed.pictures.length === 0;
      if (!error) return;
      const known = error instanceof FloorPlanError;
      setText(message, saySentence(error.message));
      setText(
        hint,
        known ? sayLabels(error.hint) : 'This is a bug. Please report it with the file, if you can share it.',
      );
      setText(code, known ? error.code : 'bug');
    },
  };
}
