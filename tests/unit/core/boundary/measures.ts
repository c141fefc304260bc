/** How near an outline comes to the truth; by clipper2-ts, which no boundary method uses. */
import { areaPathsD, FillRule, intersectD } from 'clipper2-ts';
import { polygonArea, signedArea } from '../../../../src/core/geometry/rings.ts';
import type { Ring } from '../../../../src/core/types.ts';
import type { Path } from './wall-slices.ts';

export function ringOf(path: Path): Ring {
  return Float64Array.from(path.flat());
}

/** Area of the intersection over area of the union. */
export function intersectionOverUnion(a: Ring, b: Ring): number {
  const common = Math.abs(areaPathsD(intersectD([toPath(a)], [toPath(b)], FillRule.NonZero, 6)));
  const areaOf = (outer: Ring) => polygonArea({ outer, holes: [] });
  return common / (areaOf(a) + areaOf(b) - common);
}

/** Share by which the area of `found` differs from that of `truth`. */
export function areaError(found: Ring, truth: Ring): number {
  return Math.abs(signedArea(found) / signedArea(truth) - 1);
}

function toPath(ring: Ring): { x: number; y: number }[] {
  return Array.from({ length: ring.length / 2 }, (_, k) => ({ x: ring[2 * k], y: ring[2 * k + 1] }));
}
