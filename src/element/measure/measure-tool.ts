import { planPlace, sayScale, sourceCoordinates } from '../../core/source-coordinates.ts';
import type { Frame, Vec2 } from '../../core/types.ts';
import { formatLength } from '../../view/measure.ts';
import type { SheetPlace } from '../../view/sheet.ts';
import type { SheetMark } from '../../view/sheet-marks.ts';
import type { Actions, Model } from '../model.ts';
import type { PlanTool } from '../plan-tool.ts';
import { lengthOf, type Stretch } from '../stretch.ts';
import { MeasureBar } from './measure-bar.ts';
import { scaleFor } from './scale.ts';
import { outlineEdges, planEdges, type Snapped, snap } from './snap.ts';

/** A corner catches from this many times the reach of a hand. */
const CATCH = 2.5;
/** So many of the longest edges are offered by name. */
const MOST_OFFERED = 12;

const START = 'Press two points whose true distance you know, or choose an edge.';

/** Measures between two places of the plan, and sets the scale by the true length: photogrammetry has none. */
export class MeasureTool implements PlanTool {
  readonly bar: MeasureBar;
  readonly #actions: Actions;
  readonly #redraw: () => void;
  #model: Model | null = null;
  #edges: readonly Stretch[] = [];
  /** The longest edges, longest first. */
  #offered: readonly Stretch[] = [];
  /** Which of them is measured; null for two points. */
  #chosen: number | null = null;
  /** Places pressed, in source units and coordinates: they stay where they are when the scale changes. */
  #picked: readonly Vec2[] = [];
  #aim: Snapped | null = null;

  constructor(actions: Actions, redraw: () => void) {
    this.#actions = actions;
    this.#redraw = redraw;
    this.bar = new MeasureBar({
      onChoose: (index) => this.#choose(index),
      onSet: (metres) => this.#setScale(metres),
      onReset: () => actions.reset(['metresPerUnit']),
      onLeave: () => actions.takeTool(null),
    });
  }

  show(model: Model): void {
    const before = this.#model;
    this.#model = model;
    this.bar.node.hidden = model.tool !== 'measure';
    if (before && before.name !== model.name) this.#forget();
    if (before?.view !== model.view || before?.storey !== model.storey) this.#take(model);
    const isSame =
      before?.view === model.view &&
      before?.storey === model.storey &&
      before?.unit === model.unit &&
      before?.tool === model.tool &&
      before?.given.metresPerUnit === model.given.metresPerUnit;
    if (isSame) return;
    this.#tell();
  }

  hover(place: SheetPlace | null): void {
    this.#aim = place && snap(this.#edges, place.at, CATCH * place.reach);
    this.#redraw();
  }

  press(place: SheetPlace): void {
    const frame = this.#frame;
    if (!frame) return;
    const { at } = snap(this.#edges, place.at, CATCH * place.reach);
    const to = sourceCoordinates(frame);
    const picked: Vec2 = [to.x(at[0]), to.y(at[1])];
    const isSecond = this.#chosen === null && this.#picked.length === 1;
    this.#pick(isSecond ? [...this.#picked, picked] : [picked], null);
    if (isSecond) this.bar.focusLength();
  }

  get marks(): readonly SheetMark[] {
    if (this.#model?.tool !== 'measure') return [];
    const [from, to] = this.#ends;
    const isOpen = from !== undefined && to === undefined;
    const end = isOpen ? this.#aim?.at : to;
    const spots = [from, to].filter((at) => at !== undefined).map((at) => ({ at, isCaught: true }));
    return [
      ...(from && end ? [this.#lengthMark(from, end)] : []),
      ...[...spots, ...(this.#aim ? [this.#aim] : [])].map((spot) => ({ kind: 'spot' as const, ...spot })),
    ];
  }

  get #frame(): Frame | null {
    return this.#model?.view?.plan.frame ?? null;
  }

  /** What is measured, plan metres; less than two while points are being pressed. */
  get #ends(): readonly Vec2[] {
    const frame = this.#frame;
    return frame ? this.#picked.map(([x, y]) => planPlace(frame, x, y)) : [];
  }

  #take({ view, storey }: Model): void {
    const shown = view?.plan.storeys[Math.min(storey, view.plan.storeys.length - 1)];
    this.#edges = shown ? planEdges(shown) : [];
    const byLength = shown ? outlineEdges(shown).sort((a, b) => lengthOf(b) - lengthOf(a)) : [];
    this.#offered = byLength.slice(0, MOST_OFFERED);
    // Another plan has other edges: what was measured stays, as two points.
    this.#chosen = null;
    this.#aim = null;
  }

  #choose(index: number | null): void {
    const frame = this.#frame;
    if (index === null || !frame) {
      this.#pick([], null);
      return;
    }
    const { from, to } = this.#offered[index];
    const source = sourceCoordinates(frame);
    this.#pick(
      [from, to].map(([x, y]) => [source.x(x), source.y(y)] as const),
      index,
    );
  }

  #pick(picked: readonly Vec2[], chosen: number | null): void {
    this.#picked = picked;
    this.#chosen = chosen;
    this.bar.clear();
    this.#tell();
  }

  #forget(): void {
    this.#picked = [];
    this.#chosen = null;
    this.bar.clear();
  }

  #setScale(known: number): void {
    const [from, to] = this.#ends;
    const frame = this.#frame;
    if (!frame || !to) return;
    const scale = scaleFor(lengthOf({ from, to }), known, frame.metresPerUnit);
    if (scale !== null) this.#actions.change({ metresPerUnit: scale }, true);
    else this.bar.say('No scale makes it so long. Press two points further apart.');
  }

  /** The bar and the marks, after something has changed. */
  #tell(): void {
    const { unit = 'm', given } = this.#model ?? {};
    const ends = this.#ends;
    const isScaled = given?.metresPerUnit !== undefined && given.metresPerUnit !== 'auto';
    this.bar.show({ unit, isScaled, isMeasured: ends.length === 2 });
    const lengths = this.#offered.map((edge, i) => `Edge ${i + 1}, ${this.#say(lengthOf(edge))}`);
    this.bar.offer(lengths, this.#chosen);
    this.bar.say(this.#state(ends, isScaled));
    this.#redraw();
  }

  #state([from, to]: readonly Vec2[], isScaled: boolean): string {
    const frame = this.#frame;
    const scale = isScaled && frame?.unit === 'custom' ? ` ${sayScale('custom', frame.metresPerUnit)}.` : '';
    if (!from) return `${START}${scale}`;
    if (!to) return 'Now the other point.';
    return `${this.#say(lengthOf({ from, to }))} in the plan.${scale}`;
  }

  #lengthMark(from: Vec2, to: Vec2): SheetMark {
    return { kind: 'length', from, to, words: this.#say(lengthOf({ from, to })) };
  }

  #say(metres: number): string {
    return formatLength(metres, this.#model?.unit ?? 'm');
  }
}
