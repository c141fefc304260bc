import type { PlanView } from '../worker/protocol.ts';
import { zipOf } from '../write/formats.ts';
import type { FormatGroup } from '../write/plan-writer.ts';
import { SAVED, type SavedRow } from './formats.ts';
import { icon } from './icon.ts';
import { make, setAttribute, setText } from './make.ts';
import type { Actions, Panel } from './model.ts';

const GROUPS: Record<FormatGroup, string> = { drawing: 'Drawing', model: 'Model', data: 'Data' };

/** Every format as a button, by what it is for: one click, one file; or several chosen, one ZIP. */
export function makeExportMenu(actions: Actions): Panel {
  const buttons = SAVED.map((row) => ({
    row,
    button: makeButton(`export-${row.name}`, () => press(row.name)),
  }));
  const choose = makeButton('choose-exports', () => {
    chosen = chosen === null ? new Set() : null;
    showAll();
  });
  choose.title = 'Choose formats to go in one ZIP.';
  /** Null while a click saves at once. */
  let chosen: Set<string> | null = null;
  let view: PlanView | null = null;

  const press = (name: string) => {
    if (chosen === null) return actions.save(name);
    if (name === 'zip') return actions.save(zipOf([...chosen]));
    if (!chosen.delete(name)) chosen.add(name);
    showAll();
  };
  const showAll = () => {
    for (const { row, button } of buttons) {
      const lacking = view && lackingFor(row, view);
      const isEmpty = row.name === 'zip' && chosen?.size === 0;
      button.disabled = view === null || lacking !== null || isEmpty;
      button.title = lacking ?? row.doc;
      if (row.name === 'zip') setText(button, chosen === null ? row.label : `ZIP of ${chosen.size}`);
      else {
        setText(button, row.label);
        setAttribute(button, 'aria-pressed', chosen && String(chosen.has(row.name)));
      }
    }
    choose.disabled = view === null;
    setText(choose, chosen === null ? 'Choose…' : 'One by one');
  };
  const groups = Object.entries(GROUPS).map(([group, label]) => {
    const own = buttons.filter(({ row }) => row.group === group).map(({ button }) => button);
    return make(
      'div',
      { class: 'export-group', role: 'group', 'aria-label': label },
      make('span', { class: 'export-kind', 'aria-hidden': 'true' }, label),
      make('div', { class: 'export-buttons' }, ...own, group === 'data' ? choose : null),
    );
  });
  const head = make('h2', { class: 'section-head' }, icon('download'), 'Export');
  const node = make('section', { class: 'exports', 'aria-label': 'Export' }, head, ...groups);
  return {
    node,
    show(model) {
      view = model.view;
      showAll();
    },
  };
}

function makeButton(testid: string, click: () => void): HTMLButtonElement {
  return make('button', { type: 'button', class: 'export', testid, on: { click } });
}

/** Why a plan cannot be saved as a format; null where it can. */
function lackingFor({ needs }: SavedRow, { isSavedPlan, plan }: PlanView): string | null {
  if (needs === 'points' && isSavedPlan) return 'Only with the scan: a saved plan has no points.';
  if (needs === 'crs' && plan.frame.crs === undefined) return 'The scan names no coordinate system.';
  return null;
}
