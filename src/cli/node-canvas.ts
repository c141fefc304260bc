import { createRequire } from 'node:module';
import type { RasterCanvas } from '../write/drawing/raster.ts';

/** @napi-rs/canvas, which is optional; null where it does not load. */
export function loadCanvas(): typeof import('@napi-rs/canvas') | null {
  try {
    return createRequire(import.meta.url)('@napi-rs/canvas') as typeof import('@napi-rs/canvas');
  } catch {
    return null;
  }
}

/** A canvas to paint drawings on under Node, where the package is and the system has a font. */
export function makeNodeCanvas(width: number, height: number): RasterCanvas | null {
  const package_ = loadCanvas();
  if (package_ === null || package_.GlobalFonts.families.length === 0) return null;
  const canvas = package_.createCanvas(width, height);
  return { context: canvas.getContext('2d'), toPng: async () => canvas.encode('png') };
}
