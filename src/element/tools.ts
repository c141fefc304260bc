import type { PlanView } from '../worker/protocol.ts';
import { type IconName, icon } from './icon.ts';
import { make, setAttribute } from './make.ts';
import type { Actions, Panel, Tool } from './model.ts';

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
  /** Why a plan does not take it; null where it does. */
  lacks(view: Pick<PlanView, 'plan' | 'isSavedPlan'>): string | null;
}

const DECIDED = 'A plan was opened without its scan: this was decided when it was made.';
/** Doors and crop are cut before the plan is made. */
const lacksScan: ToolRow['lacks'] = ({ isSavedPlan }) => (isSavedPlan ? DECIDED : null);

/** What a pointer can do in the drawing: chips, keys and the ways there from the steps. */
export const TOOLS: Readonly<Record<Tool, ToolRow>> = {
  doors: {
    symbol: 'door',
    label: 'Cut door',
    words: 'Cut doors in the drawing',
    key: 'D',
    testid: 'cut-doors',
    invitation: 'Cut in the drawing',
    lacks: lacksScan,
  },
  names: {
    symbol: 'tag',
    label: 'Name rooms',
    words: 'Name rooms in the drawing',
    key: 'N',
    testid: 'name-rooms',
    invitation: 'Name in the drawing',
    lacks: ({ plan }) =>
      plan.storeys.some(({ rooms }) => rooms.length > 0)
        ? null
        : 'This plan is one of outlines: there are no rooms to name.',
  },
  measure: {
    symbol: 'ruler',
    label: 'Measure',
    words: 'Measure, and set the scale by a known length',
    key: 'M',
    testid: 'measure',
    invitation: 'Measure a known length',
    lacks: () => null,
  },
  crop: {
    symbol: 'crop',
    label: 'Crop',
    words: 'Draw a box around what is used',
    key: 'C',
    testid: 'crop',
    invitation: 'Draw in the plan',
    lacks: lacksScan,
  },
};

export const TOOL_NAMES = Object.keys(TOOLS) as readonly Tool[];

/** The way from a field of the steps to a tool in the drawing; where the plan does not take the tool, it says why. */
export function makeInvitation(tool: Tool, actions: Actions): Panel {
  const { symbol, invitation, lacks } = TOOLS[tool];
  const node = make(
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
  return {
    node,
    show({ view }) {
      const why = view && lacks(view);
      node.disabled = why !== null;
      setAttribute(node, 'title', why);
    },
  };
}
