import { SheetView } from '../view/sheet.ts';
import type { PlanView } from '../worker/protocol.ts';
import { iconButton, toggleChip } from './chips.ts';
import { DoorTool } from './doors/door-tool.ts';
import { icon } from './icon.ts';
import { make, setAttribute, setText } from './make.ts';
import type { Actions, Model } from './model.ts';
import type { StepsPane } from './steps/steps-pane.ts';
import { makeSwitch } from './switch.ts';

/** The 2D view with what switches it: the drawing, or the steps that led to it. */
export class SheetPane {
  readonly #host = make('div', { class: 'sheet', part: 'sheet' });
  readonly #notice = make('p', { class: 'notice', hidden: true, role: 'status' });
  readonly #storeys = make('div', {
    class: 'choices storeys',
    role: 'group',
    'aria-label': 'Storey',
    hidden: true,
  });
  readonly #look = makeSwitch(
    'What the plan view shows',
    { drawing: 'Drawing', steps: 'Step by step' },
    (look) => this.#turn(look),
  );
  readonly #points = toggleChip('Points', true, (isShown) => this.#sheet?.showPoints(isShown));
  readonly #compare = make(
    'button',
    {
      type: 'button',
      class: 'chip',
      testid: 'compare',
      'aria-pressed': 'false',
      on: { click: () => this.#toggleComparison() },
    },
    'Compare',
  );
  readonly #cut = make(
    'button',
    {
      type: 'button',
      class: 'chip',
      testid: 'cut-doors',
      title: 'Cut doors in the drawing (D)',
      'aria-pressed': 'false',
      'aria-keyshortcuts': 'D',
      on: { click: () => this.#actions.cutDoors(!this.#model?.isCutting) },
    },
    icon('door'),
    'Cut door',
  );
  readonly #doors: DoorTool;
  readonly #actions: Actions;
  readonly node: HTMLElement;
  #sheet: SheetView | null = null;
  #steps: StepsPane | null = null;
  #opening: Promise<void> | null = null;
  /** Counts connections: steps that open after the element has left are thrown away. */
  #life = 0;
  #model: Model | null = null;
  #wantsFocus = false;
  /** Asked for while the steps' code is on its way. */
  #wantsComparison = false;
  #drawing = '';
  #name = '';

  constructor(actions: Actions) {
    this.#actions = actions;
    this.#doors = new DoorTool(actions);
    this.node = make(
      'section',
      { class: 'pane pane-2d', 'aria-label': 'Plan' },
      make(
        'div',
        { class: 'tools' },
        this.#look.node,
        this.#points,
        this.#cut,
        this.#storeys,
        this.#compare,
        make('span', { class: 'spacer' }),
        iconButton('Zoom out', icon('minus'), () => this.#front?.zoomOut()),
        iconButton('Zoom in', icon('plus'), () => this.#front?.zoomIn()),
        iconButton('Show all of the plan', icon('fit'), () => this.#front?.fit()),
      ),
      this.#doors.bar.node,
      this.#host,
      this.#notice,
    );
  }

  connect(): void {
    this.#sheet = new SheetView(this.#host);
    this.#doors.attach(this.#sheet);
    this.#drawing = '';
  }

  disconnect(): void {
    this.#life++;
    this.#sheet?.dispose();
    this.#sheet = null;
    this.#doors.attach(null);
    this.#steps?.dispose();
    this.#steps = null;
    this.#opening = null;
  }

  show(model: Model): void {
    this.#model = model;
    const { view, storey, unit, name, steps } = model;
    const isStepping = steps.picture !== null;
    this.#sheet?.setUnit(unit);
    this.#look.set(isStepping ? 'steps' : 'drawing');
    this.#look.node.hidden = steps.pictures.length === 0;
    this.#points.hidden = isStepping;
    this.#cut.hidden = isStepping || !view;
    setAttribute(this.#cut, 'aria-pressed', String(model.isCutting));
    this.#compare.hidden = !isStepping || steps.of === 'failed';
    this.#host.hidden = isStepping;
    if (isStepping) void this.#showSteps();
    else this.#hideSteps();
    this.#showStoreys(isStepping ? 0 : (view?.drawings.length ?? 0), storey);
    if (view) this.#showDrawing(view, Math.min(storey, view.drawings.length - 1), name);
    this.#doors.show(model);
  }

  #showDrawing({ drawings, plan, slice }: PlanView, storey: number, name: string): void {
    const drawing = drawings[storey];
    if (drawing === this.#drawing) return;
    this.#drawing = drawing;
    const { frame, source } = plan;
    this.#sheet?.show({ drawing, frame, source: source.name, slice }, name !== this.#name);
    this.#name = name;
  }

  preview(positions: Float32Array): void {
    this.#sheet?.preview(positions);
  }

  fit(): void {
    this.#sheet?.fit();
    this.#steps?.fit();
  }

  /** The keyboard goes to the step's picture once it is there. */
  focusStep(): void {
    this.#wantsFocus = true;
  }

  /** What is in front. */
  get #front(): SheetView | StepsPane | null {
    return this.#host.hidden ? this.#steps : this.#sheet;
  }

  #turn(look: 'drawing' | 'steps'): void {
    const first = this.#model?.steps.pictures[0];
    this.#actions.showStep(look === 'steps' && first ? first.name : null);
  }

  async #showSteps(): Promise<void> {
    this.#opening ??= this.#openSteps();
    await this.#opening;
    if (!this.#steps || !this.#model?.steps.picture) return;
    this.#steps.node.hidden = false;
    this.#steps.show(this.#model);
    if (this.#wantsFocus) this.#steps.focus();
    this.#wantsFocus = false;
    if (this.#wantsComparison) this.#steps.compare(true);
    this.#wantsComparison = false;
  }

  #toggleComparison(): void {
    if (this.#steps) this.#steps.compare(!this.#steps.isComparing);
    else {
      this.#wantsComparison = !this.#wantsComparison;
      setAttribute(this.#compare, 'aria-pressed', String(this.#wantsComparison));
    }
  }

  #hideSteps(): void {
    this.#notice.hidden = true;
    this.#wantsComparison = false;
    if (!this.#steps || this.#steps.node.hidden) return;
    this.#steps.compare(false);
    this.#steps.node.hidden = true;
  }

  /** Their code comes when they are first seen, so the plan does not wait for it. */
  async #openSteps(): Promise<void> {
    const life = this.#life;
    try {
      const { StepsPane } = await import('./steps/steps-pane.ts');
      if (life !== this.#life) return;
      this.#steps = new StepsPane(this.#actions, this.node.getRootNode() as ShadowRoot, (isComparing) =>
        setAttribute(this.#compare, 'aria-pressed', String(isComparing)),
      );
      this.node.append(this.#steps.node);
    } catch {
      const words =
        'The part of the program that shows the steps could not be fetched. Reload the page to try again.';
      setText(this.#notice, words);
      this.#notice.hidden = false;
    }
  }

  #showStoreys(count: number, chosen: number): void {
    this.#storeys.hidden = count < 2;
    if (this.#storeys.childElementCount !== count) {
      const buttons = Array.from({ length: count }, (_, storey) =>
        make('button', { type: 'button', on: { click: () => this.#actions.setStorey(storey) } }),
      );
      this.#storeys.replaceChildren(...buttons);
    }
    for (const [storey, button] of [...this.#storeys.children].entries()) {
      setText(button, `Storey ${storey}`);
      setAttribute(button, 'aria-pressed', String(storey === chosen));
    }
  }
}
