import { cutText } from '../../core/cut-text.ts';
import { type SourceCoordinates, sayCrs, sayUnit, sourceCoordinates } from '../../core/source-coordinates.ts';
import type { Frame } from '../../core/types.ts';
import { printable } from '../printable.ts';

/** Longest name of a scan in a comment: characters. */
const LONGEST = 120;

/** A scan's name, or other foreign text, as one line of a comment. */
export function oneLine(text: string): string {
  return cutText(printable(text), LONGEST);
}

/**
 * {@link oneLine} in ASCII, as headers are that end at a word: other characters as `\u{1f600}`, and the word parted.
 */
export function asciiLine(text: string): string {
  const ascii = oneLine(text).replace(
    /[^ -~]/gu,
    (character) => `\\u{${character.codePointAt(0)!.toString(16)}}`,
  );
  return ascii.replaceAll('end_header', 'end header');
}

/** Source coordinates in space, for files that hold the model where the scan was. */
export interface SourceSpace extends SourceCoordinates {
  z(planZ: number): number;
}

/** Seen from above, z up: of a y-up source x, −z, y. */
export function sourceSpace(frame: Frame): SourceSpace {
  const { planOrigin, metresPerUnit } = frame;
  const z = (planZ: number) => planOrigin[2] + planZ / metresPerUnit;
  return { ...sourceCoordinates(frame), z };
}

/** What a model in source coordinates says of them in comments. */
export function sourceNotes(name: string, { unit, metresPerUnit, crs, planOrigin }: Frame): string[] {
  return [
    `Grundriss floor plan: ${oneLine(name)}`,
    `unit: ${sayUnit(unit)} (1 = ${metresPerUnit} m), z up, true source coordinates`,
    ...(crs === undefined ? [] : [`crs: ${oneLine(sayCrs(crs))}`]),
    `plan origin: ${planOrigin.join(' ')}`,
  ];
}
