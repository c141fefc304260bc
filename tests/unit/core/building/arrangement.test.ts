import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Arrangement, arrange, ringFrom } from '../../../../src/core/building/space/arrangement.ts';
import type { Segment } from '../../../../src/core/building/space/cut-segments.ts';
import { signedArea } from '../../../../src/core/geometry/rings.ts';

const segment = (line: number, ax: number, ay: number, bx: number, by: number): Segment => ({
  ax,
  ay,
  bx,
  by,
  line,
});

const frame = (size: number, from = 0, line = 0): Segment[] => [
  segment(line, from, from, from + size, from),
  segment(line + 1, from + size, from, from + size, from + size),
  segment(line + 2, from + size, from + size, from, from + size),
  segment(line + 3, from, from + size, from, from),
];

const total = ({ areas }: Arrangement) => areas.reduce((sum, area) => sum + area, 0);

describe('arrange', () => {
  it('cuts crossing lines into faces and drops what dangles', () => {
    const found = arrange([
      ...frame(2),
      segment(4, 1, -1, 1, 3),
      segment(5, -1, 1, 3, 1),
      segment(6, 0.2, 0.2, 0.4, 0.4),
    ]);
    expect([...found.areas]).toEqual([1, 1, 1, 1]);
    expect(found.origin.length / 2).toBe(12);
  });

  it('knows the lines of every edge, also where they overlap', () => {
    const found = arrange([...frame(2), segment(4, 0.5, 0, 1.5, 0)]);
    const shared = found.lines.filter((lines) => lines.length === 2);
    expect(shared).toEqual([[0, 4]]);
  });

  it('nests what lies within a face without touching it', () => {
    const found = arrange([...frame(10), ...frame(2, 4, 4)]);
    expect([...found.areas].sort((a, b) => a - b)).toEqual([4, 100]);
    const outer = found.areas.indexOf(100);
    expect(found.holes[outer]).toHaveLength(1);
    expect(signedArea(ringFrom(found, found.holes[outer][0]))).toBe(-4);
  });

  it('is empty where nothing closes', () => {
    expect(arrange([segment(0, 0, 0, 1, 0), segment(1, 1, 0, 1, 1)]).areas).toHaveLength(0);
    expect(arrange([]).areas).toHaveLength(0);
  });

  it('takes ends that miss a line by a hair for its points', () => {
    const found = arrange([...frame(2), segment(4, 1, 1e-6, 1, 2 - 1e-6)]);
    expect(found.areas).toHaveLength(2);
  });

  it('of any lines through a frame makes simple faces that fill it (Euler)', () => {
    // Whole centimetres: a wall is longer than what counts as one place.
    const place = fc.integer({ min: -50, max: 1050 }).map((cm) => cm / 100);
    fc.assert(
      fc.property(fc.array(fc.tuple(place, place, place, place), { maxLength: 14 }), (strokes) => {
        const found = arrange([
          ...frame(10),
          ...strokes.map(([ax, ay, bx, by], i) => segment(4 + i, ax, ay, bx, by)),
        ]);
        const rings = [...found.areas.keys()].map((f) => ringFrom(found, found.faceEdge[f]));
        for (const [f, ring] of rings.entries()) expect(signedArea(ring)).toBeCloseTo(found.areas[f], 6);
        const nested = found.holes.flat().map((h) => signedArea(ringFrom(found, h)));
        const outside = strokes.some((stroke) => stroke.some((v) => v < 0 || v > 10));
        const filled = total(found) + nested.reduce((sum, area) => sum + area, 0);
        if (!outside) expect(filled).toBeCloseTo(100, 4);
        else expect(filled).toBeGreaterThan(100 - 1e-4);
      }),
      { numRuns: 500 },
    );
  });
});
