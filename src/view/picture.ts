import { PanZoom } from './pan-zoom.ts';
import { parsePicture } from './parse-drawing.ts';
import { listenForPress } from './press.ts';

/** Room left around a fitted picture, px. */
const MARGIN = 12;
/** Width of the margin around what can be picked, of the picture's 640 px. */
const REACH = 24;

/** An SVG picture with pan and zoom. */
export class PictureView {
  readonly #host: HTMLElement;
  readonly #paper = document.createElement('div');
  readonly #panZoom: PanZoom;
  readonly #resize: ResizeObserver;
  readonly #listening = new AbortController();
  #svg: SVGSVGElement | null = null;
  #size: readonly [width: number, height: number] = [1, 1];

  /**
   * @param host an empty element; it gets the keyboard focus and the gestures
   * @param onPick what was pressed of the picture, marked `data-pick`
   */
  constructor(host: HTMLElement, onPick: (element: Element) => void) {
    this.#host = host;
    host.tabIndex = 0;
    host.setAttribute('role', 'group');
    this.#paper.className = 'paper';
    host.append(this.#paper);
    this.#panZoom = new PanZoom(host, { onMove: () => this.#place(), onFit: () => this.fit() });
    this.#resize = new ResizeObserver(() => this.#panZoom.isFitted && this.fit());
    this.#resize.observe(host);
    const press = ({ clientX, clientY }: MouseEvent) => {
      const found = this.#pickAt(clientX, clientY);
      if (found) onPick(found);
    };
    listenForPress(host, press, this.#listening.signal);
  }

  /** Shows a picture; place and zoom stay where it is of the same size, unless it `isNew`. @throws input/malformed */
  show(text: string, isNew: boolean): void {
    const { svg, width, height } = parsePicture(text);
    const isSame = width === this.#size[0] && height === this.#size[1];
    widenPicks(svg);
    svg.classList.add('drawing');
    svg.setAttribute('role', 'img');
    svg.style.width = `${width}px`;
    svg.style.height = `${height}px`;
    this.#svg = svg;
    this.#size = [width, height];
    this.#paper.replaceChildren(svg);
    if (isSame && !isNew && !this.#panZoom.isFitted) this.#place();
    else this.fit();
  }

  fit(): void {
    this.#panZoom.fit(...this.#size, { margin: MARGIN, foot: MARGIN });
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

  #place(): void {
    const { zoom, x, y } = this.#panZoom.placement;
    if (this.#svg) this.#svg.style.transform = `matrix(${zoom}, 0, 0, ${zoom}, ${x}, ${y})`;
  }

  /** What can be picked at a place of the screen: what is drawn there before what is only near. */
  #pickAt(x: number, y: number): Element | null {
    const root = this.#host.getRootNode() as ShadowRoot;
    const under = root.elementsFromPoint(x, y).map((element) => element.closest('[data-pick]'));
    return under.find((element) => element !== null) ?? null;
  }
}

/** Points are smaller than fingers: all that can be picked gets an unseen margin, beneath everything. */
function widenPicks(svg: SVGSVGElement): void {
  for (const pick of svg.querySelectorAll('[data-pick]')) {
    const margin = pick.cloneNode() as Element;
    margin.removeAttribute('id');
    margin.setAttribute('stroke-width', String(REACH));
    margin.setAttribute('stroke-opacity', '0');
    svg.prepend(margin);
  }
}
