/** What the page says of gaps, recesses and narrow spaces holds. */
import { describe, expect, it } from 'vitest';
import { doorGaps, OPENING_LENGTHS, recesses } from './door-gaps.ts';
import { narrowSpaces } from './narrow-spaces.ts';

/** A hull may be this much worse than the α-shape at its best α. */
const TIE = 0.005;

describe('experiments on the boundary', () => {
  it('narrow spaces: gift opening is no worse than the α-shape', () => {
    const rows = narrowSpaces();
    expect(rows.map(({ width }) => width)).toContain(0.3);
    for (const { width, giftOpening, alphaShape, alphaShapeRegularised } of rows) {
      expect(giftOpening, `${width} m`).toBeGreaterThanOrEqual(alphaShape - TIE);
      expect(giftOpening, `${width} m`).toBeGreaterThanOrEqual(alphaShapeRegularised - TIE);
    }
  }, 120_000);

  it('door gaps: at most 2 % with the safeguard at every opening length, most of the room without', () => {
    const { byWidth, byOpeningLength } = doorGaps();
    for (const { width, worst, worstWithout } of byWidth) {
      expect(worst, `${width} m`).toBeLessThan(0.02);
      expect(worstWithout, `${width} m`).toBeGreaterThan(0.5);
    }
    expect(byOpeningLength.map(({ openingLength }) => openingLength)).toEqual([...OPENING_LENGTHS]);
    for (const { openingLength, worst } of byOpeningLength)
      for (const [room, cost] of Object.entries(worst))
        expect(cost, `${room}, opening length ${openingLength}`).toBeLessThan(0.02);
  }, 120_000);

  it('recesses: followed with an IoU of 0.98 at least', () => {
    for (const { mouth, lowest } of recesses()) expect(lowest, `${mouth} m`).toBeGreaterThan(0.98);
  });
});
