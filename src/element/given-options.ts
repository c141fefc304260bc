import { type GivenValues, type Options, PARAMS, type ParamName } from '../core/params.ts';
import { History } from './history.ts';

/** What becomes of all that is given when some of it changes. */
type Carry = (before: GivenValues, next: GivenValues) => GivenValues;

/** The parameters a person has given, and the way back to those before. */
export class GivenOptions {
  readonly #history = new History<GivenValues>();
  #now: GivenValues = {};
  /** As they were before the slider under the hand moved. */
  #before: GivenValues | null = null;
  readonly #carry: Carry;

  /** @param carry what a change takes along with it */
  constructor(carry: Carry = (_, next) => next) {
    this.#carry = carry;
  }

  get now(): GivenValues {
    return this.#now;
  }

  get canUndo(): boolean {
    return this.#history.canUndo;
  }

  get canRedo(): boolean {
    return this.#history.canRedo;
  }

  /** Sets all, as one step that can be undone. */
  replace(options: GivenValues): void {
    this.#history.leave(this.#now);
    this.#now = { ...options };
  }

  /** Sets or, where `value` is empty, forgets one parameter, without a step: what markup says is where a person begins. */
  begin(name: ParamName, value: GivenValues): void {
    const { [name]: _, ...others } = this.#now;
    this.#now = { ...others, ...value };
  }

  /** `undefined` forgets a parameter. @param isFinal false while a slider is on its way: a whole slide is one step */
  change(change: GivenValues, isFinal: boolean): void {
    this.#before ??= this.#now;
    // What is taken along on the way of a slider is taken from where it began.
    const { crop, doors } = this.#before;
    const changed = Object.entries({ ...this.#now, crop, doors, ...change });
    const given = Object.fromEntries(changed.filter(([, value]) => value !== undefined));
    this.#now = this.#carry(this.#before, given);
    if (!isFinal) return;
    if (!isEqual(this.#before, this.#now)) this.#history.leave(this.#before);
    this.#before = null;
  }

  /** Sets the preset and forgets what it decides, as one step: all but what was said of the scan itself. */
  takePreset(preset: Options['preset']): void {
    const kept = Object.entries(this.#now).filter(([name]) => isOfScan(name as ParamName));
    this.replace({ ...Object.fromEntries(kept), preset });
  }

  /** Forgets parameters, as one step. */
  reset(names: readonly ParamName[]): void {
    const kept = Object.entries(this.#now).filter(([name]) => !names.includes(name as ParamName));
    this.replace(this.#carry(this.#now, Object.fromEntries(kept)));
  }

  undo(): void {
    this.#now = this.#history.undo(this.#now);
  }

  redo(): void {
    this.#now = this.#history.redo(this.#now);
  }
}

/** Unit, axis, scale, crop, thinning, paper: how to take the scan and to show its plan, not how to make it. */
function isOfScan(name: ParamName): boolean {
  return ['read', 'frame', 'crop', 'sheet'].includes(PARAMS[name].stage);
}

function isEqual(a: GivenValues, b: GivenValues): boolean {
  const text = (options: GivenValues) => JSON.stringify(Object.entries(options).sort());
  return text(a) === text(b);
}
