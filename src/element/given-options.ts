import { type GivenValues, type Options, PARAMS, type ParamName } from '../core/params.ts';
import { History } from './history.ts';

/** Parameters that say places of the plan: a change of its frame takes them along. */
export const PLACED = ['crop', 'doors', 'roomNames'] as const satisfies readonly ParamName[];

/** What becomes of all that is given when some of it changes. */
type Carry = (before: GivenValues, next: GivenValues) => GivenValues;

/** The parameters a person has given, and the way back to those before. */
export class GivenOptions {
  readonly #history = new History<GivenValues>();
  #now: GivenValues = {};
  /** As they were before the slider under the hand moved. */
  #before: GivenValues | null = null;
  readonly #carry: Carry;
  /** The scan shown. */
  #scan = '';
  /** Rooms of it were named by hand. */
  #isNamed = false;

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

  /** What is given for a scan: rooms that were named by hand are those of the scan they were named in. */
  of(scan: string): GivenValues {
    if (!this.#isNamed || scan === this.#scan) return this.#now;
    const { roomNames: _, ...others } = this.#now;
    return others;
  }

  /** Another scan is shown. */
  enter(scan: string): void {
    this.#now = this.of(scan);
    this.#isNamed &&= scan === this.#scan;
    this.#scan = scan;
  }

  /** Sets all, as one step that can be undone. */
  replace(options: GivenValues): void {
    this.#isNamed = false;
    this.#leave({ ...options });
  }

  /** Sets or, where `value` is empty, forgets one parameter, without a step: what markup says is where a person begins. */
  begin(name: ParamName, value: GivenValues): void {
    const { [name]: _, ...others } = this.#now;
    this.#now = { ...others, ...value };
  }

  /** `undefined` forgets a parameter. @param isFinal false while a slider is on its way: a whole slide is one step */
  change(change: GivenValues, isFinal: boolean): void {
    this.#isNamed ||= change.roomNames !== undefined;
    this.#before ??= this.#now;
    // What is taken along on the way of a slider is taken from where it began.
    const before = this.#before;
    const placed = Object.fromEntries(PLACED.map((name) => [name, before[name]]));
    const changed = Object.entries({ ...this.#now, ...placed, ...change });
    const given = Object.fromEntries(changed.filter(([, value]) => value !== undefined));
    this.#now = this.#carry(this.#before, given);
    if (!isFinal) return;
    if (!isEqual(this.#before, this.#now)) this.#history.leave(this.#before);
    this.#before = null;
  }

  /** Sets the preset and forgets what it decides, as one step: all but what was said of the scan itself. */
  takePreset(preset: Options['preset']): void {
    const kept = Object.entries(this.#now).filter(([name]) => isOfScan(name as ParamName));
    this.#leave({ ...Object.fromEntries(kept), preset });
  }

  /** Forgets parameters, as one step. */
  reset(names: readonly ParamName[]): void {
    const kept = Object.entries(this.#now).filter(([name]) => !names.includes(name as ParamName));
    this.#leave(this.#carry(this.#now, Object.fromEntries(kept)));
  }

  undo(): void {
    this.#now = this.#history.undo(this.#now);
  }

  redo(): void {
    this.#now = this.#history.redo(this.#now);
  }

  #leave(next: GivenValues): void {
    this.#history.leave(this.#now);
    this.#now = next;
  }
}

/** Unit, axis, scale, crop, thinning, names, paper: how to take the scan and to show its plan, not how to make it. */
function isOfScan(name: ParamName): boolean {
  return name === 'roomNames' || ['read', 'frame', 'crop', 'sheet'].includes(PARAMS[name].stage);
}

function isEqual(a: GivenValues, b: GivenValues): boolean {
  const text = (options: GivenValues) => JSON.stringify(Object.entries(options).sort());
  return text(a) === text(b);
}
