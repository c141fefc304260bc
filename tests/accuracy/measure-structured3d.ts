import { boundsOf, type XY } from '../../fixtures/simulator/ring.ts';
import type { StoreyFacts } from './facts.ts';
import type { Measures } from './measures.ts';
import { broadOutline, MAP_SIZE, type Pixel } from './pixel-map.ts';
import { structured3dScores } from './structured3d.ts';

/** Air around the building on the density map, of its extent, on every side. */
const MARGIN = 0.1;

/** The Structured3D protocol on rooms in metres: both axes fill the map, as its density maps do. */
export function measureStructured3d(plan: StoreyFacts, truth: StoreyFacts): Measures {
  const [outer] = truth.outer[0];
  const [minX, minY, maxX, maxY] = boundsOf(outer);
  const place = (value: number, low: number, high: number): number => {
    const share = (value - low + MARGIN * (high - low)) / ((1 + 2 * MARGIN) * (high - low));
    return Math.max(0, Math.min(MAP_SIZE - 1, Math.round(share * MAP_SIZE)));
  };
  const toPixels = (ring: readonly XY[]): Pixel[] =>
    ring.map(([x, y]): Pixel => [place(x, minX, maxX), place(y, minY, maxY)]);
  const outlines = (rooms: StoreyFacts['rooms']): Pixel[][] => rooms.map(([ring]) => toPixels(ring));
  const scores = structured3dScores(
    outlines(truth.rooms),
    outlines(plan.rooms),
    broadOutline(toPixels(outer)),
  );
  return {
    s3dRoomPrecision: scores.roomPrecision,
    s3dRoomRecall: scores.roomRecall,
    s3dCornerPrecision: scores.cornerPrecision,
    s3dCornerRecall: scores.cornerRecall,
    s3dAnglePrecision: scores.anglePrecision,
    s3dAngleRecall: scores.angleRecall,
  };
}
