import type { StageName } from '../core/stages.ts';
import { icon } from './icon.ts';
import { make } from './make.ts';
import type { Actions, Panel } from './model.ts';

/** From a stage of the rail to the first of its pictures. */
export function makeStepLink(stage: StageName, actions: Actions): Panel {
  let target: string | null = null;
  const node = make(
    'button',
    {
      type: 'button',
      class: 'button step-link',
      testid: `show-${stage}`,
      hidden: true,
      on: { click: () => actions.showStep(target) },
    },
    icon('picture'),
    'Show this step',
  );
  return {
    node,
    show({ steps }) {
      target = steps.pictures.find((picture) => picture.stage === stage)?.name ?? null;
      node.hidden = target === null;
    },
  };
}
