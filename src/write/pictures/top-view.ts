import type { Bounds } from '../../core/geometry/rings.ts';
import { createRandom } from '../../core/random.ts';
import { CONTENT_WIDTH, MARGIN } from './page.ts';

/** The tallest drawing that still shows whole beside its caption on a laptop's screen, and the flattest, px. */
const TALLEST = 460;
const FLATTEST = 120;
/** Blank around the extent, px. */
const BLANK = 8;

/** More dots than this on a picture only make its file heavy. */
const MOST_DOTS = 20_000;
const SEED = 1;

/** Where plan metres lie on the page. */
export interface TopView {
  readonly pixelsPerMetre: number;
  /** Of the page above its caption, px. */
  readonly height: number;
  /** Vertices x, y, m, to px with y down. */
  map(xy: Float64Array): Float64Array;
}

/** A column of the page, px. */
export interface Field {
  readonly left: number;
  readonly width: number;
}

const WHOLE_PAGE: Field = { left: MARGIN, width: CONTENT_WIDTH };

/** The plan frame seen from above, as large as its field of the page allows. */
export function topView({ minX, minY, maxX, maxY }: Bounds, field: Field = WHOLE_PAGE): TopView {
  // A single point has no extent.
  const width = Math.max(maxX - minX, Number.EPSILON);
  const depth = Math.max(maxY - minY, Number.EPSILON);
  const pixelsPerMetre = Math.min((field.width - 2 * BLANK) / width, (TALLEST - 2 * BLANK) / depth);
  const height = Math.max(FLATTEST, depth * pixelsPerMetre + 2 * BLANK);
  const left = field.left + field.width / 2 - (pixelsPerMetre * (minX + maxX)) / 2;
  const foot = MARGIN + height / 2 + (pixelsPerMetre * (minY + maxY)) / 2;
  return {
    pixelsPerMetre,
    height: MARGIN + height,
    map(xy) {
      const mapped = new Float64Array(xy.length);
      for (let i = 0; i < xy.length; i += 2) {
        mapped[i] = left + pixelsPerMetre * xy[i];
        mapped[i + 1] = foot - pixelsPerMetre * xy[i + 1];
      }
      return mapped;
    },
  };
}

/** The share of so many points that a picture shows. */
export const shownShare = (points: number): number => Math.min(1, MOST_DOTS / points);

/**
 * Decides point by point which are shown. By chance, with a fixed seed: points come in the order of a lattice, where
 * every n-th one would draw stripes.
 */
export function sampler(share: number): () => boolean {
  const random = createRandom(SEED);
  return () => share >= 1 || random() < share;
}

/** About as many of the points as asked for; by default few enough for a picture. @param xy x, y a point */
export function thinned(xy: Float64Array, share = shownShare(xy.length / 2)): Float64Array {
  if (share >= 1) return xy;
  const isShown = sampler(share);
  const kept: number[] = [];
  for (let i = 0; i < xy.length; i += 2) if (isShown()) kept.push(xy[i], xy[i + 1]);
  return Float64Array.from(kept);
}
