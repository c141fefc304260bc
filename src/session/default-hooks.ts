import { canvasStrokeTest } from '../core/canvas-stroke.ts';
import { FloorPlanError } from '../core/errors.ts';
import type { PipelineHooks } from '../core/pipeline-run.ts';
import { nextTurn } from '../read/next-turn.ts';
import type { RasterCanvas, RasterContext, WriteTools } from '../write/drawing/raster.ts';

/** The environment's own clock, event loop and canvas, in browser and worker; Node has no canvas of its own. */
export const DEFAULT_HOOKS: PipelineHooks & WriteTools = {
  makeCanvas,
  now: () => performance.now(),
  breathe: nextTurn,
  strokeTest: canvasStrokeTest(() => {
    const canvas = typeof OffscreenCanvas === 'undefined' ? null : new OffscreenCanvas(1, 1);
    const context = canvas?.getContext('2d');
    if (context) return context;
    throw new FloorPlanError(
      'environment/canvas',
      'expected an OffscreenCanvas with a 2D context, found none',
      { hint: 'Use a current browser, take the robust secondary method, or hand the session a stroke test.' },
    );
  }),
};

function makeCanvas(width: number, height: number): RasterCanvas | null {
  if (typeof OffscreenCanvas === 'undefined') return null;
  const canvas = new OffscreenCanvas(width, height);
  const context: RasterContext | null = canvas.getContext('2d');
  if (context === null) return null;
  return {
    context,
    toPng: async () =>
      new Uint8Array(await (await canvas.convertToBlob({ type: 'image/png' })).arrayBuffer()),
  };
}
