/** Units of length a person may write, as metres: a whole number over a whole number, so that 24 mm is 0.024 m exactly. */
const LENGTH_UNITS = {
  mm: [1, 1000],
  cm: [1, 100],
  m: [1, 1],
  in: [127, 5000],
  ft: [381, 1250],
} as const;

type MetricUnit = keyof typeof LENGTH_UNITS;
/** `px` are the paper's canvas pixels; `pixelsPerMetre` says how large they are. */
export type LengthUnit = MetricUnit | 'px';
export type AreaUnit = `${LengthUnit}${'2' | '²'}`;
/** A length with its unit: `2.4px`, `24 mm`. */
export type LengthText = `${number}${'' | ' '}${LengthUnit}`;
/** An area with its unit: `0.2px²`, `5cm2`. */
export type AreaText = `${number}${'' | ' '}${AreaUnit}`;

/** Units in words for an error: `px, mm, cm, m, in or ft`. */
export function unitWords(power: 1 | 2): string {
  const units = ['px', ...Object.keys(LENGTH_UNITS)].map((unit) => (power === 1 ? unit : `${unit}²`));
  return `${units.slice(0, -1).join(', ')} or ${units.at(-1)}`;
}

/**
 * Reads a length (power 1) or an area (power 2): a number, in metres or square metres, or a number with a unit.
 *
 * @param pixelsPerMetre null when it is not known yet
 * @returns m or m²; `pixels` for a quantity in pixels whose size is not known; NaN for what is neither
 */
export function readQuantity(text: string, power: 1 | 2, pixelsPerMetre: number | null): number | 'pixels' {
  const match = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*([a-z]*)([2²]?)\s*$/i.exec(text);
  if (match === null) return Number.NaN;
  const [, digits, name, square] = match;
  const value = Number(digits);
  if (name === '') return square === '' ? value : Number.NaN;
  if ((square === '') !== (power === 1)) return Number.NaN;
  const unit = name.toLowerCase();
  if (unit === 'px') return pixelsPerMetre === null ? 'pixels' : value / pixelsPerMetre ** power;
  if (!Object.hasOwn(LENGTH_UNITS, unit)) return Number.NaN;
  const [metres, over] = LENGTH_UNITS[unit as MetricUnit];
  return (value * metres ** power) / over ** power;
}
