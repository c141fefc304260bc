import { outlineParams } from '../core/options.ts';
import { makeChoiceAbove } from './above-stages.ts';
import { make, setText } from './make.ts';
import type { Actions, Model, Panel } from './model.ts';
import { sayLabel } from './plain-words.ts';

/** What the plan is made of, and which parameter of the outline made it so. */
export function makePlanMethodPicker(actions: Actions): Panel {
  const words = make('p', { class: 'hint', testid: 'plan-method-words', role: 'status' });
  const picker = makeChoiceAbove('planMethod', words, (planMethod) => actions.change({ planMethod }, true));
  return {
    node: picker.node,
    show(model) {
      const { given, options } = model;
      // The preset `paper` sets it too.
      const isAuto = given.planMethod === 'auto' || (!given.planMethod && options.preset !== 'paper');
      picker.set(isAuto ? 'auto' : options.planMethod);
      setText(words, wordsFor(model, isAuto));
    },
  };
}

function wordsFor({ given, options, view }: Model, isAuto: boolean): string {
  if (!view) return '';
  const asking = outlineParams(given).map(sayLabel).join(', ');
  if (isAuto && options.planMethod === 'outline')
    return `Now: the outline, because of ${asking}. Press Rooms to go back.`;
  const hasRooms = view.plan.storeys.some(({ rooms }) => rooms.length > 0);
  if (hasRooms && asking) return `Without effect on rooms: ${asking}.`;
  return isAuto ? `Now: ${hasRooms ? 'rooms' : 'the outline'}.` : '';
}
