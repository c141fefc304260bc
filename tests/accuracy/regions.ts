import { Clipper, FillRule, type Paths64 } from 'clipper2-ts';
import type { XY } from '../../fixtures/simulator/ring.ts';

/** Outer ring, then holes; open rings, metres, near the origin. */
export type Polygon = readonly (readonly XY[])[];
/** A polygon with holes, or several, in whole micrometres. */
export type Region = Paths64;

/** Integer coordinates of Clipper per metre: a rounding of 0.5 µm moves no measure by 1e-5. */
const SCALE = 1e6;

/** The area a polygon covers by the even-odd rule, free of self-crossings. */
export function regionOf(polygon: Polygon): Region {
  const paths = polygon.map((ring) =>
    ring.map(([x, y]) => ({ x: Math.round(x * SCALE), y: Math.round(y * SCALE) })),
  );
  return Clipper.union(paths, FillRule.EvenOdd);
}

export function unite(regions: readonly Region[]): Region {
  return Clipper.union(regions.flat(), FillRule.NonZero);
}

/** One region that hangs together loses its holes; several stay as they are. */
export function withoutHoles(region: Region): Region {
  const outers = region.filter((path) => Clipper.area(path) > 0);
  return outers.length === 1 ? outers : region;
}

/** m² */
export function areaOf(region: Region): number {
  return region.reduce((sum, path) => sum + Clipper.area(path), 0) / SCALE ** 2;
}

/** m² */
export function sharedArea(a: Region, b: Region): number {
  return areaOf(Clipper.intersect(a, b, FillRule.NonZero));
}

/** Shared area over united area. */
export function intersectionOverUnion(a: Region, b: Region): number {
  const shared = sharedArea(a, b);
  return shared / (areaOf(a) + areaOf(b) - shared);
}
