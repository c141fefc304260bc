import { STAGES } from '../../core/stages.ts';
import { formatDuration } from '../../view/measure.ts';
import type { PictureFacts } from '../../worker/protocol.ts';
import { iconButton } from '../chips.ts';
import { icon } from '../icon.ts';
import { make, setAttribute, setText } from '../make.ts';
import type { Actions, StepsShown } from '../model.ts';
import { RoundChoice } from './round-choice.ts';

export interface CaptionEvents {
  /** The picture shown is to be saved as a file. */
  onSave(): void;
  /** Another round of the search is to be shown, from 1. */
  onRound(round: number): void;
}

/** What a picture shows: its place in the chain, the figure of the paper, its counts and time; and the way on. */
export class Caption {
  readonly node: HTMLElement;
  readonly #place = make('span', { class: 'caption-place' });
  readonly #label = make('span', { class: 'caption-label' });
  readonly #figure = make('span', { class: 'caption-figure' });
  readonly #outcome = make('p', { class: 'caption-outcome', testid: 'step-outcome' });
  readonly #doc = make('p', { class: 'caption-doc hint' });
  readonly #rounds: RoundChoice;
  readonly #back: HTMLButtonElement;
  readonly #forth: HTMLButtonElement;

  constructor(actions: Actions, { onSave, onRound }: CaptionEvents) {
    this.#rounds = new RoundChoice(onRound);
    this.#back = iconButton('Step before', icon('chevron'), () => actions.moveStep(-1));
    this.#back.classList.add('is-back');
    this.#forth = iconButton('Next step', icon('chevron'), () => actions.moveStep(1));
    const head = make(
      'p',
      { class: 'caption-head', 'aria-live': 'polite' },
      this.#place,
      this.#label,
      this.#figure,
    );
    const title = 'Save this picture as SVG';
    const svg = make(
      'button',
      { type: 'button', class: 'button', testid: 'save-picture', title, on: { click: onSave } },
      icon('download'),
      'SVG',
    );
    this.node = make(
      'div',
      { class: 'caption' },
      this.#back,
      make('div', { class: 'caption-words' }, head, this.#rounds.node, this.#outcome, this.#doc),
      svg,
      this.#forth,
    );
  }

  /** @param round shown of a picture with several */
  show({ pictures }: StepsShown, picture: PictureFacts, round: number): void {
    this.#rounds.show(picture.rounds, round);
    const place = pictures.indexOf(picture);
    setText(this.#place, `${place + 1} of ${pictures.length}`);
    setText(this.#label, picture.label);
    setText(this.#figure, picture.figure === 'ours' ? '' : `Paper: ${picture.figure}`);
    // Of a stage in several pictures each tells its own counts.
    const isOnly = pictures.filter(({ stage }) => stage === picture.stage).length === 1;
    setText(this.#outcome, outcomeOf(picture, isOnly));
    setText(this.#doc, picture.doc);
    // Not disabled: the keyboard would lose its place.
    setAttribute(this.#back, 'aria-disabled', String(place === 0));
    setAttribute(this.#forth, 'aria-disabled', String(place === pictures.length - 1));
  }
}

function outcomeOf({ outcome, stage, ms }: PictureFacts, isOnly: boolean): string {
  const time = `${STAGES[stage].label}: ${formatDuration(ms)}`;
  return outcome !== '' && isOnly ? `${outcome} · ${time}` : time;
}
