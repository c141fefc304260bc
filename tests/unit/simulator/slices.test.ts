import { describe, expect, it } from 'vitest';
import { distanceToRing, inset, perimeter } from '../../../fixtures/simulator/ring.ts';
import {
  hallwaySlice,
  PAPER_SLICES,
  type PaperSliceName,
  paperSlice,
  structureSlice,
} from '../../../fixtures/simulator/slices.ts';
import { expectValidRing } from '../../invariants.ts';

const names = Object.keys(PAPER_SLICES) as PaperSliceName[];
/** Four deviations of 1.2 px in x and in y. */
const REACH = 4 * 1.2 * Math.SQRT2;

describe('paper slices', () => {
  it('have the numbers of points that the paper gives', () => {
    expect(names.map((name) => paperSlice(name).xy.length / 2)).toEqual([1799, 1630, 628, 605, 492, 238]);
  });

  it.each(names)('%s: valid truth, every point near a wall, walls seen everywhere', (name) => {
    const { xy, primary, secondary } = paperSlice(name);
    for (const ring of [primary, ...secondary]) expectValidRing(Float64Array.from(ring.flat()));
    const { structure } = PAPER_SLICES[name] as { structure?: { thickness: number } };
    const walls = [primary, ...secondary, ...secondary.map((ring) => inset(ring, structure!.thickness))];
    for (let i = 0; i < xy.length; i += 2) {
      const away = Math.min(...walls.map((ring) => distanceToRing(ring, xy[i], xy[i + 1])));
      expect(away).toBeLessThan(REACH);
    }
    const spacing = perimeter(primary) / (xy.length / 2);
    for (const [x, y] of primary) {
      let nearest = Infinity;
      for (let i = 0; i < xy.length; i += 2)
        nearest = Math.min(nearest, Math.hypot(xy[i] - x, xy[i + 1] - y));
      expect(nearest).toBeLessThan(REACH + 4 * spacing);
    }
  });

  it('are the same for the same seed', () => {
    expect(paperSlice('room-2', 5)).toEqual(paperSlice('room-2', 5));
    expect(paperSlice('room-2', 5).xy).not.toEqual(paperSlice('room-2', 6).xy);
  });

  it('come in metres for the pipeline, with the spacing the points have', () => {
    const { xy, spacing } = hallwaySlice();
    const pixels = paperSlice('hallway-1').xy;
    expect(xy[0]).toBeCloseTo(pixels[0] / 100, 12);
    expect(spacing).toBeGreaterThan(0.003);
    expect(spacing).toBeLessThan(0.02);
    expect(structureSlice().secondary).toHaveLength(1);
  });
});
