import { describe, expect, it } from 'vitest';
import { chooseLevel } from '../../../src/core/level.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import type { PointCloud, Warning } from '../../../src/core/types.ts';
import { findWallPoints } from '../../../src/core/wall-columns.ts';
import { makeCloud } from './made-scan.ts';

/** A wall along x at y = 0 up to `top`, and a window's reveal behind it from 0.9 to 2.1 m, points 2 cm apart. */
function wallWithReveal(top: number): { cloud: PointCloud; kept: Uint32Array } {
  const positions: number[] = [];
  for (let z = 0.01; z < top; z += 0.02) {
    for (let x = 0; x < 4; x += 0.02) positions.push(x, 0, z);
  }
  for (let z = 0.9; z < 2.1; z += 0.02) {
    for (let y = 0.02; y < 0.36; y += 0.02) positions.push(1, y, z);
  }
  const cloud = makeCloud(positions, { floor: 0, ceiling: 2.8 });
  return { cloud, kept: Uint32Array.from({ length: positions.length / 3 }, (_, i) => i) };
}

function standing(top: number, wallReach: number) {
  const { cloud, kept } = wallWithReveal(top);
  const warnings: Warning[] = [];
  const context = {
    warn: (w: Warning) => warnings.push(w),
    progress: () => {},
    strokeTest: () => new Uint8Array(),
  };
  const options = resolveOptions({ level: '1:2', wallReach });
  const level = chooseLevel(cloud, kept, options, context);
  const { indices, band } = findWallPoints(cloud, kept, level, options, context);
  const inLevel = indices.filter((i) => cloud.positions[3 * i + 2] < 2);
  const deepest = Math.max(...[...indices].map((i) => cloud.positions[3 * i + 1]));
  const share = inLevel.length / level.indices.length;
  return {
    share,
    deepest,
    lintel: indices.length - inLevel.length,
    top: band[1],
    codes: warnings.map(({ code }) => code),
  };
}

describe('findWallPoints', () => {
  it('keeps the wall, which goes on above the level, and drops the reveal, which ends at its lintel', () => {
    const { share, deepest, lintel, top, codes } = standing(2.8, 0.6);
    expect(share).toBeGreaterThan(0.7);
    expect(lintel).toBeGreaterThan(5000);
    expect(top).toBeCloseTo(2.7, 5);
    expect(deepest).toBeLessThanOrEqual(0.06);
    expect(codes).toEqual([]);
  });

  it('keeps all where it is switched off', () => {
    expect(standing(2.8, 0)).toMatchObject({ share: 1, lintel: 0, top: 2 });
  });

  it('keeps all, with a warning, where nothing was scanned above', () => {
    expect(standing(2.1, 0.6)).toMatchObject({ share: 1, codes: ['slice/no-upper-walls'] });
  });
});
