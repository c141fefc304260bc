import { PARAMS } from '../../core/params.ts';

/** Digits a scale is written with: finer than any length is measured. */
const DIGITS = 7;

/**
 * The parameter `metresPerUnit` by which a length of the plan has its true size; null where there is none it allows.
 *
 * @param measured in the plan as it is, m
 * @param known m
 * @param metresPerUnit of the plan as it is
 */
export function scaleFor(measured: number, known: number, metresPerUnit: number): number | null {
  const scale = Number(((known / measured) * metresPerUnit).toPrecision(DIGITS));
  const { min, max } = PARAMS.metresPerUnit;
  return scale >= min && scale <= max ? scale : null;
}
