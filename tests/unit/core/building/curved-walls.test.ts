import { expect, it } from 'vitest';
import { seededRandom } from '../../../../fixtures/simulator/random.ts';
import { heightColumns } from '../../../../src/core/building/columns/height-columns.ts';
import { localCeiling } from '../../../../src/core/building/columns/local-ceiling.ts';
import { findFaces } from '../../../../src/core/building/faces/find-faces.ts';
import { isArc } from '../../../../src/core/building/faces/grow-arc.ts';
import { endedAtWalls } from '../../../../src/core/building/space/curved-walls.ts';
import type { PointCloud } from '../../../../src/core/types.ts';
import { UPRIGHT_FRAME } from '../made-scan.ts';

type Curve = (share: number) => { readonly at: readonly [number, number]; readonly normal: number };

const circle =
  (radius: number, from: number, to: number): Curve =>
  (share) => {
    const normal = from + share * (to - from);
    return { at: [radius * Math.cos(normal), radius * Math.sin(normal)], normal };
  };

const straight =
  (x: number, y: number, length: number): Curve =>
  (share) => ({ at: [x, y + share * length], normal: 0 });

/** Points from floor to ceiling over curves, with noise across them, m. */
function columnsOver(curves: readonly Curve[], noise: number) {
  const each = 30_000;
  const random = seededRandom(11, 'curves');
  const positions = new Float32Array(3 * each * curves.length);
  curves.forEach((curve, k) => {
    for (let i = k * each; i < (k + 1) * each; i++) {
      const { at, normal } = curve(random.between(0, 1));
      const across = noise * random.normal();
      const place = [at[0] + across * Math.cos(normal), at[1] + across * Math.sin(normal)];
      positions.set([...place, random.between(0, 2.5)], 3 * i);
    }
  });
  const reasons = { unit: '', up: '' };
  const made = { frame: UPRIGHT_FRAME, attributes: {}, stations: [], floor: 0, ceiling: 2.5 };
  const cloud: PointCloud = { ...made, positions, reasons, isFlat: false };
  const kept = Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  const columns = heightColumns(cloud, kept, { floor: 0, ceiling: 2.5 });
  return { cloud, columns };
}

function facesOver(curves: readonly Curve[], noise: number) {
  const { cloud, columns } = columnsOver(curves, noise);
  return findFaces({ cloud, columns, ceiling: localCeiling(columns) });
}

it.each([0.004, 0.016])('both faces of a thin curved wall are one arc each, with %f m of noise', (noise) => {
  const walls = [straight(-3, -3, 6), straight(9, -3, 6)];
  const { curved, straight: lines } = facesOver(
    [circle(6, -0.5, 0.5), circle(6.14, -0.5, 0.5), ...walls],
    noise,
  );
  const rising = [...curved].sort((a, b) => a.radius - b.radius);
  expect(rising).toHaveLength(2);
  expect(Math.abs(rising[0].radius - 6)).toBeLessThan(0.02);
  expect(Math.abs(rising[1].radius - 6.14)).toBeLessThan(0.02);
  for (const { cx, cy, from, to } of rising) {
    expect(Math.hypot(cx, cy)).toBeLessThan(0.02);
    expect(to - from).toBeGreaterThan(0.97);
  }
  expect(lines.filter(({ from, to }) => to - from > 0.5)).toHaveLength(2);
});

it('a straight wall is no arc, however far it scatters', () => {
  const { curved, straight: lines } = facesOver([straight(0, 0, 5), straight(0.3, 0, 5)], 0.02);
  expect(curved).toHaveLength(0);
  expect(lines.filter(({ from, to }) => to - from > 4.5)).toHaveLength(2);
});

it('nor is one with what stands farther along a circle', () => {
  const isArcOver = (curves: readonly Curve[]) => {
    const columns = columnsOver(curves, 0.012).columns;
    const members = [...columns.hits.keys()].filter((c) => columns.hits[c] > 2);
    return isArc(columns, { cx: 0, cy: 0, radius: 3, from: -0.25, to: 0.65, members });
  };
  expect(isArcOver([straight(3, -0.65, 1.3), circle(3, 0.5, 0.62)])).toBe(false);
  expect(isArcOver([circle(3, -0.22, 0.22), circle(3, 0.5, 0.62)])).toBe(true);
});

it('a curve drawn on ends at the wall it meets', () => {
  const chord = (from: number, support: number) => {
    const line = { nx: 0, ny: 1, offset: 0, from, to: from + 1, members: [] };
    return { ...line, noise: 0.01, support, reach: 0 };
  };
  // Along a line whose normal is y, places grow towards −x.
  const wall = {
    nx: 1,
    ny: 0,
    offset: -2.5,
    from: -1,
    to: 1,
    members: [],
    noise: 0.01,
    support: 9,
    reach: 5,
  };
  const shares = new Float64Array(40).fill(1);
  const isSeen = new Uint8Array(40).fill(1);
  const support = { from: -1, step: 0.05, shares, isSeen, ceiling: new Float64Array(40) };
  const chords = [chord(0, 5), chord(1, 0), chord(2, 0), chord(3, 0)];
  const ended = endedAtWalls(chords, { faces: [wall], supports: [support] });
  expect(ended).toHaveLength(3);
  expect(ended[2].to).toBeCloseTo(2.52, 6);
  const hidden = { ...support, shares: new Float64Array(40) };
  expect(endedAtWalls(chords, { faces: [wall], supports: [hidden] })).toEqual(chords);
});
