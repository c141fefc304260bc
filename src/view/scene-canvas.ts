import { FloorPlanError } from '../core/errors.ts';
import type { PainterAnswer } from './painter-worker.ts';
import PainterWorker from './painter-worker.ts?worker&inline';
import type { Painter, PaintOrder } from './scene-painter.ts';

/**
 * The canvas of a scene: drawn by a worker where the browser can, else by the page itself.
 *
 * A worker that a content policy forbids says nothing but fires an error event; a browser may give a worker no WebGL.
 * Both end with the page drawing, which is told all orders again.
 */
export class SceneCanvas {
  readonly #host: HTMLElement;
  readonly #onFailed: (error: FloorPlanError) => void;
  /** The last order of each kind. */
  readonly #orders = new Map<PaintOrder['kind'], PaintOrder>();
  #worker: Worker | null = null;
  #painter: Painter | null = null;
  #isOver = false;

  /** @param onFailed called with environment/webgl where nothing can be drawn */
  constructor(host: HTMLElement, onFailed: (error: FloorPlanError) => void) {
    this.#host = host;
    this.#onFailed = onFailed;
    try {
      this.#worker = this.#openWorker();
    } catch {
      void this.#drawHere();
    }
  }

  send(order: PaintOrder): void {
    this.#orders.set(order.kind, order);
    this.#worker?.postMessage(order);
    this.#painter?.take(order);
  }

  /** A worker takes its graphics context with it. */
  dispose(): void {
    this.#isOver = true;
    this.#worker?.terminate();
    this.#painter?.dispose();
  }

  /** @throws where the browser has no OffscreenCanvas or no worker */
  #openWorker(): Worker {
    const canvas = this.#addCanvas().transferControlToOffscreen();
    const worker = new PainterWorker();
    const fail = () => {
      worker.terminate();
      if (this.#worker !== worker) return;
      this.#worker = null;
      void this.#drawHere();
    };
    worker.onmessage = ({ data }: MessageEvent<PainterAnswer>) => data === 'failed' && fail();
    worker.onerror = (event) => {
      event.preventDefault();
      fail();
    };
    worker.postMessage({ canvas }, [canvas]);
    return worker;
  }

  async #drawHere(): Promise<void> {
    try {
      const { Painter } = await import('./scene-painter.ts');
      if (this.#isOver) return;
      this.#painter = new Painter(this.#addCanvas());
      for (const order of this.#orders.values()) this.#painter.take(order);
    } catch (cause) {
      this.#onFailed(
        new FloorPlanError(
          'environment/webgl',
          'Expected WebGL 2 for the model, but this browser offers none.',
          {
            hint: 'The plan and every export work without it. Turn on hardware acceleration to see the model.',
            cause,
          },
        ),
      );
    }
  }

  #addCanvas(): HTMLCanvasElement {
    const canvas = document.createElement('canvas');
    canvas.setAttribute('aria-hidden', 'true');
    this.#host.replaceChildren(canvas);
    return canvas;
  }
}
