import { makeOpenButton } from './bar.ts';
import { OPENED } from './formats.ts';
import { make, setAttribute } from './make.ts';
import type { Actions, Panel } from './model.ts';

/** The invitation shown while there is no scan. */
export function makeEmptyState(actions: Actions, poster: () => string | null): Panel {
  const picture = make('img', { class: 'poster', part: 'poster', alt: '', hidden: true });
  const words = make(
    'div',
    { class: 'invitation' },
    make('h2', {}, 'Drop a scan, get its floor plan'),
    make(
      'p',
      {},
      'A point cloud of rooms, from a laser scanner, a phone or a tablet. Nothing leaves your browser.',
    ),
    makeOpenButton(actions, 'file-input-empty'),
    make('slot', { name: 'empty' }),
    make('p', { class: 'hint' }, `Reads ${OPENED.flatMap(({ extensions }) => extensions).join(', ')}.`),
  );
  const node = make('div', { class: 'empty' }, picture, words);
  return {
    node,
    show({ view, state, steps }) {
      const url = poster();
      node.hidden = view !== null || steps.picture !== null || (state === 'loading' && !url);
      words.hidden = state === 'loading';
      picture.hidden = !url || view !== null;
      if (url) setAttribute(picture, 'src', url);
    },
  };
}
