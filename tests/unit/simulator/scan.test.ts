import { beforeAll, describe, expect, it } from 'vitest';
import { footprint, type Opening, type Prism, type Storey } from '../../../fixtures/simulator/building.ts';
import { type Scene, simulate } from '../../../fixtures/simulator/index.ts';
import { columnRoomBuilding, homeBuilding } from '../../../fixtures/simulator/layouts.ts';
import { MAX_DEVIATIONS } from '../../../fixtures/simulator/random.ts';
import { contains, distanceToRing, distanceToSegment, type XY } from '../../../fixtures/simulator/ring.ts';
import { DEFAULT_SCAN, MOBILE_SCAN, STRAY_REACH } from '../../../fixtures/simulator/scan.ts';
import { KINDS, type Kind } from '../../../fixtures/simulator/surfaces.ts';
import type { TruthStorey } from '../../../fixtures/simulator/truth.ts';

const few = { raysPerStation: 30_000, voxel: 0.05 };
const open = (rings: readonly (readonly (readonly number[])[])[]): XY[][] =>
  rings.map((ring) => ring.slice(0, -1).map(([x, y]): XY => [x, y]));

/** Distance of a point from the surfaces of its kind as the truth has them, source units; NaN for furniture. */
function distanceToTruth(kind: Kind, [x, y, z]: readonly number[], truth: TruthStorey): number {
  const rooms = truth.rooms.flatMap(open);
  const toRings = (rings: readonly XY[][]): number =>
    Math.min(...rings.map((ring) => distanceToRing(ring, x, y)));
  switch (kind) {
    case 'wall':
      return toRings(rooms);
    case 'floor':
      return Math.abs(z - truth.floor);
    case 'ceiling':
      return Math.min(...truth.heights!.map((height) => Math.abs(z - truth.floor - height)));
    case 'column':
      return toRings(truth.columns.flatMap(open));
    case 'facade':
      return toRings(open(truth.outer));
    case 'opening':
      return distanceToOpenings([x, y, z], truth);
    default:
      return Number.NaN;
  }
}

/** Distance beyond the box of the nearest opening: its jambs are half a wall from its axis. */
function distanceToOpenings([x, y, z]: readonly number[], { openings, floor, walls }: TruthStorey): number {
  return Math.min(
    ...openings.map(({ kind, seg: [from, to], z0, z1 }) => {
      const half = (kind === 'window' ? walls!.outer : walls!.inner) / 2;
      const aside = distanceToSegment(x, y, [from[0], from[1]], [to[0], to[1]]);
      return Math.max(0, aside - half, floor + z0 - z, z - floor - z1);
    }),
  );
}

describe('a scan and its truth', () => {
  let scene: Scene;
  const noise = 0.01;
  const perMetre = 100;
  beforeAll(() => {
    const pose = { heading: 0.4, unit: 'cm', offset: [30, -20, 5] } as const;
    scene = simulate({ name: 'a', building: columnRoomBuilding(4), scan: { ...few, noise }, pose });
  });

  it.each([
    ['column room', () => scene],
    [
      'home',
      () => simulate({ name: 'b', building: homeBuilding(7, { shape: 'U' }), scan: { ...few, noise } }),
    ],
  ])('%s: every point lies within four deviations of its surface', (_, make) => {
    const { positions, scan, truth } = make();
    if ('storeys' in truth) throw new Error('expected one storey');
    let judged = 0;
    for (let i = 0; i < scan.kinds.length; i++) {
      const distance = distanceToTruth(
        KINDS[scan.kinds[i]],
        [...positions.subarray(i * 3, i * 3 + 3)],
        truth,
      );
      if (Number.isNaN(distance)) continue;
      judged++;
      if (distance > truth.unit * noise * MAX_DEVIATIONS + 1e-6) {
        throw new Error(`${KINDS[scan.kinds[i]]} point ${i} is ${distance / truth.unit} m off`);
      }
    }
    expect(judged).toBeGreaterThan(0.7 * scan.kinds.length);
  });

  it('has all kinds of surfaces, and noise of the size asked for', () => {
    const { positions, scan, truth } = scene;
    if ('storeys' in truth) throw new Error('expected one storey');
    const count = (kind: Kind): number => scan.kinds.filter((k) => KINDS[k] === kind).length;
    for (const kind of ['wall', 'floor', 'ceiling', 'opening', 'column'] as const) {
      expect(count(kind), kind).toBeGreaterThan(30);
    }
    // Right above and below the scanner the ray is upright, so heights there show the whole noise.
    const [{ at }] = scan.stations;
    const errors: number[] = [];
    for (let i = 0; i < scan.kinds.length; i++) {
      const isNear = Math.hypot(scan.positions[i * 3] - at[0], scan.positions[i * 3 + 1] - at[1]) < 0.3;
      if (KINDS[scan.kinds[i]] === 'ceiling' && isNear) {
        errors.push((positions[i * 3 + 2] - truth.floor - truth.height) / perMetre);
      }
    }
    const rms = Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / errors.length);
    expect(errors.length).toBeGreaterThan(50);
    expect(rms).toBeGreaterThan(0.7 * noise);
    expect(rms).toBeLessThan(1.3 * noise);
  });

  it('keeps strays within their reach and share', () => {
    const building = homeBuilding(5);
    const { scan } = simulate({ name: 'c', building, scan: { ...few, strays: 0.01 } });
    const strays = [...scan.kinds.keys()].filter((i) => KINDS[scan.kinds[i]] === 'stray');
    expect(strays.length / scan.kinds.length).toBeCloseTo(0.01, 3);
    const xs = building.storeys[0].outer.map(([x]) => x);
    for (const i of strays) {
      expect(scan.positions[i * 3]).toBeGreaterThan(Math.min(...xs) - STRAY_REACH);
      expect(scan.positions[i * 3]).toBeLessThan(Math.max(...xs) + STRAY_REACH);
    }
  });

  it('keeps one point a cube', () => {
    const dense = simulate({ name: 'd', building: columnRoomBuilding(4), scan: { ...few, voxel: 0 } });
    const thin = simulate({ name: 'd', building: columnRoomBuilding(4), scan: { ...few, voxel: 0.1 } });
    expect(thin.scan.kinds.length).toBeLessThan(0.5 * dense.scan.kinds.length);
    expect(dense.scan.kinds.length).toBeGreaterThan(0.6 * dense.scan.stations.length * few.raysPerStation);
  });

  it('is the same for the same seed and another for another', () => {
    const scan = { ...few, raysPerStation: 3_000 };
    const make = (seed: number) =>
      simulate({ name: 'e', building: homeBuilding(6), scan: { ...scan, seed } });
    const [first, again, other] = [make(1), make(1), make(2)];
    expect(again.positions).toEqual(first.positions);
    expect(again.truth).toEqual(first.truth);
    expect(other.positions.subarray(0, 3)).not.toEqual(first.positions.subarray(0, 3));
  });

  it('tells which stretches of wall no ray met', () => {
    const closed = simulate({
      name: 'f',
      building: homeBuilding(8, { clutter: 0 }),
      scan: DEFAULT_SCAN,
    }).truth;
    const cluttered = simulate({
      name: 'f',
      building: homeBuilding(8, { clutter: 2 }),
      scan: { ...DEFAULT_SCAN, stationsPerRoom: 1 },
    }).truth;
    if ('storeys' in closed || 'storeys' in cluttered) throw new Error('expected one storey');
    expect(closed.hiddenShare).toBeLessThan(0.02);
    expect(cluttered.hiddenShare).toBeGreaterThan(closed.hiddenShare!);
    const rooms = cluttered.rooms.flatMap(open);
    for (const [from, to] of cluttered.hidden!) {
      const middle: XY = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
      expect(Math.min(...rooms.map((ring) => distanceToRing(ring, ...middle)))).toBeLessThan(1e-6);
    }
  });
});

