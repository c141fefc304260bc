import { createRequire } from 'node:module';
import { canvasStrokeTest } from '../core/canvas-stroke.ts';
import type { StrokeTest } from '../core/context.ts';
import { FloorPlanError } from '../core/errors.ts';

/**
 * The canvas question under Node, asked of @napi-rs/canvas, which agrees with Chromium point for point.
 *
 * The package is optional and loaded by the first question: all but the paper's secondary boundaries do
 * without it. The test throws environment/canvas when it is missing.
 */
export function createStrokeTest(): StrokeTest {
  return canvasStrokeTest(() => {
    try {
      const { createCanvas } = createRequire(import.meta.url)(
        '@napi-rs/canvas',
      ) as typeof import('@napi-rs/canvas');
      return createCanvas(1, 1).getContext('2d');
    } catch (cause) {
      throw new FloorPlanError(
        'environment/canvas',
        'expected the package @napi-rs/canvas, found none that loads',
        { hint: 'Install it (npm install @napi-rs/canvas), or take --secondary-method robust.', cause },
      );
    }
  });
}
