import type { PictureOf } from '../worker/protocol.ts';
import type { Model, Tool } from './model.ts';
import type { PlanMaker } from './plan-maker.ts';
import { StepChoice } from './step-choice.ts';
import type { Stretch } from './stretch.ts';
import { TOOLS } from './tools.ts';

export interface SheetChoiceEvents {
  /** Something that is shown has changed. */
  onChange(): void;
  /** The 2D view is to be seen. */
  onShow(): void;
}

/**
 * What the 2D view shows, and what the pointer does in it. Tools work in the drawing, so a tool and a step's picture
 * put each other away.
 */
export class SheetChoice {
  readonly #maker: PlanMaker;
  readonly #events: SheetChoiceEvents;
  readonly #steps: StepChoice;
  #storey = 0;
  #tool: Tool | null = null;
  #marked: Stretch | null = null;

  constructor(maker: PlanMaker, events: SheetChoiceEvents) {
    this.#maker = maker;
    this.#events = events;
    this.#steps = new StepChoice(maker);
  }

  /** Name of the step whose picture stands in place of the drawing, or null. */
  get step(): string | null {
    return this.#steps.name;
  }

  get shown(): Pick<Model, 'storey' | 'steps' | 'tool' | 'marked'> {
    const { of, pictures, picture } = this.#steps;
    return {
      storey: this.#storey,
      steps: { of, pictures, picture },
      tool: this.#tool,
      marked: this.#marked,
    };
  }

  showStorey(storey: number): void {
    this.#storey = storey;
    this.#events.onChange();
  }

  showStep(name: string | null): void {
    this.#steps.open(name);
    if (name !== null) {
      this.#tool = null;
      this.#events.onShow();
    }
    this.#events.onChange();
  }

  moveStep(by: 1 | -1): void {
    this.#steps.move(by);
    this.#events.onChange();
  }

  turnSteps(of: PictureOf): void {
    this.#steps.turnTo(of);
    if (of === 'failed') this.#maker.dismiss();
    this.showStep(this.#steps.name);
  }

  takeTool(tool: Tool | null): void {
    const { view } = this.#maker;
    this.#tool = tool && view && TOOLS[tool].lacks(view) === null ? tool : null;
    if (this.#tool) {
      this.#steps.open(null);
      this.#events.onShow();
    }
    this.#events.onChange();
  }

  mark(stretch: Stretch | null): void {
    this.#marked = stretch;
    this.#events.onChange();
  }
}