describe('occlusion', () => {
  /** Where the level way from p to q crosses the edges of a ring, as shares of the way. */
  function crossings(p: XY, q: XY, ring: readonly XY[]): number[] {
    return ring.flatMap((a, i) => {
      const b = ring[(i + 1) % ring.length];
      const det = (q[0] - p[0]) * (b[1] - a[1]) - (q[1] - p[1]) * (b[0] - a[0]);
      const t = ((a[0] - p[0]) * (b[1] - a[1]) - (a[1] - p[1]) * (b[0] - a[0])) / det;
      const u = ((a[0] - p[0]) * (q[1] - p[1]) - (a[1] - p[1]) * (q[0] - p[0])) / det;
      return t > 1e-6 && t < 1 - 1e-6 && u >= 0 && u <= 1 ? [t] : [];
    });
  }

  const passes = ([x, y]: XY, z: number, openings: readonly Opening[]): boolean =>
    openings.some(
      (opening) =>
        contains(footprint(opening, 0.001), x, y) && z > opening.sill - 1e-6 && z < opening.head + 1e-6,
    );

  function blockedBy({ bottom, top, ring }: Prism, p: XY, q: XY, z: (t: number) => number): boolean {
    const cuts = crossings(p, q, ring).sort((a, b) => a - b);
    if (cuts.length < 2) return false;
    const [low, high] = [z(cuts[0]), z(cuts[1])].sort((a, b) => a - b);
    return low > bottom + 1e-6 && high < top - 1e-6;
  }

  function obstacle(storey: Storey, p: XY, q: XY, z: (t: number) => number): string | null {
    const along = (t: number): XY => [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t];
    for (const { ring } of storey.rooms) {
      if (crossings(p, q, ring).some((t) => !passes(along(t), z(t), storey.openings))) return 'wall';
    }
    if (storey.columns.some((ring) => crossings(p, q, ring).length > 0)) return 'column';
    return storey.furniture.some((prism) => blockedBy(prism, p, q, z)) ? 'furniture' : null;
  }

  it.each([
    ['static', DEFAULT_SCAN],
    ['mobile', MOBILE_SCAN],
  ])('%s: nothing lies between a point and the station that saw it', (_, pattern) => {
    const building = homeBuilding(9, { shape: 'L', clutter: 1.5 });
    const exact = { noise: 0, strays: 0, voxel: 0.08, raysPerStation: 8000 };
    const { scan } = simulate({ name: 'g', building, scan: { ...pattern, ...exact } });
    const { positions, station, stations } = scan;
    const rooms = new Set<string>();
    for (let i = 0; i < station.length; i++) {
      const { at, room } = stations[station[i]];
      const [x, y, z] = positions.subarray(i * 3, i * 3 + 3);
      const found = obstacle(building.storeys[0], [at[0], at[1]], [x, y], (t) => at[2] + (z - at[2]) * t);
      if (found) throw new Error(`point ${i} at ${[x, y, z]} is behind a ${found}`);
      const seen = building.storeys[0].rooms.findIndex(({ ring }) => contains(ring, x, y));
      if (seen >= 0) rooms.add(`${room}>${seen}`);
    }
    // Some looks go through doors into other rooms, else the test above would say little.
    expect([...rooms].some((pair) => pair.split('>')[0] !== pair.split('>')[1])).toBe(true);
    expect(station.length).toBeGreaterThan(20_000);
  });
});
