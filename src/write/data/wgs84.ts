import { FloorPlanError } from '../../core/errors.ts';
import { sayCrs } from '../../core/source-coordinates.ts';
import type { Frame } from '../../core/types.ts';
import { NATIONAL_SYSTEMS } from './national-systems.ts';

/** From plan metres to degrees on WGS 84. */
export interface ToWgs84 {
  lonLat(x: number, y: number): readonly [lon: number, lat: number];
  /** How far places may be off by the change of datum, m; of systems fixed to a plate, the drift of plates since. */
  readonly accuracyM: number;
}

/** Of systems without a change of datum: ETRS89, NAD83 and their like have drifted off WGS 84 by so much, m. */
const DRIFT = 2;
const NO_DRIFT = 0;
/** Zones of UTM on datums of their own: codes in the EPSG data set run with the zones. */
const UTM_RANGES: readonly (readonly [first: number, last: number, zone: number, south?: 'south'])[] = [
  [25828, 25838, 28],
  [26901, 26923, 1],
  [6330, 6348, 1],
  [31965, 31976, 11],
  [31977, 31985, 17, 'south'],
  [28348, 28358, 48, 'south'],
  [7846, 7859, 46, 'south'],
];
/** Ellipsoids of WGS 84 and GRS 80: datums upon them are measured from the centre of the Earth. */
const EARTH = { axis: 6_378_137, inverseFlattening: 298.257 };
/** Units that differ by less are one: a foot of the US survey and an international one, of which files tell either. */
const SAME_UNIT = 1e-5;
/** There and back again a place may be off by this, m, where the projection holds: a change of datum forgets the height. */
const THERE_AND_BACK = 0.1;

interface System {
  readonly definition: string;
  readonly accuracyM: number;
}

/**
 * The way from a plan to WGS 84, where the scan told its coordinate system: an EPSG code of UTM, Web Mercator or a national
 * system, or well-known text.
 *
 * @throws result/cannot-write where the system is not told, not known, or its datum would be off by more than metres
 */
export async function toWgs84({ crs, planOrigin, metresPerUnit, unit }: Frame): Promise<ToWgs84> {
  if (crs === undefined) {
    const hint = 'Save the scan with its coordinate system, as LAS or E57.';
    throw cannot('expected a coordinate system, found none in the scan', hint);
  }
  if (unit === 'px') throw cannot('expected coordinates in a unit of length, found pixels', HINT);
  const { definition, accuracyM } = systemOf(crs);
  const { ways, perUnit } = await openSystem(definition, crs);
  const ratio = metresPerUnit / perUnit;
  const scale = Math.abs(ratio - 1) < SAME_UNIT ? 1 : ratio;
  const origin = [planOrigin[0] * scale, planOrigin[1] * scale] as const;
  const lonLat = (x: number, y: number): readonly [number, number] => {
    const [lon, lat] = ways.forward([origin[0] + x / perUnit, origin[1] + y / perUnit]);
    return [lon, lat];
  };
  assertHolds(ways, origin, perUnit, crs);
  return { lonLat, accuracyM };
}

/** Both ways between a system, in its own unit, and degrees on WGS 84. */
interface Ways {
  forward(place: number[]): number[];
  inverse(lonLat: number[]): number[];
}

async function openSystem(
  definition: string,
  crs: string,
): Promise<{ readonly ways: Ways; readonly perUnit: number }> {
  const { default: proj4 } = await import('proj4');
  try {
    const projection = new proj4.Proj(definition) as unknown as Projection;
    assertProjected(projection, crs, definition);
    return { ways: proj4(definition, 'WGS84') as Ways, perUnit: projection.to_meter ?? 1 };
  } catch (cause) {
    if (cause instanceof FloorPlanError) throw cause;
    throw cannot(`expected a coordinate system that proj4 knows, found ${sayCrs(crs)}`, HINT, cause);
  }
}

const HINT = 'Turn plan.geojson, which is in the coordinates of the scan, in a GIS.';

