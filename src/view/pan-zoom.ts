/** Where a sheet lies in its window: px = zoom · mm + (x, y). */
export interface Placement {
  readonly zoom: number;
  readonly x: number;
  readonly y: number;
}

export interface PanZoomEvents {
  onMove(placement: Placement): void;
  onFit(): void;
}

/** One notch of a wheel, one press of + or −. */
const STEP = 1.25;
/** Wheel travel that zooms by {@link STEP}, px. */
const WHEEL_NOTCH = 100;
/** A line of a wheel that tells lines, px. */
const WHEEL_LINE = 33;
/** A pinch on a touchpad comes as a wheel with ctrlKey and travel this many times smaller. */
const PINCH = 4;
/** An arrow key moves by this, px. */
const ARROW = 48;
/** Bounds of zoom relative to the whole sheet in view. */
const FURTHEST = 0.4;
const NEAREST = 80;

/** Pointer, pinch, wheel and keyboard gestures that move a sheet in `host`. */
export class PanZoom {
  readonly #host: HTMLElement;
  readonly #events: PanZoomEvents;
  readonly #pointers = new Map<number, readonly [x: number, y: number]>();
  readonly #listening = new AbortController();
  #placement: Placement = { zoom: 1, x: 0, y: 0 };
  #fitZoom = 1;
  #isFitted = true;

  constructor(host: HTMLElement, events: PanZoomEvents) {
    this.#host = host;
    this.#events = events;
    const { signal } = this.#listening;
    host.addEventListener('pointerdown', (event) => this.#down(event), { signal });
    host.addEventListener('pointermove', (event) => this.#drag(event), { signal });
    for (const type of ['pointerup', 'pointercancel'] as const) {
      host.addEventListener(type, ({ pointerId }) => this.#pointers.delete(pointerId), { signal });
    }
    host.addEventListener('wheel', (event) => this.#wheel(event), { signal, passive: false });
    host.addEventListener('keydown', (event) => this.#key(event), { signal });
    host.addEventListener('dblclick', () => events.onFit(), { signal });
  }

  get placement(): Placement {
    return this.#placement;
  }

  /** Whether the sheet lies as {@link fit} put it. */
  get isFitted(): boolean {
    return this.#isFitted;
  }

  /** Centres a sheet of `width` × `height` with `margin` px around it and `foot` px below. */
  fit(width: number, height: number, { margin, foot }: { margin: number; foot: number }): void {
    const { clientWidth, clientHeight } = this.#host;
    const room = [Math.max(1, clientWidth - 2 * margin), Math.max(1, clientHeight - margin - foot)];
    const zoom = Math.min(room[0] / width, room[1] / height);
    this.#fitZoom = zoom;
    this.#move({ zoom, x: (clientWidth - zoom * width) / 2, y: margin + (room[1] - zoom * height) / 2 });
    this.#isFitted = true;
  }

  /** Puts the sheet somewhere. */
  place(placement: Placement): void {
    this.#move(placement);
  }

  zoomIn(): void {
    this.#zoomBy(STEP, this.#centre());
  }

  zoomOut(): void {
    this.#zoomBy(1 / STEP, this.#centre());
  }

  dispose(): void {
    this.#listening.abort();
  }

  #move(placement: Placement): void {
    this.#placement = placement;
    this.#isFitted = false;
    this.#events.onMove(placement);
  }

  #zoomBy(factor: number, [px, py]: readonly [number, number]): void {
    const { zoom, x, y } = this.#placement;
    const next = Math.min(this.#fitZoom * NEAREST, Math.max(this.#fitZoom * FURTHEST, zoom * factor));
    const ratio = next / zoom;
    this.#move({ zoom: next, x: px - (px - x) * ratio, y: py - (py - y) * ratio });
  }

  #panBy(dx: number, dy: number): void {
    const { zoom, x, y } = this.#placement;
    this.#move({ zoom, x: x + dx, y: y + dy });
  }

  #centre(): readonly [number, number] {
    return [this.#host.clientWidth / 2, this.#host.clientHeight / 2];
  }

  #local({ clientX, clientY }: MouseEvent): readonly [number, number] {
    const { left, top } = this.#host.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  #down(event: PointerEvent): void {
    if (event.button !== 0 && event.button !== 1) return;
    this.#host.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, this.#local(event));
  }

  #drag(event: PointerEvent): void {
    const before = this.#pointers.get(event.pointerId);
    if (!before) return;
    const now = this.#local(event);
    const other = [...this.#pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.#pointers.set(event.pointerId, now);
    if (!other) {
      this.#panBy(now[0] - before[0], now[1] - before[1]);
      return;
    }
    const middle = (p: readonly [number, number]) => [(p[0] + other[0]) / 2, (p[1] + other[1]) / 2] as const;
    const apart = (p: readonly [number, number]) => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
    const [from, to] = [middle(before), middle(now)];
    this.#panBy(to[0] - from[0], to[1] - from[1]);
    this.#zoomBy(apart(now) / apart(before), to);
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? WHEEL_LINE : 1;
    const travel = unit * event.deltaY * (event.ctrlKey ? PINCH : 1);
    this.#zoomBy(STEP ** (-travel / WHEEL_NOTCH), this.#local(event));
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const moves: Record<string, () => void> = {
      '+': () => this.zoomIn(),
      '=': () => this.zoomIn(),
      '-': () => this.zoomOut(),
      '0': () => this.#events.onFit(),
      ArrowLeft: () => this.#panBy(ARROW, 0),
      ArrowRight: () => this.#panBy(-ARROW, 0),
      ArrowUp: () => this.#panBy(0, ARROW),
      ArrowDown: () => this.#panBy(0, -ARROW),
    };
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    move();
  }
}
