import { PARAMS } from '../../core/params.ts';
import { formatCount } from '../../view/measure.ts';
import { clusterColour } from '../../write/pictures/palette.ts';
import { make, setAttribute } from '../make.ts';
import type { Actions, Model, Panel } from '../model.ts';

/**
 * The hand's part in [Stojanovic19] §3.1: which cluster holds the structure, and one more round of refinement, or
 * one less. Shown beside the pictures of the structures; both are parameters, so undo takes them back too.
 */
export class ClusterPicker implements Panel {
  readonly node: HTMLElement;
  readonly #actions: Actions;
  readonly #list = make('div', {
    class: 'cluster-list',
    role: 'group',
    'aria-label': 'Cluster of the structure',
  });
  readonly #refine: HTMLButtonElement;
  readonly #takeBack: HTMLButtonElement;
  #rounds = 1;
  #clusters: Uint8Array | null = null;

  constructor(actions: Actions) {
    this.#actions = actions;
    this.#refine = this.#roundButton('Refine once more', 'refine', 1);
    this.#takeBack = this.#roundButton('Take back', 'take-back', -1);
    const refinement = make('div', { class: 'refinement' }, this.#takeBack, this.#refine);
    this.node = make('div', { class: 'cluster-picker', hidden: true }, this.#list, refinement);
  }

  show({ steps, view, options }: Model): void {
    const clusters = view?.secondary.clusters;
    const isPaper = view?.options.secondaryMethod === 'paper';
    this.node.hidden =
      steps.of === 'failed' || steps.picture?.stage !== 'secondary' || !isPaper || !clusters?.length;
    if (this.node.hidden || !clusters) return;
    if (clusters !== this.#clusters) this.#fill(clusters);
    this.#clusters = clusters;
    const picked = String(options.secondaryCluster);
    for (const button of this.#list.children)
      setAttribute(button, 'aria-pressed', String((button as HTMLElement).dataset.cluster === picked));
    this.#rounds = options.secondaryRounds;
    this.#refine.disabled = this.#rounds >= PARAMS.secondaryRounds.max;
    this.#takeBack.hidden = this.#rounds <= PARAMS.secondaryRounds.min;
  }

  /** Takes the cluster that was pressed in the picture. */
  pick(pressed: Element): void {
    const [kind, cluster] = (pressed as SVGElement).dataset.pick?.split(':') ?? [];
    if (!this.node.hidden && kind === 'cluster') this.#choose(Number(cluster));
  }

  #roundButton(label: string, testid: string, by: 1 | -1): HTMLButtonElement {
    return make(
      'button',
      {
        type: 'button',
        class: 'button',
        testid,
        title: PARAMS.secondaryRounds.doc,
        on: { click: () => this.#actions.change({ secondaryRounds: this.#rounds + by }, true) },
      },
      label,
    );
  }

  #choose(cluster: number | 'auto'): void {
    this.#actions.change({ secondaryCluster: cluster }, true);
  }

  #fill(clusters: Uint8Array): void {
    const sizes: number[] = [];
    for (const cluster of clusters) sizes[cluster] = (sizes[cluster] ?? 0) + 1;
    const buttons = sizes.map((size, cluster) => this.#button(cluster, `${formatCount(size)} points`));
    this.#list.replaceChildren('Cluster', this.#button('auto', 'Auto'), ...buttons);
  }

  #button(cluster: number | 'auto', label: string): HTMLButtonElement {
    const swatch = make('span', { class: 'swatch', hidden: cluster === 'auto' });
    if (cluster !== 'auto') swatch.style.setProperty('--swatch', clusterColour(cluster));
    const name = cluster === 'auto' ? label : `${cluster}: ${label}`;
    return make(
      'button',
      {
        type: 'button',
        class: 'chip',
        'data-cluster': cluster,
        'aria-pressed': 'false',
        on: { click: () => this.#choose(cluster) },
      },
      swatch,
      name,
    );
  }
}
