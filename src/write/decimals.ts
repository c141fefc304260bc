/** A number with at most so many decimals, written as short as can be: never `-0`, never an exponent below 1e21. */
export function decimal(value: number, digits: number): string {
  const text = value.toFixed(digits);
  const point = text.indexOf('.');
  let end = text.length;
  if (point >= 0) {
    while (text[end - 1] === '0') end--;
    if (end === point + 1) end = point;
  }
  const short = text.slice(0, end);
  return short === '-0' ? '0' : short;
}

/** The greatest of 1, 2, 5 × 10ⁿ up to a value. */
export function greatestRound(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * ([5, 2].find((step) => step * power <= most) ?? 1);
}

/** The number {@link decimal} would write. */
export const rounded = (value: number, digits: number): number => Number(decimal(value, digits));
