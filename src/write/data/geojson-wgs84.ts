import { sayCrs } from '../../core/source-coordinates.ts';
import { rounded } from '../decimals.ts';
import type { Product } from '../plan-writer.ts';
import { collection, type PlanFeature, planFeatures } from './geojson.ts';
import { toWgs84 } from './wgs84.ts';

/** Decimals of degrees: 0.01 mm, so that what plan.geojson has to 0.1 mm comes back. */
const DIGITS = 10;

/**
 * Writes plan.wgs84.geojson: what plan.geojson holds as longitude and latitude on WGS 84, as [RFC 7946] §4 asks, with the box
 * around it. Measures stay those of the plan; arcs, which are none in degrees, are left out.
 *
 * @throws result/cannot-write where the way to WGS 84 is not known
 */
export async function writeGeoJsonWgs84({ plan }: Pick<Product, 'plan'>): Promise<string> {
  const { lonLat, accuracyM } = await toWgs84(plan.frame);
  const features = planFeatures(plan, {
    place: (x, y) => {
      const [lon, lat] = lonLat(x, y);
      return [rounded(lon, DIGITS), rounded(lat, DIGITS)];
    },
    digits: DIGITS,
  });
  const bbox = boxOf(features);
  const from = { name: sayCrs(plan.frame.crs ?? ''), accuracyM };
  return collection({ ...(bbox && { bbox }), convertedFrom: from }, features);
}

/** West, south, east, north ([RFC 7946] §5); null where there is nothing. */
function boxOf(features: readonly PlanFeature[]): number[] | null {
  const flat = features.flatMap(({ geometry }) =>
    (geometry as { coordinates: number[][] | number[][][] }).coordinates.flat(2),
  );
  if (flat.length === 0) return null;
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  flat.forEach((value, i) => {
    const axis = i % 2;
    box[axis] = Math.min(box[axis], value);
    box[axis + 2] = Math.max(box[axis + 2], value);
  });
  return box;
}
