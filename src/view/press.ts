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
