import { makeBar } from './bar.ts';
import { makeDivider } from './divider.ts';
import { makeDropTarget } from './drop-target.ts';
import { makeEmptyState } from './empty-state.ts';
import { makeErrorPanel } from './error-panel.ts';
import { make } from './make.ts';
import type { Actions, Model, Panel } from './model.ts';
import { makeRail } from './rail.ts';
import { ScenePane } from './scene-pane.ts';
import { SheetPane } from './sheet-pane.ts';

/** Narrower than this there is room for one view; as in styles.css. px */
const NARROW = 760;

/** Everything the element shows; draws a {@link Model} and reports what a person does. */
export class Shell {
  readonly node: HTMLElement;
  readonly #sheet: SheetPane;
  readonly #scene: ScenePane;
  readonly #panels: readonly Panel[];
  readonly #sizes: ResizeObserver;
  #model: Model | null = null;

  constructor(host: HTMLElement, actions: Actions) {
    this.#sheet = new SheetPane(actions);
    const bar = makeBar(actions);
    const rail = makeRail(actions);
    this.#scene = new ScenePane({
      onUp: (up) => actions.change({ up }, true),
      onAxes: () => rail.showControl('up'),
    });
    const error = makeErrorPanel(actions);
    const empty = makeEmptyState(actions, () => host.getAttribute('poster'));
    const divider = makeDivider(() => panes);
    const panes = make('div', { class: 'panes' }, this.#sheet.node, divider, this.#scene.node);
    const views = make('div', { class: 'views' }, panes, empty.node, error.node);
    this.node = make('div', { class: 'frame' }, bar.node, rail.node, views);
    this.node.append(makeDropTarget(host, (files) => actions.open(files)));
    this.#panels = [bar, rail, error, empty];
    // A pane that comes into sight shows what it missed, and a narrow element one view at a time.
    this.#sizes = new ResizeObserver(() => this.#model && this.show(this.#model));
  }

  connect(): void {
    this.#sheet.connect();
    this.#sizes.observe(this.node);
    this.#sizes.observe(this.#scene.node);
  }

  disconnect(): void {
    this.#sizes.disconnect();
    this.#sheet.disconnect();
    this.#scene.disconnect();
  }

  show(given: Model): void {
    this.#model = given;
    const isNarrow = this.node.clientWidth < NARROW;
    // A run that failed before there was a plan has pictures of its steps, but no model.
    const isFlat = given.layout === 'split' && (isNarrow || (!given.view && given.steps.picture !== null));
    const model = isFlat ? { ...given, layout: '2d' as const } : given;
    this.node.dataset.state = model.state;
    this.node.dataset.layout = model.layout;
    this.node.toggleAttribute('data-has-plan', model.view !== null);
    for (const panel of this.#panels) panel.show(model);
    this.#sheet.show(model);
    void this.#scene.show(model);
  }

  preview(positions: Float32Array): void {
    if (this.#model?.view) return;
    this.#sheet.preview(positions);
    void this.#scene.preview(positions);
  }

  /** The keyboard goes to the step's picture. */
  focusStep(): void {
    this.#sheet.focusStep();
  }

  fit(): void {
    this.#sheet.fit();
    this.#scene.fit();
  }
}
