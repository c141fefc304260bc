import { areaOf, combine } from '../../core/geometry/areas.ts';
import { perimeter, ringsOf, vertexCount } from '../../core/geometry/rings.ts';
import { squaredDistanceToSegment } from '../../core/geometry/segments.ts';
import type { Polygon } from '../../core/types.ts';

/** How two areas differ. */
export interface PolygonComparison {
  /** m² */
  readonly areaM2: readonly [a: number, b: number];
  readonly vertices: readonly [a: number, b: number];
  /** Area of what both cover by area of what either covers, 0 to 1; 1 where both are empty. */
  readonly iou: number;
  /** 95 % of either outline lie within this of the other one, m; infinite where only one is empty. */
  readonly distance95: number;
}

/** Places looked at along each outline. */
const SAMPLES = 2000;
const SHARE = 0.95;

/**
 * Measures two areas against each other: overlap by exact Booleans, distance by places spaced evenly along both
 * outlines, holes included. O(samples × vertices).
 */
export function comparePolygons(a: readonly Polygon[], b: readonly Polygon[]): PolygonComparison {
  const either = areaOf(combine('union', [...a, ...b]));
  const both = a.length === 0 || b.length === 0 ? 0 : areaOf(combine('intersection', a, b));
  return {
    areaM2: [areaOf(combine('union', a)), areaOf(combine('union', b))],
    vertices: [vertexCount(a), vertexCount(b)],
    iou: either === 0 ? 1 : both / either,
    distance95: distanceShare(a, b),
  };
}

function distanceShare(a: readonly Polygon[], b: readonly Polygon[]): number {
  if (a.length === 0 && b.length === 0) return 0;
  if (a.length === 0 || b.length === 0) return Infinity;
  const [ringsA, ringsB] = [ringsOf(a), ringsOf(b)];
  const distances = Float64Array.from([
    ...placesAlong(ringsA).map(([x, y]) => squaredDistance(x, y, ringsB)),
    ...placesAlong(ringsB).map(([x, y]) => squaredDistance(x, y, ringsA)),
  ]).sort();
  return Math.sqrt(distances[Math.ceil(SHARE * distances.length) - 1]);
}

function placesAlong(rings: readonly Float64Array[]): (readonly [x: number, y: number])[] {
  const total = rings.reduce((sum, ring) => sum + perimeter(ring), 0);
  const step = total / SAMPLES;
  const places: (readonly [number, number])[] = [];
  for (const ring of rings) {
    let next = 0;
    for (let i = 0; i < ring.length; i += 2) {
      const j = (i + 2) % ring.length;
      const [dx, dy] = [ring[j] - ring[i], ring[j + 1] - ring[i + 1]];
      const length = Math.hypot(dx, dy);
      for (; next < length; next += step) {
        places.push([ring[i] + (next / length) * dx, ring[i + 1] + (next / length) * dy]);
      }
      next -= length;
    }
  }
  return places;
}

function squaredDistance(x: number, y: number, rings: readonly Float64Array[]): number {
  let least = Infinity;
  for (const ring of rings) {
    for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      least = Math.min(least, squaredDistanceToSegment(x, y, ring[j], ring[j + 1], ring[i], ring[i + 1]));
    }
  }
  return least;
}
