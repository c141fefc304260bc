import { type CropBox, MOST_HEADING } from '../../core/crop-box.ts';
import { iconButton } from '../chips.ts';
import { icon } from '../icon.ts';
import { make, setAttribute, setText } from '../make.ts';

/** The fields: sides of the box, low before high. */
const FIELDS = ['x0', 'x1', 'y0', 'y1', 'z0', 'z1'] as const;
type Name = (typeof FIELDS)[number];
type Sides = Readonly<Record<Name, number>>;

const ROWS = [
  { label: 'x', low: 'x0', high: 'x1' },
  { label: 'y', low: 'y0', high: 'y1' },
  { label: 'Height', low: 'z0', high: 'z1' },
] as const;

export interface CropEvents {
  onChange(box: CropBox): void;
  onRemove(): void;
  onLeave(): void;
}

/** What the bar shows. */
export interface CropShown {
  readonly box: CropBox | null;
  /** Sides of the whole cloud: an empty field stands for its own. */
  readonly whole: Sides;
  /** A flat cloud has no heights. */
  readonly hasHeights: boolean;
  /** Of the numbers. */
  readonly unit: string;
}

/** The box in numbers, source units and coordinates: the way to it without a pointer. */
export class CropBar {
  readonly node: HTMLElement;
  readonly #events: CropEvents;
  readonly #fields: Readonly<Record<Name, HTMLInputElement>>;
  readonly #heights: HTMLElement;
  readonly #heading: HTMLInputElement;
  readonly #suffix = make('span', { class: 'unit' });
  readonly #words = make('p', { class: 'tool-words hint', testid: 'crop-words', 'aria-live': 'polite' });
  readonly #remove: HTMLButtonElement;
  #whole: Sides | null = null;

  constructor(events: CropEvents) {
    this.#events = events;
    this.#fields = Object.fromEntries(FIELDS.map((name) => [name, this.#makeField(name)])) as Record<
      Name,
      HTMLInputElement
    >;
    const rows = ROWS.map(({ label, low, high }) =>
      make(
        'div',
        { class: 'range', role: 'group', 'aria-label': label },
        make('span', {}, label),
        this.#fields[low],
        make('span', { 'aria-hidden': 'true' }, '–'),
        this.#fields[high],
      ),
    );
    this.#heights = rows[2];
    this.#heading = make('input', {
      type: 'number',
      step: 'any',
      min: -MOST_HEADING,
      max: MOST_HEADING,
      placeholder: '0',
      'aria-label': 'Turned by, degrees',
      on: { change: () => this.#read() },
    });
    const turned = make(
      'label',
      { class: 'range' },
      make('span', {}, 'Turned'),
      this.#heading,
      make('span', { class: 'unit' }, '°'),
    );
    const remove = { click: () => events.onRemove() };
    this.#remove = make(
      'button',
      { type: 'button', class: 'button', testid: 'remove-crop', on: remove },
      'Remove box',
    );
    this.node = make(
      'div',
      { class: 'tool-bar', role: 'group', 'aria-label': 'Crop', hidden: true },
      ...rows,
      this.#suffix,
      turned,
      this.#remove,
      this.#words,
      iconButton('Leave cropping', icon('close'), () => events.onLeave()),
    );
  }

  show({ box, whole, hasHeights, unit }: CropShown): void {
    this.#whole = whole;
    this.#heights.hidden = !hasHeights;
    this.#remove.hidden = box === null;
    setText(this.#suffix, unit);
    const [z0, z1] = box?.heights ?? [null, null];
    const given = { x0: null, y0: null, x1: null, y1: null, ...box, z0, z1 };
    for (const name of FIELDS) {
      const field = this.#fields[name];
      field.placeholder = String(whole[name]);
      // A field under the hand is not overwritten.
      if (field.matches(':focus')) continue;
      field.value = given[name] === null ? '' : String(given[name]);
      field.removeAttribute('aria-invalid');
    }
    if (this.#heading.matches(':focus')) return;
    this.#heading.value = box?.heading ? String(box.heading) : '';
    this.#heading.removeAttribute('aria-invalid');
  }

  /** What is wrong with a number under the hand is told until it is mended. */
  say(words: string): void {
    const fields = [...Object.values(this.#fields), this.#heading];
    const isWrong = fields.some((field) => field.getAttribute('aria-invalid') === 'true');
    if (!isWrong) setText(this.#words, words);
  }

  #makeField(name: Name): HTMLInputElement {
    const end = name.endsWith('0') ? 'from' : 'to';
    const what = name.startsWith('z') ? 'Height' : name[0];
    return make('input', {
      type: 'number',
      step: 'any',
      'aria-label': `${what} ${end}`,
      on: { change: () => this.#read() },
    });
  }

  #read(): void {
    if (!this.#whole) return;
    const whole = this.#whole;
    const sideOf = (name: Name) =>
      this.#fields[name].value === '' ? whole[name] : this.#fields[name].valueAsNumber;
    const [x0, x1, y0, y1, z0, z1] = FIELDS.map(sideOf);
    const isSound = { x: x0 < x1, y: y0 < y1, z: z0 < z1 };
    for (const name of FIELDS) {
      setAttribute(this.#fields[name], 'aria-invalid', isSound[name[0] as 'x'] ? null : 'true');
    }
    if (!isSound.x || !isSound.y || !isSound.z) {
      setText(this.#words, 'The first number must be less than the second.');
      return;
    }
    const heading = this.#heading.value === '' ? 0 : this.#heading.valueAsNumber;
    const isTurned = Math.abs(heading) <= MOST_HEADING;
    setAttribute(this.#heading, 'aria-invalid', isTurned ? null : 'true');
    if (!isTurned) {
      setText(this.#words, `A box turns by ${MOST_HEADING}° at most.`);
      return;
    }
    const hasHeights = this.#fields.z0.value !== '' || this.#fields.z1.value !== '';
    this.#events.onChange({ x0, y0, x1, y1, heights: hasHeights ? [z0, z1] : null, heading });
  }
}
