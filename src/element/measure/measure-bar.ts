import { readLength } from '../../view/measure.ts';
import type { DisplayUnit } from '../../write/sheet/measure-words.ts';
import { iconButton } from '../chips.ts';
import { icon } from '../icon.ts';
import { make, setAttribute, setText } from '../make.ts';

export interface MeasureEvents {
  /** One of the lengths offered; null for two points of the drawing. */
  onChoose(index: number | null): void;
  /** @param metres a positive length */
  onSet(metres: number): void;
  onReset(): void;
  onLeave(): void;
}

/** What is measured, its true length, and the way back to the automatic scale. */
export class MeasureBar {
  readonly node: HTMLElement;
  readonly #events: MeasureEvents;
  readonly #choice: HTMLSelectElement;
  readonly #length: HTMLInputElement;
  readonly #suffix = make('span', { class: 'unit' });
  readonly #set = make('button', { type: 'submit', class: 'button', testid: 'set-scale' }, 'Set scale');
  readonly #reset: HTMLButtonElement;
  readonly #words = make('p', {
    class: 'tool-words hint',
    testid: 'measure-words',
    'aria-live': 'polite',
  });
  #offered = '';
  #unit: DisplayUnit = 'm';

  constructor(events: MeasureEvents) {
    this.#events = events;
    const choose = () => events.onChoose(this.#choice.value === '' ? null : Number(this.#choice.value));
    this.#choice = make('select', { on: { change: choose } });
    const check = () => this.#check();
    this.#length = make('input', {
      type: 'text',
      spellcheck: 'false',
      autocomplete: 'off',
      on: { input: check },
    });
    this.#reset = make(
      'button',
      {
        type: 'button',
        class: 'button',
        testid: 'automatic-scale',
        on: { click: () => events.onReset() },
      },
      'Automatic scale',
    );
    const label = make('label', {}, make('span', {}, 'True length'), this.#length, this.#suffix);
    const submit = (event: SubmitEvent) => this.#submit(event);
    this.node = make(
      'form',
      { class: 'tool-bar', 'aria-label': 'Measure', hidden: true, on: { submit } },
      make('label', {}, make('span', {}, 'Length of'), this.#choice),
      label,
      this.#set,
      this.#reset,
      this.#words,
      iconButton('Leave measuring', icon('close'), () => events.onLeave()),
    );
  }

  show({ unit, isScaled, isMeasured }: { unit: DisplayUnit; isScaled: boolean; isMeasured: boolean }): void {
    this.#unit = unit;
    setText(this.#suffix, unit);
    this.#reset.hidden = !isScaled;
    this.#length.disabled = !isMeasured;
    this.#set.disabled = !isMeasured;
  }

  /** @param lengths what may be measured, in words */
  offer(lengths: readonly string[], chosen: number | null): void {
    const key = lengths.join('\n');
    if (key !== this.#offered) {
      const options = lengths.map((words, i) => make('option', { value: i }, words));
      this.#choice.replaceChildren(make('option', { value: '' }, 'Two points'), ...options);
      this.#offered = key;
    }
    this.#choice.value = chosen === null ? '' : String(chosen);
  }

  say(words: string): void {
    setText(this.#words, words);
  }

  /** Another distance has another true length. */
  clear(): void {
    this.#length.value = '';
    this.#length.removeAttribute('aria-invalid');
  }

  focusLength(): void {
    this.#length.focus();
  }

  #check(): boolean {
    const isSound = readLength(this.#length.value, this.#unit) > 0;
    setAttribute(this.#length, 'aria-invalid', isSound || this.#length.value === '' ? null : 'true');
    return isSound;
  }

  #submit(event: SubmitEvent): void {
    event.preventDefault();
    if (this.#check()) this.#events.onSet(readLength(this.#length.value, this.#unit));
    else {
      setAttribute(this.#length, 'aria-invalid', 'true');
      this.#length.focus();
    }
  }
}
