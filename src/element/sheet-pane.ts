import { SheetView } from '../view/sheet.ts';
import type { PlanView } from '../worker/protocol.ts';
import { iconButton, toggleChip } from './chips.ts';
import { CropTool } from './crop/crop-tool.ts';
import { DoorTool } from './doors/door-tool.ts';
import { icon } from './icon.ts';
import { make, setAttribute, setText } from './make.ts';
import { MeasureTool } from './measure/measure-tool.ts';
import type { Actions, Model, Tool } from './model.ts';
import { NameTool } from './names/name-tool.ts';
import type { PlanTool } from './plan-tool.ts';
import type { StepsPane } from './steps/steps-pane.ts';
import { makeSwitch } from './switch.ts';
import { TOOL_NAMES, TOOLS } from './tools.ts';

const NOTHING = new Float64Array();

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
  readonly #zooms = make(
    'div',
    { class: 'zooms' },
    iconButton('Zoom out', icon('minus'), () => this.#front?.zoomOut()),
    iconButton('Zoom in', icon('plus'), () => this.#front?.zoomIn()),
    iconButton('Show all of the plan', icon('fit'), () => this.#front?.fit()),
  );
  readonly #chips: Readonly<Record<Tool, HTMLElement>>;
  readonly #tools: Readonly<Record<Tool, PlanTool>>;
  /** The one the sheet was given. */
  #tool: Tool | null = null;
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
    const redraw = () => this.#mark();
    this.#points.classList.add('points-chip');
    this.#tools = {
      doors: new DoorTool(actions, redraw),
      names: new NameTool(actions, redraw),
      measure: new MeasureTool(actions, redraw),
      crop: new CropTool(actions, redraw),
    };
    this.#chips = {
      doors: this.#toolChip('doors'),
      names: this.#toolChip('names'),
      measure: this.#toolChip('measure'),
      crop: this.#toolChip('crop'),
    };
    this.node = make(
      'section',
      { class: 'pane pane-2d', 'aria-label': 'Plan' },
      make(
        'div',
        { class: 'tools' },
        this.#look.node,
        this.#points,
        ...Object.values(this.#chips),
        this.#storeys,
        this.#compare,
        make('span', { class: 'spacer' }),
        this.#zooms,
      ),
      ...Object.values(this.#tools).map(({ bar }) => bar.node),
      this.#host,
      this.#notice,
    );
  }

  connect(): void {
    this.#sheet = new SheetView(this.#host);
    this.#tool = null;
    this.#drawing = '';
  }

  disconnect(): void {
    this.#life++;
    this.#sheet?.dispose();
    this.#sheet = null;
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
    this.#points.hidden = isStepping || view?.isSavedPlan === true;
    // Beside the tools a narrow pane has no room for them.
    this.#zooms.classList.toggle('may-float', !isStepping);
    for (const tool of TOOL_NAMES) {
      const chip = this.#chips[tool];
      const isTaken = view !== null && (model.tool === tool || TOOLS[tool].lacks(view) === null);
      chip.hidden = isStepping || !isTaken;
      setAttribute(chip, 'aria-pressed', String(model.tool === tool));
    }
    this.#compare.hidden = !isStepping || steps.of === 'failed' || view?.isSavedPlan === true;
    this.#host.hidden = isStepping;
    if (isStepping) void this.#showSteps();
    else this.#hideSteps();
    this.#showStoreys(isStepping ? 0 : (view?.drawings.length ?? 0), storey);
    if (view) this.#showDrawing(view, Math.min(storey, view.drawings.length - 1), name);
    this.#showTools(model);
  }

  #showDrawing({ drawings, plan, slice }: PlanView, storey: number, name: string): void {
    const drawing = drawings[storey];
    if (drawing === this.#drawing) return;
    this.#drawing = drawing;
    const { frame, source } = plan;
    this.#sheet?.show({ drawing, frame, source: source.name, slice }, name !== this.#name);
    this.#name = name;
  }

  #showTools(model: Model): void {
    for (const tool of Object.values(this.#tools)) tool.show(model);
    this.#sheet?.showAround(model.tool === 'crop' ? (model.view?.surroundings.cropped ?? NOTHING) : NOTHING);
    if (model.tool !== this.#tool) {
      this.#sheet?.setTool(model.tool && this.#tools[model.tool]);
      // A plan cropped in hand lies where the whole one did.
      if (this.#tool === 'crop') this.#sheet?.fit();
      this.#tool = model.tool;
    }
    this.#mark();
  }

  #mark(): void {
    this.#sheet?.mark(Object.values(this.#tools).flatMap(({ marks }) => marks));
  }

  #toolChip(tool: Tool): HTMLElement {
    const { symbol, label, words, key, testid } = TOOLS[tool];
    return make(
      'button',
      {
        type: 'button',
        class: 'chip tool-chip',
        testid,
        title: `${words} (${key})`,
        'aria-pressed': 'false',
        'aria-keyshortcuts': key,
        on: { click: () => this.#actions.takeTool(this.#model?.tool === tool ? null : tool) },
      },
      icon(symbol),
      make('span', {}, label),
    );
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
    const module = await import('./steps/steps-pane.ts').catch(() => null);
    if (life !== this.#life) return;
    if (!module) {
      const words =
        'The part of the program that shows the steps could not be fetched. Reload the page to try again.';
      setText(this.#notice, words);
      this.#notice.hidden = false;
      return;
    }
    this.#steps = new module.StepsPane(this.#actions, this.node.getRootNode() as ShadowRoot, (isComparing) =>
      setAttribute(this.#compare, 'aria-pressed', String(isComparing)),
    );
    this.node.append(this.#steps.node);
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
