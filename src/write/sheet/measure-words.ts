import type { Options } from '../../core/params.ts';

/** How lengths and areas are written; everything inside stays in metres. */
export type DisplayUnit = Options['displayUnits'];

/** International foot and inch, exact by definition. */
export const METRES_PER_FOOT = 0.3048;
export const INCHES_PER_FOOT = 12;
/** Drawings in feet are read to an eighth of an inch, 3 mm. */
const EIGHTHS = 8;

/** An area: `14.2 m²`, `153 ft²`. */
export function formatArea(squareMetres: number, unit: DisplayUnit): string {
  if (unit === 'm') return `${squareMetres.toFixed(squareMetres < 1 ? 2 : 1)} m²`;
  const squareFeet = squareMetres / METRES_PER_FOOT ** 2;
  return `${squareFeet.toFixed(squareFeet < 10 ? 1 : 0)} ft²`;
}

/** A length as it stands at a dimension line: metres to the centimetre, `4.20`, or feet and inches, `13'-9 3/8"`. */
export function formatDimension(metres: number, unit: DisplayUnit): string {
  if (unit === 'm') return metres.toFixed(2);
  const eighths = Math.round((metres / METRES_PER_FOOT) * INCHES_PER_FOOT * EIGHTHS);
  const inches = Math.floor(eighths / EIGHTHS);
  const [feet, rest] = [Math.floor(inches / INCHES_PER_FOOT), inches % INCHES_PER_FOOT];
  const fraction = fractionOf(eighths % EIGHTHS);
  const inWords =
    fraction === '' ? `${rest}"` : rest === 0 && feet === 0 ? `${fraction}"` : `${rest} ${fraction}"`;
  return feet === 0 ? inWords : `${feet}'-${inWords}`;
}

/** `3/8`, `1/2`; nothing for a whole inch. */
function fractionOf(eighths: number): string {
  if (eighths === 0) return '';
  let [share, whole] = [eighths, EIGHTHS];
  for (; share % 2 === 0; share /= 2) whole /= 2;
  return `${share}/${whole}`;
}
