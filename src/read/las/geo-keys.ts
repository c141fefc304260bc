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

/** Metres a unit, by EPSG code. */
const UNIT_METRES: Readonly<Record<number, number>> = {
  9001: 1,
  9002: 0.3048,
  9003: 1200 / 3937,
  1025: 0.001,
  1033: 0.01,
};

/** Codes of UTM zones, on WGS 84 and on ETRS89: metres, though no key says so. */
const UTM_CODES = [
  [32_601, 32_660],
  [32_701, 32_760],
  [25_828, 25_838],
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
  const metresPerUnit = UNIT_METRES[keys.get(LINEAR_UNITS) ?? 0] ?? utmMetres(keys.get(PROJECTED_TYPE));
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

function utmMetres(code = 0): number | undefined {
  return UTM_CODES.some(([first, last]) => code >= first && code <= last) ? 1 : undefined;
}
