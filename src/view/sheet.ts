import { sourceCoordinates } from '../core/source-coordinates.ts';
import type { Frame, Slice } from '../core/types.ts';
import type { DisplayUnit } from './measure.ts';
import { PanZoom } from './pan-zoom.ts';
import { type Drawing, parseDrawing, type SheetTransform } from './parse-drawing.ts';
import { PointLayer } from './point-layer.ts';
import { listenForPress } from './press.ts';
import { ScaleBar } from './scale-bar.ts';
import { type SheetMark, SheetMarks } from './sheet-marks.ts';

export interface SheetContent {
  /** The SVG text that is exported. */
  readonly drawing: string;
  readonly frame: Frame;
  /** Name of the scan. */
  readonly source: string;
  /** Points beneath the drawing. */
  readonly slice: Slice;
}

/** A place of the plan under a pointer. */
export interface SheetPlace {
  /** Plan metres. */
  readonly at: readonly [x: number, y: number];
  /** What a hand misses by, m. */
  readonly reach: number;
}

/** What a pointer does to the plan while it is held. */
export interface SheetTool {
  /** Where it rests; null where it left, and for what cannot rest, as a finger. */
  hover(place: SheetPlace | null): void;
  press(place: SheetPlace): void;
}

/** A mouse and a finger miss by so much, px. */
const MOUSE_REACH = 4;
const TOUCH_REACH = 14;
/** Room left around the sheet when it is fitted, and for the scale bar under it, px. */
const MARGIN = 16;
const FOOT = 40;
/** Coordinates are read to a millimetre, whatever the source unit. m */
const PRECISION = 0.001;

/** The 2D view: the exported SVG itself with pan and zoom, the slice's points beneath it, a scale bar and coordinates. */
export class SheetView {
  readonly #host: HTMLElement;
  readonly #page = document.createElement('div');
  readonly #points = new PointLayer();
  readonly #paper = document.createElement('div');
  readonly #marks = new SheetMarks();
  readonly #scaleBar = new ScaleBar();
  readonly #coordinates = document.createElement('div');
  readonly #panZoom: PanZoom;
  readonly #resize: ResizeObserver;
  readonly #listening = new AbortController();
  #tool: SheetTool | null = null;
  #drawing: Drawing | null = null;
  #frame: Frame | null = null;
  #unit: DisplayUnit = 'm';
  #pending = 0;