/** What of a projection proj4 tells beside its types. */
interface Projection {
  readonly projName?: string;
  readonly to_meter?: number;
  readonly a?: number;
  readonly rf?: number;
  readonly b?: number;
  readonly datum_params?: readonly number[] | string;
  readonly datumCode?: string;
}

function systemOf(crs: string): System {
  const code = Number(/^\s*EPSG:{1,2}(\d+)\s*$/i.exec(crs)?.[1] ?? Number.NaN);
  if (Number.isNaN(code)) return { definition: projectedPart(crs), accuracyM: DRIFT };
  const isWgs84 = (code > 32600 && code <= 32660) || (code > 32700 && code <= 32760) || code === 3857;
  if (isWgs84) return { definition: `EPSG:${code}`, accuracyM: NO_DRIFT };
  const range = UTM_RANGES.find(([first, last]) => code >= first && code <= last);
  if (range) {
    const [first, , zone, south] = range;
    const half = south ? ' +south' : '';
    return {
      definition: `+proj=utm +zone=${zone + code - first}${half} +ellps=GRS80 +units=m`,
      accuracyM: DRIFT,
    };
  }
  const national = Object.hasOwn(NATIONAL_SYSTEMS, code) ? NATIONAL_SYSTEMS[code] : null;
  if (!national)
    throw cannot(`expected a coordinate system of those that are known here, found EPSG:${code}`, HINT);
  const [, definition, accuracyM] = national;
  return { definition, accuracyM };
}

/** Of well-known text for plane and height together, what tells of the plane. */
function projectedPart(wkt: string): string {
  const begin = /(PROJCS|PROJCRS|PROJECTEDCRS)\s*\[/i.exec(wkt)?.index;
  if (begin === undefined) throw cannot(`expected a projected coordinate system, found ${sayCrs(wkt)}`, HINT);
  let depth = 0;
  for (let i = wkt.indexOf('[', begin); i < wkt.length; i++) {
    if (wkt[i] === '[') depth++;
    if (wkt[i] === ']' && --depth === 0) return wkt.slice(begin, i + 1);
  }
  throw cannot('expected well-known text, found brackets that do not close', HINT);
}

/** Refuses degrees, and datums that lie hundreds of metres off without a change that is told. */
function assertProjected(
  { projName, a, b, rf, datum_params }: Projection,
  crs: string,
  definition: string,
): void {
  if (projName === 'longlat' || projName === 'geocent') {
    throw cannot(`expected a projected coordinate system, found ${sayCrs(crs)}`, HINT);
  }
  if (datum_params || definition.includes('towgs84') || definition === 'EPSG:3857') return;
  const inverse = a && b && a !== b ? a / (a - b) : (rf ?? Infinity);
  const isGeocentric =
    Math.abs((a ?? 0) - EARTH.axis) < 1 && Math.abs(inverse - EARTH.inverseFlattening) < 0.001;
  if (isGeocentric) return;
  throw cannot(`expected the way from its datum to WGS 84, found none in ${sayCrs(crs)}`, HINT);
}

/** Where a projection does not hold, there and back again ends elsewhere. */
function assertHolds(ways: Ways, origin: readonly [number, number], perUnit: number, crs: string): void {
  const [lon, lat] = ways.forward([...origin]);
  const isOnEarth = Math.abs(lon) <= 180 && Math.abs(lat) <= 90;
  const [x, y] = isOnEarth ? ways.inverse([lon, lat]) : [Number.NaN, Number.NaN];
  if (Math.hypot(x - origin[0], y - origin[1]) * perUnit <= THERE_AND_BACK) return;
  const found = origin.map((value) => value.toFixed(0)).join(', ');
  throw cannot(`expected coordinates within ${sayCrs(crs)}, found ${found}`, HINT);
}

function cannot(words: string, hint: string, cause?: unknown): FloorPlanError {
  return new FloorPlanError('result/cannot-write', `plan.wgs84.geojson: ${words}`, {
    hint,
    detail: { format: 'geojson-wgs84' },
    cause,
  });
}
