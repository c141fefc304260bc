import { PanZoom } from './pan-zoom.ts';
import { parsePicture } from './parse-drawing.ts';

/** Room left around a fitted picture, px. */
const MARGIN = 12;
/** A press that moves further than this is a drag, px. */
const STILL = 4;
/** How far from its point a press may miss what it means, px: half a finger's touch target. */
const REACH = 20;
/** Steps of the search around a missed press: rings, and places on each. */
const RINGS = 4;
const PLACES = 12;

/** An SVG picture with pan and zoom. */
export class PictureView {
  readonly #host: HTMLElement;
  readonly #paper = document.createElement('div');
  readonly #panZoom: PanZoom;
  readonly #resize: ResizeObserver;
  readonly #listening = new AbortController();
  #svg: SVGSVGElement | null = null;
  #size: readonly [width: number, height: number] = [1, 1];
  #isFitted = true;
  #pressed: readonly [x: number, y: number] = [0, 0];

  /**
   * @param host an empty element; it gets the keyboard focus and the gestures
   * @param onPick what of the picture was pressed, or all but pressed
   */
  constructor(host: HTMLElement, onPick: (element: Element) => void) {
    this.#host = host;
    host.tabIndex = 0;
    host.setAttribute('role', 'group');
    this.#paper.className = 'paper';
    host.append(this.#paper);
    this.#panZoom = new PanZoom(host, { onMove: () => this.#moved(), onFit: () => this.fit() });
    this.#resize = new ResizeObserver(() => this.#isFitted && this.fit());
    this.#resize.observe(host);
    const { signal } = this.#listening;
    host.addEventListener('pointerdown', ({ clientX, clientY }) => this.#press(clientX, clientY), { signal });
    host.addEventListener(
      'click',
      ({ clientX, clientY }) => {
        const moved = Math.hypot(clientX - this.#pressed[0], clientY - this.#pressed[1]);
        const found = moved < STILL ? this.#near(clientX, clientY) : null;
        if (found) onPick(found);
      },
      { signal },
    );
  }

  /** Shows a picture; place and zoom stay where it is of the same size, unless it `isNew`. @throws input/malformed */
  show(text: string, isNew: boolean): void {
    const { svg, width, height } = parsePicture(text);
    const isSame = width === this.#size[0] && height === this.#size[1];
    svg.classList.add('drawing');
    svg.setAttribute('role', 'img');
    svg.style.width = `${width}px`;
    svg.style.height = `${height}px`;
    this.#svg = svg;
    this.#size = [width, height];
    this.#paper.replaceChildren(svg);
    if (isSame && !isNew && !this.#isFitted) this.#place();
    else this.fit();
  }

  fit(): void {
    this.#panZoom.fit(...this.#size, { margin: MARGIN, foot: MARGIN });
    this.#isFitted = true;
  }

  zoomIn(): void {
    this.#panZoom.zoomIn();
  }

  zoomOut(): void {
    this.#panZoom.zoomOut();
  }

  dispose(): void {
    this.#listening.abort();
    this.#resize.disconnect();
    this.#panZoom.dispose();
    this.#host.replaceChildren();
  }

  #moved(): void {
    this.#isFitted = false;
    this.#place();
  }

  #place(): void {
    const { zoom, x, y } = this.#panZoom.placement;
    if (this.#svg) this.#svg.style.transform = `matrix(${zoom}, 0, 0, ${zoom}, ${x}, ${y})`;
  }

  #press(x: number, y: number): void {
    this.#pressed = [x, y];
  }

  /** What can be picked at a place of the screen, else nearby: points are smaller than fingers. */
  #near(x: number, y: number): Element | null {
    const root = this.#host.getRootNode() as ShadowRoot;
    for (let ring = 0; ring <= RINGS; ring++) {
      for (let place = 0; place < (ring === 0 ? 1 : PLACES); place++) {
        const angle = (2 * Math.PI * place) / PLACES;
        const away = (REACH * ring) / RINGS;
        const [px, py] = [x + away * Math.cos(angle), y + away * Math.sin(angle)];
        const found = root.elementsFromPoint(px, py).find((element) => element.closest('[data-pick]'));
        if (found) return found.closest('[data-pick]');
      }
    }
    return null;
  }
}
