import fc from 'fast-check';
import { expect, test } from 'vitest';
import { areaOf, combine } from '../../src/core/geometry/areas.ts';
import { polygonProblems } from '../invariants.ts';
import { FurnishedRoom } from '../unit/core/building/furnished-room.ts';

const { WIDTH, DEPTH, HEIGHT } = FurnishedRoom;

/** A box anywhere in the room or partly out of it, its top seen or not. */
const thing = fc.record({
  x: fc.double({ min: -0.2, max: WIDTH, noNaN: true }),
  y: fc.double({ min: -0.2, max: DEPTH, noNaN: true }),
  width: fc.double({ min: 0.02, max: 2.5, noNaN: true }),
  depth: fc.double({ min: 0.02, max: 1.5, noNaN: true }),
  low: fc.double({ min: 0, max: 1.5, noNaN: true }),
  high: fc.double({ min: 0.05, max: HEIGHT, noNaN: true }),
  hasTop: fc.boolean(),
});

test('every footprint is a valid polygon within its room, whatever stands there', () => {
  fc.assert(
    fc.property(
      fc.array(thing, { maxLength: 8 }),
      fc.double({ min: -3.2, max: 3.2, noNaN: true }),
      (things, turn) => {
        const scene = new FurnishedRoom();
        for (const { x, y, width, depth, low, high, hasTop } of things) {
          const box = [x, y, x + width, y + depth] as const;
          scene.sides(box, [Math.min(low, high), high]).hide(box);
          if (hasTop) scene.level(high, box);
        }
        const { found, room } = scene.furniture(turn);
        for (const { outline, height, confidence } of found) {
          expect(polygonProblems(outline)).toEqual([]);
          expect(areaOf(combine('difference', [outline], [room]))).toBeLessThan(1e-5);
          expect(areaOf([outline])).toBeGreaterThanOrEqual(0.05);
          expect(height).toBeGreaterThanOrEqual(0.1);
          expect(height).toBeLessThanOrEqual(HEIGHT);
          expect(confidence).toBeGreaterThan(0);
          expect(confidence).toBeLessThanOrEqual(1);
        }
      },
    ),
    { numRuns: 60 },
  );
});
