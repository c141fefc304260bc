import type { Actions, Tool } from './model.ts';
import { TOOL_NAMES, TOOLS } from './tools.ts';

/** Keys that leaf through the steps. */
const STEPS: Readonly<Record<string, 1 | -1>> = { '[': -1, ']': 1 };

/** What decides on the meaning of a key. */
export interface KeySituation {
  /** In hand. */
  readonly tool: Tool | null;
  /** A step's picture is shown. */
  readonly isStepping: boolean;
  /** Tools can be taken up. */
  readonly hasTools: boolean;
}

/** Does what a key pressed within the element asks for: tools, steps, undo and redo. */
export function pressKey(
  event: KeyboardEvent,
  { tool, isStepping, hasTools }: KeySituation,
  actions: Actions,
): void {
  const [target] = event.composedPath();
  if (event.key === 'Escape' && tool) actions.takeTool(null);
  // In a field the browser's own undo comes first.
  if (target instanceof HTMLInputElement && ['number', 'text'].includes(target.type)) return;
  const by = STEPS[event.key];
  if (by && isStepping) actions.moveStep(by);
  const letter = event.key.toLowerCase();
  const isPlain = !event.ctrlKey && !event.metaKey && !event.altKey;
  // In a list a letter chooses.
  const isForTools = isPlain && hasTools && !(target instanceof HTMLSelectElement);
  const taken = isForTools && TOOL_NAMES.find((name) => TOOLS[name].key.toLowerCase() === letter);
  if (taken) actions.takeTool(taken === tool ? null : taken);
  if (letter !== 'z' || !(event.ctrlKey || event.metaKey)) return;
  event.preventDefault();
  if (event.shiftKey) actions.redo();
  else actions.undo();
}
