import { countOf } from '../core/count-words.ts';
import { FloorPlanError } from '../core/errors.ts';
import type { Warning } from '../core/types.ts';

/** Of a cloud that is cut off, fewer whole points than these are a corner of a room … */
const LEAST_POINTS = 5000;
/** … and a smaller share of those announced is the work of a header that lies, or no scan to make a plan of. */
const LEAST_SHARE = 0.5;

type Detail = Readonly<Record<string, string | number>>;

/** A file that ends too soon. @param expected,found in words */
export function cutOff(name: string, expected: string, found: string, detail: Detail): FloorPlanError {
  return new FloorPlanError('input/truncated', `${name}: expected ${expected}, found ${found}`, {
    hint: 'The file seems cut off; copy or export it again.',
    detail,
  });
}

/** @param expected what the file should hold still, in words @param offset byte at which it ends */
export function cutOffAt(
  name: string,
  expected: string,
  offset: number,
  detail: Detail = {},
): FloorPlanError {
  return cutOff(name, expected, `the end of the file at byte ${offset}`, { offset, ...detail });
}

/** What a header promises. */
export interface Announced {
  readonly count: number;
  /** Of what; points unless told. */
  readonly what?: string;
  /** Bytes that so many take at least, where known. */
  readonly needed?: number | undefined;
}

/** A binary file with less than its header promises. @param offset byte at which it ends */
export function tooFewBytes(
  name: string,
  { count, what = 'point', needed }: Announced,
  offset: number,
): FloorPlanError {
  const least = needed === undefined ? '' : `, at least ${needed} bytes`;
  const detail = { announced: count, ...(needed !== undefined && { needed }) };
  return cutOffAt(name, `${countOf(count, what)} as the header says${least}`, offset, detail);
}

/** A text with fewer rows than it promises. @param of what rows hold that are no points */
export function tooFewRows(name: string, announced: number, found: number, of?: string): FloorPlanError {
  const rows = of ? countOf(announced, `row of ${of}`, `rows of ${of}`) : countOf(announced, 'point');
  return cutOff(name, `${rows} as the header says`, `${found} before the end of the file`, {
    announced,
    found,
  });
}

/** What is whole of a cloud that is cut off. */
export interface WholePart {
  readonly found: number;
  /** Undefined where the file does not tell. */
  readonly announced: number | undefined;
}

/** Whether what is whole is most of a cloud: then it is read, with a warning. */
export function isWorthReading({ found, announced = found }: WholePart): boolean {
  return found >= LEAST_POINTS && found >= LEAST_SHARE * announced;
}

/** Says in `warnings`, once, that only what is whole was read. @throws `error`, where that is not worth it */
export function goOnWith(part: WholePart, error: FloorPlanError, warnings: Warning[]): void {
  if (!isWorthReading(part)) throw error;
  const { found, announced } = part;
  const others = warnings.filter(({ code }) => code !== CUT_OFF);
  const whole = found.toLocaleString('en-GB');
  const of = announced === undefined ? '' : ` of the ${countOf(announced, 'point')} announced`;
  warnings.splice(0, Infinity, ...others, {
    code: CUT_OFF,
    message: `The file is cut off: ${whole}${of || ' points'} are whole, and only these were read.`,
    hint: 'Copy or export it again, for a part of the building may be missing.',
  });
}

const CUT_OFF = 'read/cut-off';

/** Says in `warnings`, once, that a file goes on after the points that its header announces. */
export function tellOfMore(announced: number, warnings: Warning[]): void {
  if (warnings.some(({ code }) => code === MORE)) return;
  warnings.push({
    code: MORE,
    message: `The file goes on after the ${countOf(announced, 'point')} that its header announces; what follows was not read.`,
    hint: 'If a part of the building is missing, export the cloud again: the number in its header is wrong.',
  });
}

const MORE = 'read/more-than-announced';
