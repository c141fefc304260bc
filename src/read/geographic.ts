import { trimmedBounds } from '../core/cloud-bounds.ts';
import { FloorPlanError } from '../core/errors.ts';
import type { Options } from '../core/params.ts';
import type { Scan } from '../core/types.ts';

type Bounds = Scan['bounds'];

/**
 * A scan so many times as high as it is long and wide is none: x and y are in degrees. A building 500 m long has 400 times
 * the height, in metres, of its length in degrees; a shaft has 50 times its width.
 */
const TIMES_AS_HIGH = 200;
/** No building is larger, degrees: 100 km. Metres of a room are more. */
export const MOST_DEGREES = 1;

/**
 * Refuses a table of longitudes and latitudes with heights, which says nothing of its coordinates.
 *
 * @throws input/geographic-coordinates
 */
export function assertPlane(
  scan: Scan,
  { unit, metresPerUnit }: Pick<Options, 'unit' | 'metresPerUnit'>,
): void {
  if (scan.isSlice || scan.unit !== undefined || unit !== 'auto' || metresPerUnit !== 'auto') return;
  const { min, max } = scan.bounds;
  const longest = Math.max(max[0] - min[0], max[1] - min[1]);
  if (longest === 0 || longest > MOST_DEGREES || scan.positions.length === 0) return;
  const inner = trimmedBounds(scan.positions);
  if (inner.max[2] - inner.min[2] < TIMES_AS_HIGH * longest) return;
  const [x, y] = [0, 1].map((axis) => Math.max(Math.abs(min[axis]), Math.abs(max[axis])));
  if (Math.min(x, y) > 90 || Math.max(x, y) > 180) return;
  throw noPlaneError({ name: scan.facts.name, bounds: scan.bounds, found: 'what looks like degrees' });
}

interface NoPlane {
  readonly name: string;
  readonly bounds: Bounds;
  /** What the coordinates are instead. */
  readonly found: string;
  readonly crs?: string | undefined;
  /** EPSG code of a system to go to. */
  readonly zone?: number | undefined;
}

/** Coordinates in which no plan lies. */
export function noPlaneError({ name, bounds: { min, max }, found, crs, zone }: NoPlane): FloorPlanError {
  const label = crs?.startsWith('EPSG') ? ` (${crs})` : '';
  const [x, y] = [0, 1].map((axis) => `from ${min[axis]} to ${max[axis]}`);
  return new FloorPlanError(
    'input/geographic-coordinates',
    `${name}: expected coordinates in metres or feet, found ${found}${label}: x ${x}, y ${y}`,
    {
      hint: `Reproject the cloud to a plane system such as its UTM zone${zone === undefined ? '' : ` (EPSG:${zone})`}, with PDAL, CloudCompare or las2las.`,
    },
  );
}

/** EPSG code of the UTM zone on WGS 84 that a place in degrees lies in. */
export function utmZone(longitude: number, latitude: number): number {
  const zone = (((Math.floor((longitude + 180) / 6) % 60) + 60) % 60) + 1;
  return (latitude < 0 ? 32_700 : 32_600) + zone;
}
