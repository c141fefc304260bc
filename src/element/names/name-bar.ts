import { LONGEST_ROOM_NAME } from '../../core/room-names.ts';
import { iconButton } from '../chips.ts';
import { icon } from '../icon.ts';
import { make, setAttribute, setText } from '../make.ts';

export interface NameEvents {
  /** @param name empty for the one that rooms have by themselves */
  onName(name: string): void;
  onNext(): void;
  onLeave(): void;
}

/** What the bar shows. */
export interface NameShown {
  /** Of the room chosen; null where none is. */
  readonly name: string | null;
  /** What it is called by itself. */
  readonly automatic: string;
  readonly hasRooms: boolean;
}

/** The name of the room chosen, and the way to the next without a pointer. */
export class NameBar {
  readonly node: HTMLElement;
  readonly #events: NameEvents;
  readonly #name: HTMLInputElement;
  readonly #next: HTMLButtonElement;
  readonly #words = make('p', { class: 'tool-words hint', testid: 'name-words', 'aria-live': 'polite' });
  /** As the plan has it; what differs is being typed. */
  #shown = '';

  constructor(events: NameEvents) {
    this.#events = events;
    this.#name = make('input', {
      type: 'text',
      class: 'room-name',
      maxlength: LONGEST_ROOM_NAME,
      dir: 'auto',
      spellcheck: 'false',
      autocomplete: 'off',
      enterkeyhint: 'done',
      testid: 'room-name',
      on: { change: () => this.#take(), keydown: (event: KeyboardEvent) => this.#key(event) },
    });
    this.#next = make(
      'button',
      { type: 'button', class: 'button', testid: 'next-room', on: { click: () => events.onNext() } },
      'Next room',
    );
    const submit = (event: SubmitEvent) => {
      event.preventDefault();
      this.#take();
      this.#name.select();
    };
    this.node = make(
      'form',
      { class: 'tool-bar', 'aria-label': 'Name rooms', hidden: true, on: { submit } },
      make('label', {}, make('span', {}, 'Name'), this.#name),
      this.#next,
      this.#words,
      iconButton('Leave naming rooms', icon('close'), () => events.onLeave()),
    );
  }

  show({ name, automatic, hasRooms }: NameShown): void {
    this.#next.disabled = !hasRooms;
    this.#name.disabled = name === null;
    setAttribute(this.#name, 'placeholder', automatic);
    const isTyping = this.#name.matches(':focus') && this.#name.value !== this.#shown;
    this.#shown = name ?? '';
    if (!isTyping) this.#name.value = this.#shown;
  }

  /** Another room is chosen, and its name is under the hand. */
  edit(shown: NameShown): void {
    this.#shown = this.#name.value;
    this.show(shown);
    this.#name.focus();
    this.#name.select();
  }

  say(words: string): void {
    setText(this.#words, words);
  }

  #take(): void {
    this.#shown = this.#name.value;
    this.#events.onName(this.#name.value);
  }

  #key({ key }: KeyboardEvent): void {
    // What was typed is let go with the tool.
    if (key === 'Escape') this.#name.value = this.#shown;
  }
}
