import type { AxisEvents } from '../view/axis-gizmo.ts';
import type { SceneContent, SceneLayers, SceneView } from '../view/scene.ts';
import type { PlanView } from '../worker/protocol.ts';
import { iconButton, toggleChip } from './chips.ts';
import { icon } from './icon.ts';
import { make, setText } from './make.ts';
import type { Model } from './model.ts';

const LAYERS = { model: 'Model', cloud: 'Points', grid: 'Grid', ceiling: 'Ceiling' } as const;

/** The 3D view with what switches it. Its code comes when it is first seen, so the plan does not wait for it. */
export class ScenePane {
  readonly #host = make('div', { class: 'scene', part: 'scene', testid: 'scene-3d' });
  readonly #notice = make('p', { class: 'notice', hidden: true, role: 'status' });
  readonly #axes: AxisEvents;
  readonly node: HTMLElement;
  #layers: SceneLayers = { model: true, cloud: true, grid: true, ceiling: false };
  #scene: SceneView | null = null;
  #opening: Promise<SceneView | null> | null = null;
  #shown: PlanView | null = null;
  /** The scan, what is up and how large it is: where one has changed, the camera stands anew. */
  #subject: string | null = null;
  /** Counts connections: a scene that opens after the element has left is thrown away. */
  #life = 0;

  constructor(axes: AxisEvents) {
    this.#axes = axes;
    const chips = (Object.keys(LAYERS) as (keyof SceneLayers)[]).map((layer) =>
      toggleChip(LAYERS[layer], this.#layers[layer], (isShown) => {
        this.#layers = { ...this.#layers, [layer]: isShown };
        this.#scene?.showLayers(this.#layers);
      }),
    );
    const above = make(
      'button',
      { type: 'button', class: 'chip', on: { click: () => this.#scene?.lookFromAbove() } },
      'From above',
    );
    const tools = make(
      'div',
      { class: 'tools' },
      ...chips,
      make('span', { class: 'spacer' }),
      above,
      iconButton('Show all of the model', icon('fit'), () => this.#scene?.fit()),
    );
    this.node = make(
      'section',
      { class: 'pane pane-3d', 'aria-label': 'Model' },
      tools,
      this.#host,
      this.#notice,
    );
  }

  disconnect(): void {
    this.#life++;
    this.#scene?.dispose();
    this.#scene = null;
    this.#opening = null;
    this.#shown = null;
  }

  async show({ view, name }: Model): Promise<void> {
    // A pane that is not seen costs nothing until it is.
    if (!view || view === this.#shown || this.#host.clientWidth === 0) return;
    this.#shown = view;
    const scene = await this.#open();
    if (!scene || view !== this.#shown) return;
    const { up, metresPerUnit } = view.plan.frame;
    const subject = JSON.stringify([name, up, metresPerUnit]);
    const isNew = subject !== this.#subject;
    this.#subject = subject;
    scene.show(contentOf(view), isNew);
  }

  async preview(positions: Float32Array): Promise<void> {
    if (this.#shown || this.#host.clientWidth === 0) return;
    const scene = await this.#open();
    if (!this.#shown) scene?.preview(positions);
  }

  fit(): void {
    this.#scene?.fit();
  }

  #open(): Promise<SceneView | null> {
    this.#opening ??= this.#make();
    return this.#opening;
  }

  async #make(): Promise<SceneView | null> {
    const life = this.#life;
    const module = await import('../view/scene.ts').catch(() => null);
    if (life !== this.#life) return null;
    if (!module) {
      this.#fail(
        'The part of the program that shows the model could not be fetched. Reload the page to try again.',
      );
      return null;
    }
    this.#scene = new module.SceneView(this.#host, this.#layers, {
      onFailed: (error) => this.#fail(`${error.message} ${error.hint} (${error.code})`),
      ...this.#axes,
    });
    return this.#scene;
  }

  #fail(words: string): void {
    setText(this.#notice, words);
    this.#notice.hidden = false;
  }
}

function contentOf({ solid, cloud, plan }: PlanView): SceneContent {
  const top = Math.max(...plan.storeys.map(({ floor, height }) => floor + height));
  return { solid, positions: cloud.positions, colour: cloud.colour, top, frame: plan.frame };
}
