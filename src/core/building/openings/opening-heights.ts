import { medianOf } from '../../robust-scale.ts';
import { DEEPEST_LEAF, LEAST_RECESS } from './void-parts.ts';
import { FEWEST, LOOK_FROM, LOOK_TO, STEP, type Stretch, type WallLook } from './wall-look.ts';

/** A face stands at a height where it has points over this share of the width. */
const STANDING_SHARE = 0.4;

/**
 * Heights above the floor, m, between which no face stands over most of a stretch, around eye height; of a closed leaf, between
 * which what is there stands back.
 */
export function faceHeights(
  look: WallLook,
  stretch: Stretch,
  band: number,
  isClosed: boolean,
): { head: number; sill: number } {
  const standsBack = isClosed ? recessedRows(look, stretch) : [];
  const isWall = standingRows(look, stretch, band).map((isStanding, row) => isStanding && !standsBack[row]);
  const middle = Math.round((LOOK_FROM + LOOK_TO) / 2 / STEP);
  let top = middle;
  while (top < isWall.length && !isWall[top]) top++;
  let bottom = middle;
  while (bottom >= 0 && !isWall[bottom]) bottom--;
  return {
    head: top >= isWall.length ? look.ceiling : top * STEP,
    sill: bottom < 0 ? 0 : (bottom + 1) * STEP,
  };
}

/** Whether what is at the face of a stretch lies behind it, as a leaf does, for each bit of height. */
function recessedRows({ strip, ceiling }: WallLook, { begin, end }: Stretch): boolean[] {
  const { count, along, deep, high } = strip;
  const depths: number[][] = Array.from({ length: Math.ceil(ceiling / STEP) }, () => []);
  for (let i = 0; i < count; i++) {
    if (along[i] < begin || along[i] >= end || Math.abs(deep[i]) > DEEPEST_LEAF) continue;
    depths[Math.floor(high[i] / STEP)]?.push(deep[i]);
  }
  return depths.map((own) => own.length >= FEWEST && medianOf(Float64Array.from(own)) > LEAST_RECESS);
}

/** Whether a face stands over a stretch, for each bit of height. */
function standingRows(
  { strip, thickness, ceiling }: WallLook,
  { begin, end }: Stretch,
  band: number,
): boolean[] {
  const { count, along, deep, high } = strip;
  const rows = Math.ceil(ceiling / STEP);
  const columns = Math.max(1, Math.floor((end - begin) / STEP));
  const hits = new Uint8Array(rows * columns);
  for (let i = 0; i < count; i++) {
    const isOn = Math.abs(deep[i]) <= band || Math.abs(deep[i] - thickness) <= band;
    const isWithin = along[i] >= begin && along[i] < end && high[i] >= 0 && high[i] < ceiling;
    if (!isOn || !isWithin) continue;
    const column = Math.min(columns - 1, Math.floor((along[i] - begin) / STEP));
    hits[Math.min(rows - 1, Math.floor(high[i] / STEP)) * columns + column] = 1;
  }
  return Array.from({ length: rows }, (_, r) => {
    let sum = 0;
    for (let c = 0; c < columns; c++) sum += hits[r * columns + c];
    return sum >= STANDING_SHARE * columns;
  });
}
