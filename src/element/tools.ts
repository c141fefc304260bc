import { type IconName, icon } from './icon.ts';
import { make } from './make.ts';
import type { Actions, Tool } from './model.ts';

interface ToolRow {
  readonly symbol: IconName;
  readonly label: string;
  /** What it does. */
  readonly words: string;
  /** Takes it up, and puts it down. */
  readonly key: string;
  readonly testid: string;
  /** From a field of the steps to the tool. */
  readonly invitation: string;
}

/** What a pointer can do in the drawing: chips, keys and the ways there from the steps. */
export const TOOLS: Readonly<Record<Tool, ToolRow>> = {
  doors: {
    symbol: 'door',
    label: 'Cut door',
    words: 'Cut doors in the drawing',
    key: 'D',
    testid: 'cut-doors',
    invitation: 'Cut in the drawing',
  },
  measure: {
    symbol: 'ruler',
    label: 'Measure',
    words: 'Measure, and set the scale by a known length',
    key: 'M',
    testid: 'measure',
    invitation: 'Measure a known length',
  },
  crop: {
    symbol: 'crop',
    label: 'Crop',
    words: 'Draw a box around what is used',
    key: 'C',
    testid: 'crop',
    invitation: 'Draw in the plan',
  },
};

export const TOOL_NAMES = Object.keys(TOOLS) as readonly Tool[];

/** The way from a field of the steps to a tool in the drawing. */
export function makeInvitation(tool: Tool, actions: Actions): HTMLButtonElement {
  const { symbol, invitation } = TOOLS[tool];
  return make(
    'button',
    {
      type: 'button',
      class: 'button in-drawing',
      testid: `${tool}-in-drawing`,
      on: { click: () => actions.takeTool(tool) },
    },
    icon(symbol),
    invitation,
  );
}
