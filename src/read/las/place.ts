import type { Unit, Warning } from '../../core/types.ts';
import { MOST_DEGREES, noPlaneError, utmZone } from '../geographic.ts';
import { geoKeySystem } from './geo-keys.ts';
import type { LasHeader } from './las-header.ts';
import { isCrs, type VariableRecord } from './variable-records.ts';
import { wktSystem } from './wkt-system.ts';

/** What the coordinates of a LAS file mean. */
export interface Place {
  readonly unit?: Unit;
  readonly crs?: string;
  /** Heights times this are in the unit of x and y. */
  readonly heightRatio: number;
  readonly warnings: readonly Warning[];
}

const UNITS: readonly (readonly [unit: Unit, metres: number])[] = [
  ['m', 1],
  ['cm', 0.01],
  ['mm', 0.001],
  ['ft', 0.3048],
  ['us-ft', 1200 / 3937],
];
/** Factors are written with nine digits and more; the two feet differ by 2 ppm. */
const SAME_UNIT = 1e-7;

/**
 * Reads unit and CRS from the records, WKT or GeoTIFF keys as the header says, else whichever there is.
 *
 * @throws input/geographic-coordinates where x and y are degrees or the axes are Earth-centred: no plan lies in them
 */
export function placeOf(name: string, header: LasHeader, records: readonly VariableRecord[]): Place {
  const own = records.filter(isCrs);
  const system = header.hasWkt
    ? (wktSystem(own) ?? geoKeySystem(own))
    : (geoKeySystem(own) ?? wktSystem(own));
  if (!system) return { heightRatio: 1, warnings: [] };
  const { kind } = system;
  if (kind === 'geographic' || kind === 'geocentric') return strangePlace(name, header, kind, system.crs);
  const { crs, metresPerUnit, metresPerHeightUnit } = system;
  const unit = UNITS.find(([, metres]) => isSame(metres, metresPerUnit))?.[0];
  const isMixed = metresPerUnit && metresPerHeightUnit && !isSame(metresPerUnit, metresPerHeightUnit);
  return {
    ...(unit && { unit }),
    ...(crs && { crs }),
    heightRatio: isMixed ? metresPerHeightUnit / metresPerUnit : 1,
    warnings: [
      ...(metresPerUnit && !unit ? [unknownUnit(metresPerUnit)] : []),
      ...(isMixed ? [mixedUnits(metresPerUnit, metresPerHeightUnit)] : []),
    ],
  };
}

function isSame(metres: number, found = 0): boolean {
  return Math.abs(found / metres - 1) < SAME_UNIT;
}

/** Some files bear the label and hold plain coordinates: then the label is wrong. */
function strangePlace(
  name: string,
  { bounds }: LasHeader,
  kind: 'geographic' | 'geocentric',
  crs: string | undefined,
): Place {
  const { min, max } = bounds;
  const isNear = (low: number, high: number) => high - low <= MOST_DEGREES;
  const areDegrees =
    isNear(min[0], max[0]) && isNear(min[1], max[1]) && Math.abs(max[0]) <= 360 && Math.abs(max[1]) <= 90;
  const areFromCentre = Math.hypot(...max.map((value, i) => (value + min[i]) / 2)) > NEAR_CENTRE;
  if (kind === 'geographic' ? areDegrees : areFromCentre) {
    const zone = kind === 'geographic' ? utmZone((min[0] + max[0]) / 2, (min[1] + max[1]) / 2) : undefined;
    throw noPlaneError({ name, bounds, found: KIND_WORDS[kind], crs, zone });
  }
  const message = `The file says that its coordinates are ${KIND_WORDS[kind]}; they lie elsewhere, and the label was passed over.`;
  const hint = 'Save the file with its right coordinate system, if the plan is to carry it.';
  return { heightRatio: 1, warnings: [{ code: 'read/crs-ignored', message, hint }] };
}

const KIND_WORDS = { geographic: 'degrees', geocentric: 'measured from the centre of the Earth' } as const;
/** Farther from Earth's centre than this lies its surface, m. */
const NEAR_CENTRE = 6e6;
function unknownUnit(metres: number): Warning {
  return {
    code: 'read/unit-not-known',
    message: `The file states a unit of ${metres} m, which is none of ${UNITS.map(([unit]) => unit).join(', ')}; the unit is judged from the cloud.`,
    hint: 'If sizes look wrong, set the unit.',
  };
}

function mixedUnits(plane: number, height: number): Warning {
  return {
    code: 'read/heights-converted',
    message: `The file states another unit for heights (${height} m) than for x and y (${plane} m); heights were converted to the latter.`,
    hint: 'If heights look wrong, correct the CRS in the file.',
  };
}
