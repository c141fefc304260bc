import { SheetView } from '../view/sheet.ts';
import { iconButton, toggleChip } from './chips.ts';
import { icon } from './icon.ts';
import { make, setAttribute, setText } from './make.ts';
import type { Actions, Model } from './model.ts';

/** The 2D view with what switches it. */
export class SheetPane {
  readonly #host = make('div', { class: 'sheet', part: 'sheet' });
  readonly #storeys = make('div', {
    class: 'choices storeys',
    role: 'group',
    'aria-label': 'Storey',
    hidden: true,
  });
  readonly #actions: Actions;
  readonly node: HTMLElement;
  #sheet: SheetView | null = null;
  #drawing = '';
  #name = '';

  constructor(actions: Actions) {
    this.#actions = actions;
    const points = toggleChip('Points', true, (isShown) => this.#sheet?.showPoints(isShown));
    this.node = make(
      'section',
      { class: 'pane pane-2d', 'aria-label': 'Plan' },
      make(
        'div',
        { class: 'tools' },
        points,
        this.#storeys,
        make('span', { class: 'spacer' }),
        iconButton('Zoom out', icon('minus'), () => this.#sheet?.zoomOut()),
        iconButton('Zoom in', icon('plus'), () => this.#sheet?.zoomIn()),
        iconButton('Show all of the plan', icon('fit'), () => this.#sheet?.fit()),
      ),
      this.#host,
    );
  }

  connect(): void {
    this.#sheet = new SheetView(this.#host);
    this.#drawing = '';
  }

  disconnect(): void {
    this.#sheet?.dispose();
    this.#sheet = null;
  }

  show({ view, storey, unit, name }: Model): void {
    this.#sheet?.setUnit(unit);
    if (!view) return;
    this.#showStoreys(view.drawings.length, storey);
    const drawing = view.drawings[Math.min(storey, view.drawings.length - 1)];
    if (drawing === this.#drawing) return;
    this.#drawing = drawing;
    const { frame, source } = view.plan;
    this.#sheet?.show({ drawing, frame, source: source.name, slice: view.slice }, name !== this.#name);
    this.#name = name;
  }

  preview(positions: Float32Array): void {
    this.#sheet?.preview(positions);
  }

  fit(): void {
    this.#sheet?.fit();
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
