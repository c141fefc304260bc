import { FloorPlanError } from './errors.ts';

/** What the parameter `crop` says: a box in the plan frame, source units and source coordinates, as in plan.geojson. */
export interface CropBox {
  readonly x0: number;
  readonly y0: number;
  readonly x1: number;
  readonly y1: number;
  /** Heights in source coordinates, from and to; null where all count. */
  readonly heights: readonly [low: number, high: number] | null;
}

/** What {@link parseCrop} reads, in words. */
export const CROP_WORDS = 'none or x0,y0,x1,y1[,z0,z1] with x0 < x1, y0 < y1 and z0 < z1';

/**
 * Reads `none` or `x0,y0,x1,y1[,z0,z1]`; the inverse of {@link formatCrop}.
 *
 * @returns null for `none`
 * @throws option/invalid
 */
export function parseCrop(text: string): CropBox | null {
  if (text.trim() === 'none') return null;
  const fields = text.split(',').map((field) => (field.trim() === '' ? Number.NaN : Number(field)));
  const [x0, y0, x1, y1, z0, z1] = fields;
  const isComplete = fields.length === 4 || fields.length === 6;
  const isSound = fields.every(Number.isFinite) && x0 < x1 && y0 < y1 && (z0 === undefined || z0 < z1);
  if (!isComplete || !isSound) {
    throw new FloorPlanError('option/invalid', `crop: expected ${CROP_WORDS}, found "${text}"`, {
      hint: 'The corners are in source units and coordinates, as in plan.geojson; none takes the box away.',
      detail: { option: 'crop' },
    });
  }
  return { x0, y0, x1, y1, heights: z0 === undefined ? null : [z0, z1] };
}

/** Writes what {@link parseCrop} reads. */
export function formatCrop(box: CropBox | null): string {
  if (box === null) return 'none';
  const { x0, y0, x1, y1, heights } = box;
  return [x0, y0, x1, y1, ...(heights ?? [])].join(',');
}