  /** @param host an empty element; it gets the keyboard focus and the gestures */
  constructor(host: HTMLElement) {
    this.#host = host;
    host.tabIndex = 0;
    host.setAttribute('role', 'group');
    host.setAttribute('aria-label', 'Floor plan. Arrow keys move, plus and minus zoom, 0 shows all.');
    this.#page.className = 'page';
    this.#paper.className = 'paper';
    this.#paper.dataset.testid = 'plan-svg';
    this.#paper.hidden = true;
    this.#coordinates.className = 'coordinates';
    this.#scaleBar.node.hidden = true;
    host.append(this.#page, this.#points.node, this.#paper, this.#marks.node);
    host.append(this.#coordinates, this.#scaleBar.node);
    this.#panZoom = new PanZoom(host, { onMove: () => this.#schedule(), onFit: () => this.fit() });
    this.#resize = new ResizeObserver(() => (this.#panZoom.isFitted ? this.fit() : this.#schedule()));
    this.#resize.observe(host);
    this.#listen();
  }

  /** Shows a drawing; place and zoom stay where the sheet is the same, unless it `isNew`. @throws input/malformed */
  show({ drawing, frame, source, slice }: SheetContent, isNew: boolean): void {
    const next = parseDrawing(drawing);
    const isSame = this.#drawing !== null && String(next.planToSheet) === String(this.#drawing.planToSheet);
    next.svg.dataset.source = source;
    next.svg.classList.add('drawing');
    next.svg.setAttribute('role', 'img');
    next.svg.style.width = `${next.width}px`;
    next.svg.style.height = `${next.height}px`;
    this.#drawing = next;
    this.#frame = frame;
    this.#paper.replaceChildren(next.svg);
    this.#points.set(slice.xy, slice.spacing);
    this.#paper.hidden = false;
    this.#scaleBar.node.hidden = false;
    if (isSame && !isNew && !this.#panZoom.isFitted) this.#schedule();
    else this.fit();
  }

  /** Shows points seen from above before there is a drawing; the axis of least extent is taken as height. */
  preview(positions: Float32Array): void {
    if (this.#drawing) return;
    const { xy, planToSheet } = flatten(positions, this.#host);
    this.#points.set(xy, 0);
    void this.#points.draw(planToSheet, { zoom: 1, x: 0, y: 0 });
  }

  setUnit(unit: DisplayUnit): void {
    this.#unit = unit;
    this.#schedule();
  }

  showPoints(isShown: boolean): void {
    this.#points.node.hidden = !isShown;
    if (isShown) this.#schedule();
  }

  /** Hands the pointer to a tool, beside moving and zooming; null takes it back. */
  setTool(tool: SheetTool | null): void {
    this.#tool = tool;
    this.#host.classList.toggle('has-tool', tool !== null);
  }

  /** Marks stretches of wall; those before go. */
  mark(marks: readonly SheetMark[]): void {
    this.#marks.set(marks);
    if (this.#drawing) this.#marks.draw(this.#drawing.planToSheet, this.#panZoom.placement);
  }

  fit(): void {
    if (!this.#drawing) return;
    const { width, height } = this.#drawing;
    this.#panZoom.fit(width, height, { margin: MARGIN, foot: FOOT });
  }

  zoomIn(): void {
    this.#panZoom.zoomIn();
  }

  zoomOut(): void {
    this.#panZoom.zoomOut();
  }

  dispose(): void {
    cancelAnimationFrame(this.#pending);
    this.#resize.disconnect();
    this.#panZoom.dispose();
    this.#listening.abort();
    this.#host.replaceChildren();
  }

  #schedule(): void {
    cancelAnimationFrame(this.#pending);
    this.#pending = requestAnimationFrame(() => void this.#draw());
  }

  async #draw(): Promise<void> {
    const drawing = this.#drawing;
    if (!drawing) return;
    const placement = this.#panZoom.placement;
    const { zoom, x, y } = placement;
    const [a, b] = drawing.planToSheet;
    // Points take a moment; the drawing waits for them, so that both move as one.
    if (!this.#points.node.hidden) await this.#points.draw(drawing.planToSheet, placement);
    drawing.svg.style.transform = `matrix(${zoom}, 0, 0, ${zoom}, ${x}, ${y})`;
    this.#marks.draw(drawing.planToSheet, placement);
    this.#page.style.transform = `translate(${x}px, ${y}px)`;
    this.#page.style.width = `${zoom * drawing.width}px`;
    this.#page.style.height = `${zoom * drawing.height}px`;
    this.#scaleBar.show(zoom * Math.hypot(a, b), this.#unit);
  }

  #listen(): void {
    const { signal } = this.#listening;
    const host = this.#host;
    host.addEventListener('pointermove', (event) => this.#point(event), { signal });
    host.addEventListener('pointerleave', () => this.#leave(), { signal });
    // The host's colour has a transition, so its end tells that the theme changed.
    host.addEventListener('transitionend', ({ target }) => target === host && this.#schedule(), { signal });
    listenForPress(host, (click, pointerType) => this.#press(click, pointerType), signal);
    // With a tool in hand two presses are two presses.
    const isolate = (event: Event) => this.#tool && event.stopPropagation();
    host.addEventListener('dblclick', isolate, { signal, capture: true });
  }

  #point(event: PointerEvent): void {
    const place = this.#placeOf(event, event.pointerType);
    if (!place || !this.#frame) return;
    const to = sourceCoordinates(this.#frame, PRECISION);
    const read = (value: number) => value.toFixed(to.digits);
    const [x, y] = place.at;
    this.#coordinates.textContent = `${read(to.x(x))}, ${read(to.y(y))} ${this.#frame.unit}`;
    const isResting = event.buttons === 0 && event.pointerType !== 'touch';
    this.#tool?.hover(isResting ? place : null);
  }

  #press(click: MouseEvent, pointerType: string): void {
    const place = this.#placeOf(click, pointerType);
    if (place) this.#tool?.press(place);
  }

  #leave(): void {
    this.#coordinates.textContent = '';
    this.#tool?.hover(null);
  }

  #placeOf({ clientX, clientY }: MouseEvent, pointerType: string): SheetPlace | null {
    if (!this.#drawing) return null;
    const { planToSheet } = this.#drawing;
    const { left, top } = this.#host.getBoundingClientRect();
    const { zoom, x, y } = this.#panZoom.placement;
    const reach = pointerType === 'touch' ? TOUCH_REACH : MOUSE_REACH;
    return {
      at: invert(planToSheet, (clientX - left - x) / zoom, (clientY - top - y) / zoom),
      reach: reach / (zoom * Math.hypot(planToSheet[0], planToSheet[1])),
    };
  }
}

function invert([a, b, c, d, e, f]: SheetTransform, x: number, y: number): readonly [number, number] {
  const determinant = a * d - b * c;
  return [(d * (x - e) - c * (y - f)) / determinant, (a * (y - f) - b * (x - e)) / determinant];
}

/** Positions without their axis of least extent, and the transform that fits them into `host`. */
function flatten(
  positions: Float32Array,
  host: HTMLElement,
): { xy: Float64Array; planToSheet: SheetTransform } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const extent = high.map((value, axis) => value - low[axis]);
  const flat = extent.indexOf(Math.min(...extent));
  const [u, v] = [0, 1, 2].filter((axis) => axis !== flat);
  const xy = new Float64Array((positions.length / 3) * 2);
  for (let i = 0; i < positions.length / 3; i++) {
    xy[2 * i] = positions[3 * i + u];
    xy[2 * i + 1] = positions[3 * i + v];
  }
  const { clientWidth, clientHeight } = host;
  const k = Math.min(
    (clientWidth - 2 * MARGIN) / Math.max(extent[u], Number.EPSILON),
    (clientHeight - 2 * MARGIN) / Math.max(extent[v], Number.EPSILON),
  );
  const [cx, cy] = [(low[u] + high[u]) / 2, (low[v] + high[v]) / 2];
  return { xy, planToSheet: [k, 0, 0, -k, clientWidth / 2 - k * cx, clientHeight / 2 + k * cy] };
}
