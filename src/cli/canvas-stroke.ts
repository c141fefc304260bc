import { canvasStrokeTest } from '../core/canvas-stroke.ts';
import type { StrokeTest } from '../core/context.ts';
import { FloorPlanError } from '../core/errors.ts';
import { loadCanvas } from './node-canvas.ts';

/**
 * The canvas question under Node, asked of @napi-rs/canvas, which agrees with Chromium point for point.
 *
 * The package is optional and loaded by the first question: all but the paper's secondary boundaries do
 * without it. The test throws environment/canvas when it is missing.
 */
export function createStrokeTest(): StrokeTest {
  return canvasStrokeTest(() => {
    const canvas = loadCanvas()?.createCanvas(1, 1);
    if (canvas) return canvas.getContext('2d');
    throw new FloorPlanError(
      'environment/canvas',
      'expected the package @napi-rs/canvas, found none that loads',
      { hint: 'Install it (npm install @napi-rs/canvas), or take --secondary-method robust.' },
    );
  });
}
