import { make } from './make.ts';

/** Share of the left pane: bounds, start and one press of an arrow key. */
const LEAST = 0.2;
const MOST = 0.8;
const EVEN = 0.5;
const STEP = 0.02;

/** A line between two panes that can be dragged, moved with arrow keys, and set even again by a double click. */
export function makeDivider(panes: () => HTMLElement): HTMLElement {
  let share = EVEN;
  const set = (next: number) => {
    share = Math.min(MOST, Math.max(LEAST, next));
    panes().style.setProperty('--share', String(share));
    node.setAttribute('aria-valuenow', String(Math.round(share * 100)));
  };
  const node = make('div', {
    class: 'divider',
    role: 'separator',
    tabindex: 0,
    'aria-orientation': 'vertical',
    'aria-label': 'Width of the plan',
    'aria-valuemin': LEAST * 100,
    'aria-valuemax': MOST * 100,
    'aria-valuenow': EVEN * 100,
    on: {
      pointerdown: (event: PointerEvent) => node.setPointerCapture(event.pointerId),
      pointermove: (event: PointerEvent) => {
        if (!node.hasPointerCapture(event.pointerId)) return;
        const { left, width } = panes().getBoundingClientRect();
        set((event.clientX - left) / width);
      },
      dblclick: () => set(EVEN),
      keydown: ({ key }: KeyboardEvent) => {
        if (key === 'ArrowLeft') set(share - STEP);
        if (key === 'ArrowRight') set(share + STEP);
      },
    },
  });
  return node;
}
