import { readQuantity } from '../core/quantity.ts';
import { type DisplayUnit, INCHES_PER_FOOT, METRES_PER_FOOT } from '../write/sheet/measure-words.ts';

/** A scan is worth centimetres; only a scale bar under the eye is finer than this. m */
const FINE = 0.1;

/** A length in metres as people write it: `3.42 m`, `11′ 3″`. */
export function formatLength(metres: number, unit: DisplayUnit): string {
  if (unit === 'm') return `${trim(metres, metres < FINE ? 3 : 2)} m`;
  const inches = (metres / METRES_PER_FOOT) * INCHES_PER_FOOT;
  if (inches < INCHES_PER_FOOT) return `${trim(inches, 2)}″`;
  const whole = Math.round(inches);
  const rest = whole % INCHES_PER_FOOT;
  return `${Math.floor(whole / INCHES_PER_FOOT)}′${rest === 0 ? '' : ` ${rest}″`}`;
}

/** A band of heights, all with the same decimals so that they compare: `0.65 to 2.00 m`, `2′ 2″ to 6′ 7″`. */
export function formatBand(low: number, high: number, unit: DisplayUnit): string {
  if (unit === 'm') return `${low.toFixed(2)} to ${high.toFixed(2)} m`;
  const read = (metres: number) => {
    const inches = Math.round((metres / METRES_PER_FOOT) * INCHES_PER_FOOT);
    return `${Math.floor(inches / INCHES_PER_FOOT)}′ ${inches % INCHES_PER_FOOT}″`;
  };
  return `${read(low)} to ${read(high)}`;
}

/** `317 per m²`, `29 per ft²`. */
export function formatDensity(perSquareMetre: number, unit: DisplayUnit): string {
  return unit === 'm'
    ? `${formatCount(perSquareMetre)} per m²`
    : `${formatCount(perSquareMetre * METRES_PER_FOOT ** 2)} per ft²`;
}

/** What a person typed, in metres to the millimetre. */
export function toMetres(value: number, unit: DisplayUnit): number {
  return unit === 'm' ? value : Number((value * METRES_PER_FOOT).toFixed(3));
}

/** A length that a person typed, with a unit or in the one they read; NaN for anything else. m */
export function readLength(text: string, unit: DisplayUnit): number {
  const metres = readQuantity(/[a-z]/i.test(text) ? text : `${text}${unit}`, 1, null);
  return metres === 'pixels' ? Number.NaN : metres;
}

/** A length as a bare number to edit. */
export function fromMetres(metres: number, unit: DisplayUnit): number {
  return unit === 'm' ? metres : Number((metres / METRES_PER_FOOT).toFixed(2));
}

/** `12,345`. */
export function formatCount(count: number): string {
  return Math.round(count).toLocaleString('en-GB');
}

/** `3 ms`, `1.2 s`, `2 min`. */
export function formatDuration(ms: number): string {
  if (ms < 1) return '< 1 ms';
  if (ms < 1000) return `${Math.round(ms)} ms`;
  return ms < 60_000 ? `${(ms / 1000).toFixed(1)} s` : `${Math.round(ms / 60_000)} min`;
}

/** Lengths a scale bar may show, metres, rising; each reads as a round number in its unit. */
export function roundLengths(unit: DisplayUnit): readonly number[] {
  const decades = [1e-3, 1e-2, 1e-1, 1, 10, 100, 1000];
  if (unit === 'm') return decades.flatMap((decade) => [decade, 2 * decade, 5 * decade]);
  const inches = [0.25, 0.5, 1, 2, 3, 6].map((inch) => (inch * METRES_PER_FOOT) / INCHES_PER_FOOT);
  const feet = [1, 10, 100, 1000].flatMap((decade) => [decade, 2 * decade, 5 * decade]);
  return [...inches, ...feet.map((foot) => foot * METRES_PER_FOOT)];
}

function trim(value: number, decimals: number): string {
  return String(Number(value.toFixed(decimals)));
}
