import { describe, expect, it } from 'vitest';
import { columnAt } from '../../../../src/core/building/columns/height-columns.ts';
import type { Face } from '../../../../src/core/building/faces/face.ts';
import { withEnds } from '../../../../src/core/building/faces/face-ends.ts';
import { allFree, columnsAt } from './upright-columns.ts';

describe('past the end of a face', () => {
  const wall = Array.from({ length: 20 }, (_, k) => [0.07 + 0.1 * k, 0.01] as const);
  const columns = columnsAt([...wall, [2.08, 0.012], [2.14, 0.04], [2.5, 0.01]]);
  const at = (x: number, y = 0.01) => columnAt(columns, x, y);
  // Places along a line run against x where its normal is y.
  const face = (noise: number): Face => ({
    ...{ nx: 0, ny: 1, offset: 0.01, from: -2, to: 0, noise, support: 1000 },
    members: wall.map(([x, y]) => columnAt(columns, x, y)),
  });
  const free = () => allFree(columns);

  it('columns on its line join it, whatever line they make with others', () => {
    const walls = free();
    const whole = withEnds(walls, face(0.004));
    expect(whole.from).toBeLessThan(-2.07);
    expect(whole.from).toBeGreaterThan(-2.15);
    expect(whole.members).toContain(at(2.08));
    expect(walls.isFree[at(2.08)]).toBe(0);
    expect(walls.isFree[at(2.14, 0.04)]).toBe(1);
  });

  it('none do that another face has taken, nor beside a noisy one', () => {
    const walls = free();
    walls.isFree[at(2.08)] = 0;
    expect(withEnds(walls, face(0.004)).from).toBe(-2);
    expect(withEnds(free(), face(0.02)).from).toBe(-2);
  });
});
