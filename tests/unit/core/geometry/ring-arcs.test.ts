import { expect, it } from 'vitest';
import {
  chordTurn,
  circlesOf,
  ON_ARC,
  placedOnArcs,
  SAGITTA,
  withArcs,
} from '../../../../src/core/geometry/ring-arcs.ts';
import type { Polygon, Ring } from '../../../../src/core/types.ts';
import { disc, rectangle, ring } from '../../solid/plans.ts';

const circle = { cx: 2, cy: 1, radius: 3 };

/** A half disc: its chord from (5, 1) to (−1, 1) is one edge. */
function halfDisc(steps = 24): Ring {
  const xy: number[] = [];
  for (let k = 0; k <= steps; k++) {
    const angle = (Math.PI * k) / steps;
    xy.push(circle.cx + circle.radius * Math.cos(angle), circle.cy + circle.radius * Math.sin(angle));
  }
  return ring(...xy);
}

const area = (outer: Ring, ...holes: Ring[]): Polygon => ({ outer, holes });
const offCircle = (xy: Ring, i: number) =>
  Math.abs(Math.hypot(xy[2 * i] - circle.cx, xy[2 * i + 1] - circle.cy) - circle.radius);

it('a chord of the widest turn leaves its circle by the sagitta', () => {
  for (const radius of [0.2, 1, 7, 40])
    expect(radius * (1 - Math.cos(chordTurn(radius) / 2))).toBeCloseTo(SAGITTA, 9);
});

it('the vertices along a circle are told, from the first to the last', () => {
  const { arcs } = withArcs(area(halfDisc()), [circle]);
  expect(arcs).toEqual([{ ring: 0, from: 0, to: 24, centre: [2, 1], radius: 3 }]);
});

it('a run may go past the last vertex of a ring, and be in a hole', () => {
  const half = halfDisc();
  const turned = ring(...half.subarray(20), ...half.subarray(0, 20));
  const { arcs } = withArcs(area(rectangle(-9, -9, 20, 20), turned), [circle]);
  expect(arcs).toEqual([{ ring: 1, from: 15, to: 14, centre: [2, 1], radius: 3 }]);
});

it('a whole circle ends where it begins', () => {
  const { arcs } = withArcs(area(disc(2, 1, 3, 72)), [circle]);
  expect(arcs).toEqual([{ ring: 0, from: 0, to: 0, centre: [2, 1], radius: 3 }]);
});

it('what is no more on its circle is no more told', () => {
  const bent = halfDisc();
  bent[2 * 10] += 0.002;
  const { arcs } = withArcs(area(bent), [circle]);
  expect(arcs?.map(({ from, to }) => [from, to])).toEqual([
    [0, 9],
    [11, 24],
  ]);
  const moved = halfDisc().map((value) => value + 0.002);
  expect(withArcs(area(moved), [circle])).not.toHaveProperty('arcs');
});

it('corners on a common circle are no curve, nor is a single chord', () => {
  const corners = { cx: 2, cy: 1.5, radius: 2.5 };
  expect(withArcs(area(rectangle(0, 0, 4, 3)), [corners])).not.toHaveProperty('arcs');
  const chord = ring(...halfDisc().subarray(0, 4), -9, 9, -9, -9);
  expect(withArcs(area(chord), [circle])).not.toHaveProperty('arcs');
});

it('circles come back, each once, and arcs in other units', () => {
  const polygon = withArcs(area(halfDisc()), [circle]);
  expect(circlesOf(polygon)).toEqual([circle]);
  const feet = halfDisc().map((value) => value / 0.3048);
  const inFeet = { cx: 2 / 0.3048, cy: 1 / 0.3048, radius: 3 / 0.3048 };
  expect(withArcs(area(feet), [inFeet], 0.3048).arcs).toHaveLength(1);
});

it('where chords meet walls the vertex moves along the wall on to the circle', () => {
  const half = halfDisc();
  // The walls at both ends cross the outermost chords in their middles.
  const n = half.length;
  const [sx, sy] = [(half[0] + half[2]) / 2, (half[1] + half[3]) / 2];
  const [ex, ey] = [(half[n - 4] + half[n - 2]) / 2, (half[n - 3] + half[n - 1]) / 2];
  const cut = ring(sx, sy, ...half.subarray(2, n - 2), ex, ey, -9, ey, -9, -9, 9, -9, 9, sy);
  const placed = placedOnArcs(cut, [circle]);
  expect(offCircle(cut, 0)).toBeGreaterThan(ON_ARC);
  for (let i = 0; i <= 24; i++) expect(offCircle(placed, i)).toBeLessThan(1e-9);
  expect(placed[1]).toBeCloseTo(sy, 12);
  expect(placed[2 * 24 + 1]).toBeCloseTo(ey, 12);
  expect(withArcs(area(placed), [circle]).arcs?.map(({ from, to }) => [from, to])).toEqual([[0, 24]]);
});
