import { FloorPlanError } from '../../core/errors.ts';
import { STAGES } from '../../core/stages.ts';
import type { Comparison } from '../../worker/protocol.ts';
import { iconButton } from '../chips.ts';
import { icon } from '../icon.ts';
import { make, setAttribute, setText } from '../make.ts';
import type { Actions, Model } from '../model.ts';
import { saySentence } from '../plain-words.ts';
import { makeSwitch } from '../switch.ts';
import { changeTo, type Difference, differences, FIRST_COMPARED, firstValue } from './compared-params.ts';
import { ComparisonTable } from './comparison-table.ts';

/** How the two plans are drawn. */
export type ComparisonLook = 'overlaid' | 'beside';

const LOOKS: Readonly<Record<ComparisonLook, string>> = { overlaid: 'Overlaid', beside: 'Side by side' };

export interface ComparePanelEvents {
  /** Another picture is to be shown. */
  onPicture(): void;
  onClose(): void;
  onSave(): void;
}

/** Chooses what another plan of the same scan differs in, has it made, and tells the two apart in figures. */
export class ComparePanel {
  readonly node: HTMLElement;
  readonly #actions: Actions;
  readonly #events: ComparePanelEvents;
  readonly #param = make('select', { testid: 'compare-param', on: { change: () => this.#pickParam() } });
  readonly #value = make('select', { testid: 'compare-value', on: { change: () => void this.#run() } });
  readonly #status = make('p', { class: 'compare-status hint', role: 'status' });
  readonly #stop: HTMLButtonElement;
  readonly #save: HTMLButtonElement;
  readonly #table = new ComparisonTable();
  readonly #look = makeSwitch<ComparisonLook>('Layout of the comparison', LOOKS, (look) =>
    this.#setLook(look),
  );
  #chosenLook: ComparisonLook = 'overlaid';
  #differences: readonly Difference[] = [];
  /** The plan compared with. */
  #plan: object | null = null;
  #comparison: Comparison | null = null;
  /** Counts runs: only the last one may show something. */
  #runs = 0;

  constructor(actions: Actions, events: ComparePanelEvents) {
    this.#actions = actions;
    this.#events = events;
    this.#stop = make(
      'button',
      { type: 'button', class: 'button', hidden: true, on: { click: () => actions.stopComparing() } },
      'Stop',
    );
    this.#save = make(
      'button',
      {
        type: 'button',
        class: 'button',
        testid: 'save-comparison',
        title: 'Save this comparison as SVG',
        on: { click: () => this.#comparison && events.onSave() },
      },
      icon('download'),
      'SVG',
    );
    this.#look.set(this.#chosenLook);
    this.node = make(
      'section',
      { class: 'compare', 'aria-label': 'Comparison', hidden: true },
      make(
        'div',
        { class: 'compare-choice' },
        make('label', {}, make('span', {}, 'Compare'), this.#param),
        make('label', {}, make('span', {}, 'with'), this.#value),
        make('span', { class: 'spacer' }),
        iconButton('Leave the comparison', icon('close'), () => events.onClose()),
      ),
      make('div', { class: 'compare-line' }, this.#look.node, this.#status, this.#stop, this.#save),
      this.#table.node,
    );
  }

  /** SVG text of the comparison in the chosen layout, null until there is one. */
  get picture(): string | null {
    return this.#comparison?.[this.#chosenLook] ?? null;
  }

  get look(): ComparisonLook {
    return this.#chosenLook;
  }

  /** Names of what is compared, for a file's name. */
  get name(): string {
    return `${this.#param.value}-${this.#value.value}`;
  }

  open(model: Model): void {
    this.node.hidden = false;
    this.show(model);
    this.#param.focus();
  }

  close(): void {
    if (this.node.hidden) return;
    this.node.hidden = true;
    this.#runs++;
    this.#actions.stopComparing();
    this.#plan = null;
    this.#comparison = null;
  }

  /** Compares anew when another plan is shown. */
  show({ view, state, unit }: Model): void {
    this.#table.setUnit(unit);
    if (this.node.hidden || !view || view === this.#plan || state === 'loading') return;
    this.#plan = view;
    this.#differences = differences(view.options);
    this.#fillParams();
    void this.#run();
  }

  #pickParam(): void {
    this.#fillValues('');
    void this.#run();
  }

  /** The choice stays over another plan. */
  #fillParams(): void {
    const chosen = this.#param.value || FIRST_COMPARED;
    const items = this.#differences.map(({ name, label }) => make('option', { value: name }, label));
    this.#param.replaceChildren(...items);
    this.#param.value = chosen;
    this.#fillValues(this.#value.value);
  }

  #fillValues(chosen: string): void {
    const difference = this.#difference();
    const items = difference.others.map(({ value, label }) => make('option', { value }, label));
    this.#value.replaceChildren(...items);
    const isThere = difference.others.some(({ value }) => value === chosen);
    this.#value.value = isThere ? chosen : firstValue(difference);
  }

  #difference(): Difference {
    return this.#differences.find(({ name }) => name === this.#param.value) ?? this.#differences[0];
  }

  async #run(): Promise<void> {
    const run = ++this.#runs;
    const { name, now } = this.#difference();
    const other = this.#value.selectedOptions[0].textContent;
    this.#take(null);
    this.#table.name(now, other);
    this.#tell(`Making the plan with ${other} …`, true);
    try {
      const comparison = await this.#actions.compare(
        { options: changeTo(name, this.#value.value), labels: [now, other] },
        ({ stage }) => {
          if (run === this.#runs) this.#tell(`${STAGES[stage].label} with ${other} …`, true);
        },
      );
      if (run !== this.#runs) return;
      this.#take(comparison);
      this.#tell('The plan shown stays as it is.', false);
    } catch (error) {
      if (run === this.#runs) this.#tell(sayError(error), false);
    }
  }

  #take(comparison: Comparison | null): void {
    this.#comparison = comparison;
    // Not disabled: the keyboard would lose its place, and Escape with it.
    setAttribute(this.#save, 'aria-disabled', String(comparison === null));
    this.#table.show(comparison);
    this.#events.onPicture();
  }

  #tell(words: string, isRunning: boolean): void {
    setText(this.#status, words);
    this.#stop.hidden = !isRunning;
  }

  #setLook(look: ComparisonLook): void {
    this.#chosenLook = look;
    this.#look.set(look);
    this.#events.onPicture();
  }
}

function sayError(error: unknown): string {
  if (!(error instanceof FloorPlanError)) return 'The comparison failed. This is a bug; please report it.';
  if (error.code === 'cancelled') return 'Stopped. Choose again to compare.';
  return saySentence(`${error.message} ${error.hint} (${error.code})`);
}
