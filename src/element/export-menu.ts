import type { PlanView } from '../worker/protocol.ts';
import type { FormatGroup } from '../write/plan-writer.ts';
import { SAVED, type SavedRow } from './formats.ts';
import { icon } from './icon.ts';
import { make } from './make.ts';
import type { Actions, Panel } from './model.ts';

const GROUPS: Record<FormatGroup, string> = { drawing: 'Drawing', model: 'Model', data: 'Data' };

/** Every format as a button, by what it is for: one click, one file. */
export function makeExportMenu(actions: Actions): Panel {
  const buttons: { row: SavedRow; button: HTMLButtonElement }[] = [];
  const makeButton = (row: SavedRow) => {
    const { name, label, doc } = row;
    const button = make(
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
    );
    buttons.push({ row, button });
    return button;
  };
  const groups = Object.entries(GROUPS).map(([group, label]) =>
    make(
      'div',
      { class: 'export-group', role: 'group', 'aria-label': label },
      make('span', { class: 'export-kind', 'aria-hidden': 'true' }, label),
      make('div', { class: 'export-buttons' }, ...SAVED.filter((row) => row.group === group).map(makeButton)),
    ),
  );
  const head = make('h2', { class: 'section-head' }, icon('download'), 'Export');
  const node = make('section', { class: 'exports', 'aria-label': 'Export' }, head, ...groups);
  return {
    node,
    show({ view }) {
      for (const { row, button } of buttons) {
        const lacking = view && lackingFor(row, view);
        button.disabled = view === null || lacking !== null;
        button.title = lacking ?? row.doc;
      }
    },
  };
}

/** Why a plan cannot be saved as a format; null where it can. */
function lackingFor({ needs }: SavedRow, { isSavedPlan, plan }: PlanView): string | null {
  if (needs === 'points' && isSavedPlan) return 'Only with the scan: a saved plan has no points.';
  if (needs === 'crs' && plan.frame.crs === undefined) return 'The scan names no coordinate system.';
  return null;
}
