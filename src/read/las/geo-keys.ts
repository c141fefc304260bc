import { viewOf } from '../bytes/view-of.ts';
import { type CoordinateSystem, epsgOf } from './coordinate-system.ts';
import type { VariableRecord } from './variable-records.ts';

const DIRECTORY = 34_735;
/** Keys of the GeoTIFF standard (OGC 19-008r4, §7). */
const MODEL_TYPE = 1024;
const GEOGRAPHIC_TYPE = 2048;
const PROJECTED_TYPE = 3072;
const LINEAR_UNITS = 3076;
const VERTICAL_UNITS = 4099;
const MODEL_KINDS = ['unknown', 'projected', 'geographic', 'geocentric'] as const;

const FOOT = 0.3048;
const US_SURVEY_FOOT = 1200 / 3937;

/** Metres a unit, by EPSG code. */
const UNIT_METRES: Readonly<Record<number, number>> = {
  9001: 1,
  9002: FOOT,
  9003: US_SURVEY_FOOT,
  1025: 0.001,
  1033: 0.01,
};

/** Codes of UTM zones, on WGS 84, ETRS89 and NAD83: metres, though no key says so. */
const UTM_CODES = [
  [32_601, 32_660],
  [32_701, 32_760],
  [25_828, 25_838],
  [26_901, 26_923],
] as const;
/** Codes of the state plane on NAD83 in feet: those of the survey, but for a few states. */
const STATE_PLANE_CODES = [[2222, 2289]] as const;
const INTERNATIONAL_FEET_CODES = [
  [2222, 2224],
  [2251, 2253],
  [2256, 2256],
  [2265, 2266],
  [2269, 2270],
  [2273, 2273],
  [2280, 2282],
] as const;

/** The coordinate system a GeoTIFF key directory tells; null where there is none. */
export function geoKeySystem(records: readonly VariableRecord[]): CoordinateSystem | null {
  const directory = records.find(({ id }) => id === DIRECTORY);
  if (!directory) return null;
  const keys = shortKeys(directory.bytes);
  const projected = epsgOf(keys.get(PROJECTED_TYPE));
  const geographic = epsgOf(keys.get(GEOGRAPHIC_TYPE));
  const kind = MODEL_KINDS[keys.get(MODEL_TYPE) ?? 0] ?? 'unknown';
  const crs = projected ?? (kind === 'projected' ? undefined : geographic);
  const metresPerUnit = UNIT_METRES[keys.get(LINEAR_UNITS) ?? 0] ?? systemMetres(keys.get(PROJECTED_TYPE));
  const metresPerHeightUnit = UNIT_METRES[keys.get(VERTICAL_UNITS) ?? 0];
  return {
    kind,
    ...(crs && { crs }),
    ...(metresPerUnit && { metresPerUnit }),
    ...(metresPerHeightUnit && { metresPerHeightUnit }),
  };
}

/** Keys whose value stands in the directory itself. */
function shortKeys(bytes: Uint8Array): Map<number, number> {
  const view = viewOf(bytes);
  const keys = new Map<number, number>();
  // Four numbers a key, after four of the directory's own.
  for (let at = 8; at + 8 <= bytes.length; at += 8) {
    const isHere = view.getUint16(at + 2, true) === 0;
    if (isHere) keys.set(view.getUint16(at, true), view.getUint16(at + 6, true));
  }
  return keys;
}

/** Of systems whose code alone tells. */
function systemMetres(code = 0): number | undefined {
  if (isAmong(UTM_CODES, code)) return 1;
  if (isAmong(INTERNATIONAL_FEET_CODES, code)) return FOOT;
  return isAmong(STATE_PLANE_CODES, code) ? US_SURVEY_FOOT : undefined;
}

function isAmong(codes: readonly (readonly [first: number, last: number])[], code: number): boolean {
  return codes.some(([first, last]) => code >= first && code <= last);
}
