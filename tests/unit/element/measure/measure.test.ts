import { describe, expect, it } from 'vitest';
import { scaleFor } from '../../../../src/element/measure/scale.ts';
import { outlineEdges, planEdges, snap } from '../../../../src/element/measure/snap.ts';
import { lengthOf } from '../../../../src/element/stretch.ts';
import { planOf, ring, wallAround } from '../../solid/plans.ts';

const room = ring(0, 0, 6, 0, 6, 4, 0, 4);
const walls = [{ outline: wallAround(room, 0.2), thickness: 0.2, confidence: 1 }];
const [storey] = planOf({ storeys: [{ primary: [{ outer: room, holes: [] }], walls }] }).storeys;

describe('edges', () => {
  it('are those of the outline, and of walls too', () => {
    expect(outlineEdges(storey).map(lengthOf)).toEqual([6, 4, 6, 4]);
    expect(planEdges(storey).length).toBeGreaterThan(8);
  });
});

describe('snap', () => {
  const edges = outlineEdges(storey);

  it('prefers a corner to the edge that is nearer', () => {
    expect(snap(edges, [5.9, 0.02], 0.15)).toEqual({ at: [6, 0], isCaught: true });
  });

  it('takes the foot on an edge where no corner is near', () => {
    expect(snap(edges, [3, 0.1], 0.15)).toEqual({ at: [3, 0], isCaught: true });
  });

  it('leaves a place alone where nothing is near', () => {
    expect(snap(edges, [3, 2], 0.15)).toEqual({ at: [3, 2], isCaught: false });
    expect(snap([], [3, 2], 0.15)).toEqual({ at: [3, 2], isCaught: false });
  });

  it('takes the nearest of several', () => {
    expect(snap(edges, [0.1, 3.95], 5).at).toEqual([0, 4]);
  });
});

describe('scaleFor', () => {
  it('makes the length what it truly is', () => {
    expect(scaleFor(4, 6, 1)).toBe(1.5);
    expect(scaleFor(4000, 6, 0.001)).toBe(0.0000015);
    expect(scaleFor(3, 1, 1)).toBeCloseTo(1 / 3, 7);
  });

  it('is none for no length, and where the parameter allows none', () => {
    expect(scaleFor(0, 6, 1)).toBeNull();
    expect(scaleFor(1e-9, 6, 1)).toBeNull();
  });
});
