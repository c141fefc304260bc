import { FloorPlanError } from './errors.ts';

/** What the parameter `crop` says: a box in the plan frame, source units and source coordinates, as in plan.geojson. */
export interface CropBox {
  readonly x0: number;
  readonly y0: number;
  readonly x1: number;
  readonly y1: number;
  /** Heights in source coordinates, from and to; null where all count. */
  readonly heights: readonly [low: number, high: number] | null;
  /** The box is turned about its middle by so many degrees, counter-clockwise; 0 leaves it along the axes. */
  readonly heading: number;
}

/** How a box is written. */
export const CROP_FORM = 'x0,y0,x1,y1[,z0,z1][@heading]';
/** What {@link parseCrop} reads, in words. */
export const CROP_WORDS = `none or ${CROP_FORM} with x0 < x1, y0 < y1, z0 < z1 and -180 ≤ heading ≤ 180`;

/** Degrees either way: half a turn. */
export const MOST_HEADING = 180;

/**
 * Reads `none` or `x0,y0,x1,y1[,z0,z1][@heading]`; the inverse of {@link formatCrop}.
 *
 * @returns null for `none`
 * @throws option/invalid
 */
export function parseCrop(text: string): CropBox | null {
  if (text.trim() === 'none') return null;
  const [sides, turn = '0', ...more] = text.split('@');
  const fields = sides.split(',').map(readNumber);
  const heading = readNumber(turn);
  const [x0, y0, x1, y1, z0, z1] = fields;
  const isComplete = (fields.length === 4 || fields.length === 6) && more.length === 0;
  const isTurned = Math.abs(heading) <= MOST_HEADING;
  const isSound = fields.every(Number.isFinite) && x0 < x1 && y0 < y1 && (z0 === undefined || z0 < z1);
  if (!isComplete || !isSound || !isTurned) {
    throw new FloorPlanError('option/invalid', `crop: expected ${CROP_WORDS}, found "${text}"`, {
      hint: 'The corners are in source units and coordinates, as in plan.geojson; none takes the box away.',
      detail: { option: 'crop' },
    });
  }
  return { x0, y0, x1, y1, heights: z0 === undefined ? null : [z0, z1], heading };
}

/** Writes what {@link parseCrop} reads. */
export function formatCrop(box: CropBox | null): string {
  if (box === null) return 'none';
  const { x0, y0, x1, y1, heights, heading } = box;
  const sides = [x0, y0, x1, y1, ...(heights ?? [])].join(',');
  return heading === 0 ? sides : `${sides}@${heading}`;
}

function readNumber(text: string): number {
  return text.trim() === '' ? Number.NaN : Number(text);
}
