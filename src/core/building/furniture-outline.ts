import { areaOf, combine, grow } from '../geometry/areas.ts';
import { simplifyRing } from '../regularise/simplify-ring.ts';
import type { Polygon, Ring } from '../types.ts';
import { areaOfBox, type Box, boxAround, cornersOf } from './furniture-box.ts';

/** A thing that fills so much of its box is one: most are made of boards. A round table fills 0.79 of its. */
const BOX_SHARE = 0.82;
/** Half the width of gaps that close, m: nothing is put a hand's breadth from another; rims are straightened as much. */
const ROUGH = 0.06;

/** What one group of columns shows, m. */
export interface GroupPoints {
  /** Measured points, x, y each. */
  readonly seen: Float64Array;
  /** Places that nobody saw but that must be filled, likewise. */
  readonly known: Float64Array;
  /** Unit vector along the nearest wall. */
  readonly wall: readonly [ux: number, uy: number];
  /** Whether a place is hidden by the group: then it fills its box there. */
  readonly isHidden: (x: number, y: number) => boolean;
}

/**
 * Footprints of a group of points: its box where it fills that, else the area of its cells with straightened rims.
 *
 * @param size of a cell, m: hardly more than points are apart
 * @param thinnest what is nowhere as thick as this, m, is left out
 * @returns counter-clockwise rings. O(n log n + cells of the box).
 */
export function furnitureOutlines(points: GroupPoints, size: number, thinnest: number): Ring[] {
  const { seen, known, wall } = points;
  const box = boxAround(seen, known, wall);
  const rough = Math.max(ROUGH, size);
  const closed = grow(grow(filledCells(points, box, size), rough), -rough);
  const filled = closed.map(({ outer }): Polygon => ({ outer, holes: [] }));
  const corners = cornersOf(box);
  const inBox = areaOf(combine('intersection', filled, [{ outer: corners, holes: [] }]));
  if (inBox >= BOX_SHARE * areaOfBox(box)) {
    return Math.min(box.maxU - box.minU, box.maxV - box.minV) < thinnest ? [] : [corners];
  }
  const thick = grow(grow(filled, -thinnest / 2), thinnest / 2);
  return thick.map(({ outer }) =>
    simplifyRing(outer, { epsilon: rough, areaEpsilon: 0, passes: ['douglas-peucker'] }),
  );
}

/** The cells with points, row by row in a grid along a box: rectangles that touch. */
function filledCells({ seen, known, isHidden }: GroupPoints, box: Box, size: number): Polygon[] {
  const { ux, uy, minU, maxU, minV, maxV } = box;
  const [width, depth] = [Math.ceil((maxU - minU) / size), Math.ceil((maxV - minV) / size)];
  const isFilled = new Uint8Array(width * depth);
  for (const xy of [seen, known]) {
    for (let i = 0; i < xy.length; i += 2) {
      const iu = Math.floor((xy[i] * ux + xy[i + 1] * uy - minU) / size);
      const iv = Math.floor((xy[i + 1] * ux - xy[i] * uy - minV) / size);
      if (iu >= 0 && iu < width && iv >= 0 && iv < depth) isFilled[iv * width + iu] = 1;
    }
  }
  const isFull = (iu: number, iv: number) => {
    const [u, v] = [minU + (iu + 0.5) * size, minV + (iv + 0.5) * size];
    return isFilled[iv * width + iu] === 1 || isHidden(u * ux - v * uy, u * uy + v * ux);
  };
  const rows: Polygon[] = [];
  for (let iv = 0; iv < depth; iv++) {
    for (let iu = 0; iu < width; iu++) {
      const from = iu;
      while (iu < width && isFull(iu, iv)) iu++;
      if (iu === from) continue;
      const [u, v] = [minU + from * size, minV + iv * size];
      const run: Box = { ux, uy, minU: u, maxU: minU + iu * size, minV: v, maxV: v + size };
      rows.push({ outer: cornersOf(run), holes: [] });
    }
  }
  return rows;
}
