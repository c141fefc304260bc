import { Painter, type PaintOrder } from './scene-painter.ts';

/** First the canvas, then orders. Answers once: whether there is WebGL. */
export type PainterRequest = { readonly canvas: OffscreenCanvas } | PaintOrder;
export type PainterAnswer = 'ready' | 'failed';

let painter: Painter | null = null;

addEventListener('message', ({ data }: MessageEvent<PainterRequest>) => {
  if ('canvas' in data) postMessage(open(data.canvas));
  else painter?.take(data);
});

function open(canvas: OffscreenCanvas): PainterAnswer {
  try {
    painter = new Painter(canvas);
    return 'ready';
  } catch {
    return 'failed';
  }
}
