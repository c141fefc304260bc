import { type FormatRow, OPENED, SAVED } from '../element/formats.ts';
import { icon } from '../element/icon.ts';
import { make } from '../element/make.ts';

const SHORTCUTS = [
  ['+ −', 'Zoom the view that has the focus'],
  ['0', 'Show all of it'],
  ['Arrow keys', 'Move it'],
  ['Shift + arrow keys', 'Turn the model'],
  ['[ ]', 'Step before, next step, while going step by step'],
  ['D', 'Cut doors in the drawing: press a wall, a gap, or a door to take it away'],
  ['N', 'Name rooms in the drawing: press a room and type what it is called'],
  ['M', 'Measure, and set the scale by a known length'],
  ['C', 'Crop: drag a box around what is used of the scan'],
  ['Esc', 'Leave a tool, or a comparison'],
  ['Double click', 'Show all of the plan; go to a spot of the model'],
  ['Ctrl + Z, Ctrl + Shift + Z', 'Undo and redo a parameter'],
  ['?', 'This help'],
] as const;

const PRIVACY =
  'Scans are read and plans are made on this device. Nothing is uploaded, nothing is counted, no other server is asked.';

/** Shortcuts, formats, privacy. */
export function makeHelpDialog(): HTMLDialogElement {
  const close = make(
    'button',
    { type: 'button', 'aria-label': 'Close help', on: { click: () => dialog.close() } },
    icon('close'),
  );
  const dialog = make(
    'dialog',
    { class: 'help', 'aria-labelledby': 'help-title' },
    make('div', { class: 'help-head' }, make('h2', { id: 'help-title' }, 'Help'), close),
    make('h3', {}, 'Keys'),
    definitions(SHORTCUTS),
    make('h3', {}, 'Opens'),
    definitions(OPENED.map(describe)),
    make('h3', {}, 'Saves'),
    definitions(SAVED.map(describe)),
    make('h3', {}, 'The paper behind it'),
    make(
      'p',
      {},
      make('a', { href: './reproduction/index.html' }, 'Its figures and numbers, reproduced'),
      ' on sets like its own, with what each method makes of them.',
    ),
    make('h3', {}, 'Privacy'),
    make('p', {}, PRIVACY),
  );
  return dialog;
}

function describe({ label, doc, extensions }: FormatRow): readonly [string, string] {
  return [`${label} (${extensions.join(', ')})`, doc];
}

function definitions(rows: readonly (readonly [string, string])[]): HTMLElement {
  return make('dl', {}, ...rows.flatMap(([term, text]) => [make('dt', {}, term), make('dd', {}, text)]));
}
