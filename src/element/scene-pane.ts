import type { AxisEvents } from '../view/axis-gizmo.ts';
import type { SceneContent, SceneLayers, SceneView } from '../view/scene.ts';
import type { PlanView } from '../worker/protocol.ts';
import { iconButton, toggleChip } from './chips.ts';
import { icon } from './icon.ts';
import { make, setText } from './make.ts';
import type { Model } from './model.ts';

/** What the points of a scan that has both may be coloured by. */
const SHADES = { colour: 'Colour', intensity: 'Intensity', height: 'Height' } as const;
type Shade = keyof typeof SHADES;
const LAYERS = { model: 'Model', cloud: 'Points', grid: 'Grid', ceiling: 'Ceiling' } as const;

/** The 3D view with what switches it. Its code comes when it is first seen, so the plan does not wait for it. */
export class ScenePane {
  readonly #host = make('div', { class: 'scene', part: 'scene', testid: 'scene-3d' });
  readonly #notice = make('p', { class: 'notice', hidden: true, role: 'status' });
  readonly #axes: AxisEvents;
  readonly node: HTMLElement;
  readonly #shades: HTMLSelectElement;
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
    const options = Object.entries(SHADES).map(([value, label]) => make('option', { value }, label));
    this.#shades = make(
      'select',
      {
        class: 'shade-choice',
        testid: 'shades',
        'aria-label': 'Points coloured by',
        title: 'What the points are coloured by',
        hidden: true,
        on: { change: () => this.#shown && this.#scene?.show(this.#contentOf(this.#shown), false) },
      },
      ...options,
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
      this.#shades,
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
    this.#shades.hidden = !view.cloud.colour || !view.cloud.intensity;
    scene.show(this.#contentOf(view), isNew);
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

  #contentOf({ solid, cloud, plan }: PlanView): SceneContent {
    const top = Math.max(...plan.storeys.map(({ floor, height }) => floor + height));
    const shades: Record<Shade, Uint8Array | undefined> = {
      colour: cloud.colour ?? cloud.intensity,
      intensity: cloud.intensity,
      height: undefined,
    };
    // A choice made for one scan does not hold for one that leaves none.
    const shade = this.#shades.hidden ? 'colour' : (this.#shades.value as Shade);
    return { solid, positions: cloud.positions, colour: shades[shade], top, frame: plan.frame };
  }
}
