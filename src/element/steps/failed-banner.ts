import { FloorPlanError } from '../../core/errors.ts';
import { STAGES } from '../../core/stages.ts';
import { icon } from '../icon.ts';
import { make, setText } from '../make.ts';
import type { Actions, Model, Panel } from '../model.ts';
import { sayLabels } from '../plain-words.ts';

/** Says that the pictures are of a run that failed, why it did and what to try, and leads back to the plan shown. */
export class FailedBanner implements Panel {
  readonly node: HTMLElement;
  readonly #words = make('p', {});
  readonly #hint = make('p', { class: 'hint' });
  readonly #back: HTMLButtonElement;

  constructor(actions: Actions) {
    const on = { click: () => actions.turnSteps('plan') };
    this.#back = make('button', { type: 'button', class: 'button', on }, 'Back to the plan');
    this.node = make(
      'section',
      { class: 'failed-banner', 'aria-label': 'The run that failed', hidden: true },
      icon('alert'),
      make('div', {}, this.#words, this.#hint),
      this.#back,
    );
  }

  show({ steps, failed, view }: Model): void {
    this.node.hidden = steps.of !== 'failed' || !failed;
    if (!failed) return;
    const { error, stage } = failed;
    setText(this.#words, `${STAGES[stage].label} failed: ${sayLabels(error.message)}`);
    setText(this.#hint, error instanceof FloorPlanError ? sayLabels(error.hint) : '');
    this.#back.hidden = view === null;
  }
}
