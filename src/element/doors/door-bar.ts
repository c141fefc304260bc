import { DOOR_HEIGHT, isDoorSize } from '../../core/doors.ts';
import { fromMetres, toMetres } from '../../view/measure.ts';
import type { DisplayUnit } from '../../write/sheet/measure-words.ts';
import { iconButton } from '../chips.ts';
import { icon } from '../icon.ts';
import { make, setAttribute, setText } from '../make.ts';
import type { DoorSize } from './plan-doors.ts';

/** Clear width of a usual door, m. */
const DOOR_WIDTH = 0.9;

/** What is typed into a step of the spinner, m and ft. */
const STEPS: Readonly<Record<DisplayUnit, number>> = { m: 0.05, ft: 0.25 };

/** The size of the next door, what a press would do, and the way out. */
export class DoorBar {
  readonly node: HTMLElement;
  readonly #width = new SizeField('Width', DOOR_WIDTH);
  readonly #height = new SizeField('Height', DOOR_HEIGHT);
  readonly #words = make('p', { class: 'tool-words hint', testid: 'door-words' });

  constructor(onLeave: () => void) {
    this.node = make(
      'div',
      { class: 'tool-bar', role: 'group', 'aria-label': 'Cut doors', hidden: true },
      this.#width.node,
      this.#height.node,
      this.#words,
      iconButton('Leave cutting doors', icon('close'), onLeave),
    );
  }

  get size(): DoorSize {
    const height = this.#height.metres;
    return height === DOOR_HEIGHT ? { width: this.#width.metres } : { width: this.#width.metres, height };
  }

  setUnit(unit: DisplayUnit): void {
    for (const field of [this.#width, this.#height]) field.setUnit(unit);
  }

  say(words: string): void {
    setText(this.#words, words);
  }
}

/** A length of a door, in the unit people read. */
class SizeField {
  readonly node: HTMLElement;
  readonly #input: HTMLInputElement;
  readonly #suffix = make('span', { class: 'unit' });
  #metres: number;
  #unit: DisplayUnit | null = null;

  constructor(label: string, metres: number) {
    this.#metres = metres;
    this.#input = make('input', { type: 'number', min: 0, on: { input: () => this.#read() } });
    this.node = make('label', {}, make('span', {}, label), this.#input, this.#suffix);
  }

  /** The last size given that a door can have. */
  get metres(): number {
    return this.#metres;
  }

  setUnit(unit: DisplayUnit): void {
    if (unit === this.#unit) return;
    this.#unit = unit;
    setAttribute(this.#input, 'step', STEPS[unit]);
    setText(this.#suffix, unit);
    this.#input.value = String(fromMetres(this.#metres, unit));
    this.#input.removeAttribute('aria-invalid');
  }

  #read(): void {
    const metres = toMetres(this.#input.valueAsNumber, this.#unit ?? 'm');
    const isAllowed = isDoorSize(metres);
    if (isAllowed) this.#metres = metres;
    setAttribute(this.#input, 'aria-invalid', isAllowed ? null : 'true');
  }
}
