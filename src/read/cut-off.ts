import { countOf } from '../core/count-words.ts';
import { FloorPlanError } from '../core/errors.ts';

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
