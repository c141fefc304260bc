import { areaOf, combine, grow } from '../../geometry/areas.ts';
import { signedArea } from '../../geometry/rings.ts';
import { simplifyRings } from '../../regularise/simplify-ring.ts';
import type { Polygon } from '../../types.ts';
import { areaOfBox, type Box, boxAround, cornersOf } from './furniture-box.ts';

/** A thing that fills so much of its box is one: most are made of boards. A round table fills 0.79 of its. */
const BOX_SHARE = 0.82;
/** Half the width of gaps that close, m: nothing is put a hand's breadth from another; rims are straightened as much. */
const ROUGH = 0.06;
/** Floor within a ring of tables is floor where somebody can stand on it, m²; smaller holes are sparse points. */
const STANDING_PLACE = 0.25;

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
 * @returns polygons apart from each other. O(n log n + cells of the box).
 */
export function furnitureOutlines(points: GroupPoints, size: number, thinnest: number): Polygon[] {
  const { seen, known, wall } = points;
  const box = boxAround(seen, known, wall);
  const rough = Math.max(ROUGH, size);
  const closed = grow(grow(filledCells(points, box, size), rough), -rough);
  const filled = closed.map(({ outer, holes }) => ({
    outer,
    holes: holes.filter((hole) => -signedArea(hole) >= STANDING_PLACE),
  }));
  const whole: Polygon = { outer: cornersOf(box), holes: [] };
  const inBox = areaOf(combine('intersection', filled, [whole]));
  if (inBox >= BOX_SHARE * areaOfBox(box)) {
    return Math.min(box.maxU - box.minU, box.maxV - box.minV) < thinnest ? [] : [whole];
  }
  const thick = grow(grow(filled, -thinnest / 2), thinnest / 2);
  return thick.map(({ outer, holes }) => {
    const tolerances = { epsilon: rough, areaEpsilon: 0 };
    const [rim, ...inner] = simplifyRings([outer, ...holes], 'douglas-peucker', tolerances).rings;
    return { outer: rim, holes: inner };
  });
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
