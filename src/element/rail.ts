import { PARAM_NAMES, PARAMS, type ParamName } from '../core/params.ts';
import { STAGE_NAMES } from '../core/stages.ts';
import { iconButton } from './chips.ts';
import { makeExportMenu } from './export-menu.ts';
import { icon } from './icon.ts';
import { make, setAttribute } from './make.ts';
import type { Actions, Panel } from './model.ts';
import { makePlanMethodPicker } from './plan-method-picker.ts';
import { makePresetPicker } from './preset-picker.ts';
import { makeRunStatus } from './run-status.ts';
import { makeStageRow } from './stage-row.ts';
import { makeWarningsList } from './warnings-list.ts';

/** A panel that leads to any control. */
export interface Rail extends Panel {
  showControl(name: ParamName): void;
}

/** The run from top to bottom: how it stands, its stages with their parameters, its warnings, its exports. */
export function makeRail(actions: Actions): Rail {
  const unfold = makeUnfold((isOpen) => node.classList.toggle('is-open', isOpen));
  const status = makeRunStatus(actions);
  const warnings = makeWarningsList({
    'boundary/gap-bridged': {
      label: 'Make doors of gaps',
      run: () => showControl('doors', '.door-list button'),
    },
    'frame/unit-guessed': { label: 'Set the unit', run: () => showControl('unit') },
    'frame/up-guessed': { label: 'Set the up axis', run: () => showControl('up') },
  });
  const above = [makePresetPicker(actions), makePlanMethodPicker(actions)];
  const leading = foldingUp(actions, () => unfold.turn(false));
  const rows = STAGE_NAMES.map((stage) => makeStageRow(stage, leading));
  const showControl = (name: ParamName, selector = `#param-${name}`) => {
    unfold.turn(true);
    const row = rows[STAGE_NAMES.indexOf(PARAMS[name].stage)];
    openAt(row.node as HTMLDetailsElement, selector);
  };
  const exports = makeExportMenu(actions);
  const heading = makeHeading(actions);
  const stages = make('div', { class: 'stages' }, ...rows.map((row) => row.node));
  const top = make('div', { class: 'above-stages' }, ...above.map((choice) => choice.node));
  const body = make('div', { class: 'rail-body' }, warnings.node, heading.node, top, stages);
  const head = make('div', { class: 'rail-head' }, status.node, unfold.node);
  const node = make(
    'aside',
    { class: 'rail', part: 'rail', 'aria-label': 'Steps' },
    head,
    body,
    exports.node,
  );
  const panels = [status, warnings, heading, ...above, ...rows, exports];
  return {
    node,
    showControl: (name) => showControl(name),
    show(model) {
      for (const panel of panels) panel.show(model);
    },
  };
}

/** On a phone the rail is a sheet that this button unfolds. */
function makeUnfold(onTurn: (isOpen: boolean) => void) {
  const toggle = () => turn(node.getAttribute('aria-expanded') !== 'true');
  const node = make(
    'button',
    { type: 'button', class: 'button unfold', 'aria-expanded': 'false', on: { click: toggle } },
    'Steps',
    icon('chevron'),
  );
  const turn = (isOpen: boolean) => {
    setAttribute(node, 'aria-expanded', String(isOpen));
    onTurn(isOpen);
  };
  return { node, turn };
}

/** On a phone the rail lies over the picture it leads to. */
function foldingUp(actions: Actions, fold: () => void): Actions {
  return {
    ...actions,
    showStep: (name) => {
      fold();
      actions.showStep(name);
    },
    takeTool: (tool) => {
      fold();
      actions.takeTool(tool);
    },
  };
}

/** Over the steps: the way back, forth, and to the start. */
function makeHeading(actions: Actions): Panel {
  const undo = iconButton('Undo', icon('undo'), () => actions.undo());
  const redo = iconButton('Redo', icon('redo'), () => actions.redo());
  const reset = iconButton('Reset all parameters', icon('reset'), () => actions.reset(PARAM_NAMES));
  return {
    node: make('div', { class: 'section-head' }, make('h2', {}, 'Steps'), undo, redo, reset),
    show({ canUndo, canRedo, given }) {
      undo.disabled = !canUndo;
      redo.disabled = !canRedo;
      reset.disabled = Object.keys(given).length === 0;
    },
  };
}

/** Opens a stage and brings the keyboard to a control in it, whose parts are made when it first opens. */
function openAt(stage: HTMLDetailsElement, selector: string): void {
  const focus = () => stage.querySelector<HTMLElement>(selector)?.focus();
  if (stage.open) focus();
  else stage.addEventListener('toggle', focus, { once: true });
  stage.open = true;
}
