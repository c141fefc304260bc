import type { Warning } from '../core/types.ts';
import { icon } from './icon.ts';
import { make, setAttribute, setText } from './make.ts';
import type { Panel } from './model.ts';
import { sayLabels } from './plain-words.ts';

/** More than this would push the steps out of sight; the rest waits behind a button. */
const SHOWN_AT_ONCE = 2;

/** What a person can do about a warning at once. */
export interface WarningAct {
  readonly label: string;
  run(): void;
}

/** Everything about this plan that wants attention, in one quiet place, with what to try. @param acts by a warning's code */
export function makeWarningsList(acts: Readonly<Record<string, WarningAct>>): Panel {
  const list = make('ul', { id: 'warnings' });
  const more = make('button', {
    type: 'button',
    class: 'more-warnings',
    'aria-controls': 'warnings',
    on: { click: () => unfold(more.getAttribute('aria-expanded') !== 'true') },
  });
  const unfold = (isOpen: boolean) => {
    const rest = [...list.children].slice(SHOWN_AT_ONCE) as HTMLElement[];
    for (const item of rest) item.hidden = !isOpen;
    more.hidden = rest.length === 0;
    setAttribute(more, 'aria-expanded', String(isOpen));
    setText(more, isOpen ? 'Show fewer' : `Show ${rest.length} more`);
  };
  const node = make('section', { class: 'warnings', 'aria-label': 'Warnings', hidden: true }, list, more);
  let shown = '';
  return {
    node,
    show({ view, notices }) {
      const warnings = [...notices, ...(view?.report.warnings ?? [])];
      const key = JSON.stringify(warnings);
      if (key === shown) return;
      shown = key;
      node.hidden = warnings.length === 0;
      list.replaceChildren(...warnings.map((warning) => makeItem(warning, acts[warning.code])));
      unfold(false);
    },
  };
}

function makeItem({ code, message, hint }: Warning, act?: WarningAct): HTMLElement {
  const words = make('div', {}, make('p', {}, sayLabels(message)));
  if (hint) words.append(make('p', { class: 'hint' }, sayLabels(hint)));
  if (act) words.append(make('button', { type: 'button', class: 'link', on: { click: act.run } }, act.label));
  return make('li', { 'data-code': code }, icon('warning'), words);
}
