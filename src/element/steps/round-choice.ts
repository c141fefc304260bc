import { make, setAttribute } from '../make.ts';

/** Which round of [Stojanovic19] Algorithms 1 and 2 a picture shows. */
export class RoundChoice {
  readonly node = make('div', { class: 'rounds', role: 'group', 'aria-label': 'Round', hidden: true });
  readonly #onPick: (round: number) => void;

  constructor(onPick: (round: number) => void) {
    this.#onPick = onPick;
  }

  /** @param count of rounds; one is no choice */
  show(count: number, chosen: number): void {
    this.node.hidden = count < 2;
    if (this.node.childElementCount !== count)
      this.node.replaceChildren(...Array.from({ length: count }, (_, i) => this.#button(i + 1)));
    for (const [i, button] of [...this.node.children].entries())
      setAttribute(button, 'aria-pressed', String(i + 1 === chosen));
  }

  #button(round: number): HTMLButtonElement {
    const on = { click: () => this.#onPick(round) };
    return make('button', { type: 'button', class: 'chip', 'aria-pressed': 'false', on }, `Round ${round}`);
  }
}
