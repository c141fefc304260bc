import { sayCoordinates, sayUnit } from '../core/source-coordinates.ts';
import type { Frame, Slice, Vec2 } from '../core/types.ts';
import type { DisplayUnit } from '../write/sheet/measure-words.ts';
import { PanZoom } from './pan-zoom.ts';
import { type Drawing, parseDrawing } from './parse-drawing.ts';
import { PointLayer } from './point-layer.ts';
import { listenForDrag, listenForPress, type PointerDrag } from './press.ts';
import { ScaleBar } from './scale-bar.ts';
import { type SheetMark, SheetMarks } from './sheet-marks.ts';
import { flatten, invert, placementFor, resizeCursor, sightOf } from './sheet-place.ts';

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
  readonly at: Vec2;
  /** What a hand misses by, m. */
  readonly reach: number;
  /** Of the plan on its sheet, radians, counter-clockwise. */
  readonly turn: number;
}

/** What a pointer does to the plan while it is held. */
export interface SheetTool {
  /** Where it rests; null where it left, and for what cannot rest, as a finger. */
  hover(place: SheetPlace | null): void;
  press(place: SheetPlace): void;
  /** How the pointer looks where it rests. */
  readonly cursor?: SheetCursor;
  /** Takes what lies under a pointer that goes down, instead of moving the sheet; null where nothing does. */
  grab?(place: SheetPlace): SheetDrag | null;
}

/** What a pointer holds until it is released. */
export interface SheetDrag {
  move(place: SheetPlace): void;
  drop(): void;
  /** As if it had never been taken. */
  cancel(): void;
}

/** How the pointer looks: it moves something, or an edge of it in a direction of the plan. */
export type SheetCursor = 'move' | readonly [dx: number, dy: number] | null;

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
  /** Points the plan was not made from. */
  readonly #around = new PointLayer('points around');
  readonly #points = new PointLayer('points');
  readonly #paper = document.createElement('div');
  readonly #marks = new SheetMarks();
  readonly #scaleBar = new ScaleBar();
  readonly #coordinates = document.createElement('div');
  readonly #panZoom: PanZoom;
  readonly #resize: ResizeObserver;
  readonly #listening = new AbortController();
  #tool: SheetTool | null = null;
  #drag: SheetDrag | null = null;
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
    this.#around.node.hidden = true;
    host.append(this.#page, this.#around.node, this.#points.node, this.#paper, this.#marks.node);
    host.append(this.#coordinates, this.#scaleBar.node);
    this.#panZoom = new PanZoom(host, { onMove: () => this.#schedule(), onFit: () => this.fit() });
    this.#resize = new ResizeObserver(() => (this.#panZoom.isFitted ? this.fit() : this.#schedule()));
    this.#resize.observe(host);
    this.#listen();
  }

  /** Shows a drawing; place and zoom stay where the sheet is the same, unless it `isNew`. @throws input/malformed */
  show({ drawing, frame, source, slice }: SheetContent, isNew: boolean): void {
    const next = parseDrawing(drawing);
    const sheet = this.#drawing && this.#frame && { drawing: this.#drawing, frame: this.#frame };
    const before = sheet && !isNew ? sightOf(sheet, this.#panZoom.placement, this.#size) : null;
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
    // With a tool in hand that drags, the plan stays under it though the sheet is another.
    else if (this.#tool?.grab && before) {
      this.#panZoom.place(placementFor(before, { drawing: next, frame }, this.#size));
    } else this.fit();
  }

  /** Shows points seen from above before there is a drawing; the axis of least extent is taken as height. */
  preview(positions: Float32Array): void {
    if (this.#drawing) return;
    const { xy, planToSheet } = flatten(positions, this.#size, MARGIN);
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

  /** Points beneath those of the slice, paler; none takes them away. @param xy x, y a point, m */
  showAround(xy: Float64Array): void {
    if (xy === this.#around.xy) return;
    this.#around.node.hidden = xy.length === 0;
    this.#around.set(xy, 0);
    this.#schedule();
  }

  /** Hands the pointer to a tool, beside moving and zooming; null takes it back. */
  setTool(tool: SheetTool | null): void {
    this.#drag?.cancel();
    this.#drag = null;
    this.#tool = tool;
    this.#host.classList.toggle('has-tool', tool !== null);
    this.#showCursor();
  }

  /** Marks places of the plan; the marks before go. */
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

  get #size(): readonly [width: number, height: number] {
    return [this.#host.clientWidth, this.#host.clientHeight];
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
    for (const layer of [this.#around, this.#points]) {
      if (!layer.node.hidden) await layer.draw(drawing.planToSheet, placement);
    }
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
    const grab = (event: PointerEvent) => this.#grab(event);
    listenForDrag(host, grab, signal);
    listenForPress(host, (click, pointerType) => this.#press(click, pointerType), signal);
    // With a tool in hand two presses are two presses.
    const isolate = (event: Event) => this.#tool && event.stopPropagation();
    host.addEventListener('dblclick', isolate, { signal, capture: true });
  }

  #showCursor(): void {
    const cursor = this.#tool?.cursor ?? null;
    const isDirection = cursor !== null && cursor !== 'move';
    this.#host.style.cursor = isDirection ? resizeCursor(cursor, this.#drawing) : (cursor ?? '');
  }

  #point(event: PointerEvent): void {
    const place = this.#placeOf(event, event.pointerType);
    if (!place || !this.#frame) return;
    const coordinates = sayCoordinates(this.#frame, place.at, PRECISION);
    this.#coordinates.textContent = `${coordinates} ${sayUnit(this.#frame.unit)}`;
    if (this.#drag) return;
    const isResting = event.buttons === 0 && event.pointerType !== 'touch';
    this.#tool?.hover(isResting ? place : null);
    this.#showCursor();
  }

  #grab(event: PointerEvent): PointerDrag | null {
    const place = event.button === 0 ? this.#placeOf(event, event.pointerType) : null;
    const drag = (place && this.#tool?.grab?.(place)) ?? null;
    if (!drag) return null;
    this.#drag = drag;
    const end = (act: 'drop' | 'cancel') => {
      if (this.#drag !== drag) return;
      this.#drag = null;
      drag[act]();
    };
    return {
      move: (moved) => {
        const to = this.#placeOf(moved, moved.pointerType);
        if (to && this.#drag === drag) drag.move(to);
      },
      drop: () => end('drop'),
      cancel: () => end('cancel'),
    };
  }

  #press(click: MouseEvent, pointerType: string): void {
    const place = this.#placeOf(click, pointerType);
    if (place) this.#tool?.press(place);
  }

  #leave(): void {
    this.#coordinates.textContent = '';
    this.#tool?.hover(null);
  }

  #planAt(left: number, top: number): Vec2 {
    const { zoom, x, y } = this.#panZoom.placement;
    return invert(this.#drawing!.planToSheet, (left - x) / zoom, (top - y) / zoom);
  }

  #placeOf({ clientX, clientY }: MouseEvent, pointerType: string): SheetPlace | null {
    if (!this.#drawing) return null;
    const { planToSheet } = this.#drawing;
    const { left, top } = this.#host.getBoundingClientRect();
    const { zoom } = this.#panZoom.placement;
    const reach = pointerType === 'touch' ? TOUCH_REACH : MOUSE_REACH;
    return {
      at: this.#planAt(clientX - left, clientY - top),
      reach: reach / (zoom * Math.hypot(planToSheet[0], planToSheet[1])),
      turn: Math.atan2(-planToSheet[1], planToSheet[0]),
    };
  }
}
