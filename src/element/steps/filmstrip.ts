import type { PictureFacts } from '../../worker/protocol.ts';
import { make, setAttribute, setText } from '../make.ts';
import type { Actions } from '../model.ts';

interface Still {
  readonly tab: HTMLButtonElement;
  readonly image: HTMLImageElement;
  readonly label: HTMLElement;
  svg: string;
}

/** The steps in small, in order; the one shown is marked. */
export class Filmstrip {
  readonly node: HTMLElement;
  readonly #actions: Actions;
  readonly #stills = new Map<string, Still>();

  constructor(actions: Actions) {
    this.#actions = actions;
    this.node = make('div', { class: 'filmstrip', role: 'tablist', 'aria-label': 'Steps of this plan' });
  }

  show(pictures: readonly PictureFacts[], chosen: PictureFacts): void {
    const names = new Set(pictures.map(({ name }) => name));
    for (const name of [...this.#stills.keys()]) if (!names.has(name)) this.#drop(name);
    const tabs = pictures.map((facts) => this.#still(facts).tab);
    const isSame = tabs.length === this.node.childElementCount;
    if (!isSame || tabs.some((tab, i) => this.node.children[i] !== tab)) this.node.replaceChildren(...tabs);
    for (const { name, label } of pictures) {
      const still = this.#stills.get(name)!;
      const isChosen = name === chosen.name;
      setText(still.label, label);
      if (isChosen && still.tab.ariaSelected !== 'true') this.#bringIntoSight(still.tab);
      setAttribute(still.tab, 'aria-selected', String(isChosen));
      setAttribute(still.tab, 'tabindex', isChosen ? 0 : -1);
    }
  }

  /** @param svg the picture in full; a small image shows it */
  setPicture(name: string, svg: string): void {
    const still = this.#stills.get(name);
    if (!still || still.svg === svg) return;
    still.svg = svg;
    const before = still.image.src;
    still.image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    still.image.hidden = false;
    if (before) URL.revokeObjectURL(before);
  }

  /** The keyboard follows the mark, which the next frame moves. */
  keepFocus(): void {
    requestAnimationFrame(() => this.node.querySelector<HTMLElement>('[aria-selected="true"]')?.focus());
  }

  dispose(): void {
    for (const name of [...this.#stills.keys()]) this.#drop(name);
    this.node.replaceChildren();
  }

  #still({ name, label }: PictureFacts): Still {
    const known = this.#stills.get(name);
    if (known) return known;
    const image = make('img', { alt: '', draggable: 'false', hidden: true });
    const words = make('span', { class: 'still-label' }, label);
    const tab = make(
      'button',
      {
        type: 'button',
        class: 'still',
        role: 'tab',
        id: `step-${name}`,
        testid: `step-${name}`,
        'aria-selected': 'false',
        'aria-controls': 'step-picture',
        on: { click: () => this.#actions.showStep(name) },
      },
      make('span', { class: 'still-frame' }, image),
      words,
    );
    const still = { tab, image, label: words, svg: '' };
    this.#stills.set(name, still);
    return still;
  }

  #drop(name: string): void {
    const still = this.#stills.get(name);
    if (still?.image.src) URL.revokeObjectURL(still.image.src);
    this.#stills.delete(name);
  }

  /** Scrolls the strip alone: `scrollIntoView` would move the page around it too. */
  #bringIntoSight(tab: HTMLElement): void {
    const { offsetLeft, offsetWidth } = tab;
    const { scrollLeft, clientWidth } = this.node;
    const least = offsetLeft + 2 * offsetWidth - clientWidth;
    const most = offsetLeft - offsetWidth;
    this.node.scrollLeft = Math.min(Math.max(scrollLeft, least), Math.max(most, 0));
  }
}
