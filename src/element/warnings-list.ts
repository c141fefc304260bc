import type { Warning } from '../core/types.ts';
import { icon } from './icon.ts';
import { make } from './make.ts';
import type { Panel } from './model.ts';

/** Everything about this plan that wants attention, in one quiet place, with what to try. */
export function makeWarningsList(): Panel {
  const list = make('ul', {});
  const node = make('section', { class: 'warnings', 'aria-label': 'Warnings', hidden: true }, list);
  let shown = '';
  return {
    node,
    show({ view, notices }) {
      const warnings = [...notices, ...(view?.report.warnings ?? [])];
      const key = JSON.stringify(warnings);
      if (key === shown) return;
      shown = key;
      node.hidden = warnings.length === 0;
      list.replaceChildren(...warnings.map(makeItem));
    },
  };
}

function makeItem({ code, message, hint }: Warning): HTMLElement {
  const words = make('div', {}, make('p', {}, message), hint ? make('p', { class: 'hint' }, hint) : null);
  return make('li', { 'data-code': code }, icon('warning'), words);
}
