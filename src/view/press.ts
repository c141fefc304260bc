/** A press that moves further than this is a drag, px. */
const STILL = 4;

/** A press on `host`, not the end of a drag: the click, and what pressed. */
export function listenForPress(
  host: HTMLElement,
  onPress: (click: MouseEvent, pointerType: string) => void,
  signal: AbortSignal,
): void {
  let down = { x: 0, y: 0, pointerType: 'mouse' };
  host.addEventListener(
    'pointerdown',
    ({ clientX, clientY, pointerType }) => {
      down = { x: clientX, y: clientY, pointerType };
    },
    { signal },
  );
  host.addEventListener(
    'click',
    (click) => {
      const moved = Math.hypot(click.clientX - down.x, click.clientY - down.y);
      if (moved < STILL) onPress(click, down.pointerType);
    },
    { signal },
  );
}

/** What a pointer does while it is held. */
export interface PointerDrag {
  move(event: PointerEvent): void;
  drop(): void;
  cancel(): void;
}

/**
 * Drags on `host` that come before its other gestures: where `onDown` answers, nothing else hears of the pointer until
 * it is released. A second pointer, as for a pinch, cancels.
 */
export function listenForDrag(
  host: HTMLElement,
  onDown: (event: PointerEvent) => PointerDrag | null,
  signal: AbortSignal,
): void {
  let held: { readonly pointerId: number; readonly drag: PointerDrag } | null = null;
  const options = { signal, capture: true };
  const listen = (type: 'pointerdown' | 'pointermove' | 'pointerup' | 'pointercancel', act: Listener) =>
    host.addEventListener(type, act, options);
  const end = (event: PointerEvent, act: 'drop' | 'cancel') => {
    if (event.pointerId !== held?.pointerId) return;
    const { drag } = held;
    held = null;
    drag[act]();
  };
  listen('pointerdown', (event) => {
    if (held) {
      held.drag.cancel();
      held = null;
      return;
    }
    const drag = onDown(event);
    if (!drag) return;
    event.stopPropagation();
    host.setPointerCapture(event.pointerId);
    held = { pointerId: event.pointerId, drag };
  });
  listen('pointermove', (event) => event.pointerId === held?.pointerId && held.drag.move(event));
  listen('pointerup', (event) => end(event, 'drop'));
  listen('pointercancel', (event) => end(event, 'cancel'));
}

type Listener = (event: PointerEvent) => void;
