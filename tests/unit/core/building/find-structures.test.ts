import { describe, expect, it } from 'vitest';
import { type Random, seededRandom } from '../../../../fixtures/simulator/random.ts';
import { heightColumns } from '../../../../src/core/building/columns/height-columns.ts';
import { localCeiling } from '../../../../src/core/building/columns/local-ceiling.ts';
import { findStructures } from '../../../../src/core/building/structures/find-structures.ts';
import { structureShape } from '../../../../src/core/building/structures/structure-shape.ts';
import { areaOf, combine } from '../../../../src/core/geometry/areas.ts';
import { pointInRing, signedArea } from '../../../../src/core/geometry/rings.ts';
import type { Ring, SecondaryBoundary } from '../../../../src/core/types.ts';
import { makeCloud } from '../made-scan.ts';

const HEIGHT = 2.6;
const NOISE = 0.008;
const STEP = 0.025;
const ROOM = Float64Array.of(0, 0, 6, 0, 6, 5, 0, 5);

const rectangle = (x: number, y: number, width: number, depth: number): Ring =>
  Float64Array.of(x, y, x + width, y, x + width, y + depth, x, y + depth);

/** What stands in the room: the faces that were seen, its height, and where it hides floor and ceiling. */
interface Thing {
  readonly ring: Ring;
  readonly seen?: readonly number[];
  readonly top?: number;
  /** Floor and ceiling behind it that nobody saw. */
  readonly shadow?: Ring;
}

function roomWith(things: readonly Thing[]): SecondaryBoundary[] {
  const random = seededRandom(5, 'structures');
  const xyz: number[] = [];
  const isIn = (ring: Ring, x: number, y: number) => pointInRing(x, y, ring) > 0;
  for (let x = STEP / 2; x < 6; x += STEP) {
    for (let y = STEP / 2; y < 5; y += STEP) {
      if (things.some(({ ring, shadow }) => isIn(ring, x, y) || (shadow && isIn(shadow, x, y)))) {
        const over = things.find(({ ring }) => isIn(ring, x, y));
        if (over?.top !== undefined) xyz.push(x, y, HEIGHT + NOISE * random.normal());
        continue;
      }
      xyz.push(x, y, NOISE * random.normal(), x, y, HEIGHT + NOISE * random.normal());
    }
  }
  faces(ROOM, [0, 1, 2, 3], HEIGHT, random, xyz);
  for (const { ring, seen, top } of things)
    faces(ring, seen ?? [...Array(ring.length / 2).keys()], top ?? HEIGHT, random, xyz);
  const cloud = makeCloud(xyz, { floor: 0, ceiling: HEIGHT });
  const kept = Uint32Array.from({ length: xyz.length / 3 }, (_, i) => i);
  const columns = heightColumns(cloud, kept, { floor: 0, ceiling: HEIGHT });
  const site = { cloud, columns, noise: NOISE };
  return findStructures(site, localCeiling(columns), [{ outer: ROOM, holes: [] }]);
}

function faces(ring: Ring, edges: readonly number[], top: number, random: Random, xyz: number[]): void {
  for (const e of edges) {
    const [i, j] = [2 * e, (2 * e + 2) % ring.length];
    const [dx, dy] = [ring[j] - ring[i], ring[j + 1] - ring[i + 1]];
    const length = Math.hypot(dx, dy);
    for (let along = STEP / 2; along < length; along += STEP) {
      for (let z = 0; z < top; z += STEP) {
        const [t, out] = [along / length, NOISE * random.normal()];
        xyz.push(ring[i] + t * dx + (out * dy) / length, ring[i + 1] + t * dy - (out * dx) / length, z);
      }
    }
  }
}

function overlapOf({ outline }: SecondaryBoundary, ring: Ring): number {
  const truth = [{ outer: ring, holes: [] }];
  const shared = areaOf(combine('intersection', [outline], truth));
  return shared / (areaOf([outline]) + areaOf(truth) - shared);
}

const circle = (x: number, y: number, radius: number): Ring =>
  Float64Array.from({ length: 48 }, (_, i) => {
    const angle = (2 * Math.PI * (i >> 1)) / 24;
    return i % 2 === 0 ? x + radius * Math.cos(angle) : y + radius * Math.sin(angle);
  });

describe('columns and shafts', () => {
  it('are found as the circles and rectangles they are', () => {
    const rings = [rectangle(1, 1, 0.3, 0.3), circle(3.5, 2.5, 0.2), rectangle(4.5, 1, 0.8, 0.6)];
    const found = roomWith(rings.map((ring) => ({ ring })));
    expect(found).toHaveLength(3);
    for (const ring of rings)
      expect(Math.max(...found.map((one) => overlapOf(one, ring)))).toBeGreaterThan(0.9);
    const [round, ...others] = found.flatMap(({ outline }) => outline.arcs ?? []);
    expect(others).toHaveLength(0);
    expect(round).toMatchObject({ ring: 0, from: 0, to: 0 });
    expect(Math.abs(round.radius - 0.2)).toBeLessThan(0.01);
  });

  it('are taken for square where one face was seen and nothing behind it', () => {
    const ring = rectangle(2.5, 2, 0.4, 0.4);
    const found = roomWith([{ ring, seen: [0], shadow: rectangle(2.3, 2.4, 0.8, 2.6) }]);
    expect(found).toHaveLength(1);
    expect(overlapOf(found[0], ring)).toBeGreaterThan(0.85);
  });

  it('are whole circles where half of one was seen', () => {
    const ring = circle(3, 2, 0.25);
    const half = [...Array(24).keys()].filter((i) => i >= 12);
    const found = roomWith([{ ring, seen: half, shadow: rectangle(2.7, 2, 0.6, 3) }]);
    expect(found).toHaveLength(1);
    expect(overlapOf(found[0], ring)).toBeGreaterThan(0.85);
  });

  it('are found in one piece where two opposite faces were seen', () => {
    const ring = rectangle(2.5, 2, 0.6, 0.6);
    const found = roomWith([{ ring, seen: [0, 2] }]);
    expect(found).toHaveLength(1);
    expect(overlapOf(found[0], ring)).toBeGreaterThan(0.85);
  });
});

describe('no columns are', () => {
  it('cupboards over which the ceiling goes on', () => {
    expect(roomWith([{ ring: rectangle(2, 2, 0.8, 0.5), top: HEIGHT - 0.05 }])).toEqual([]);
  });

  it('bays of a wall', () => {
    expect(roomWith([{ ring: rectangle(2, 0, 0.5, 0.4), seen: [1, 2, 3] }])).toEqual([]);
  });

  it('the front of a bay whose sides nobody saw', () => {
    expect(roomWith([{ ring: rectangle(2, 0, 0.5, 0.4), seen: [2] }])).toEqual([]);
  });

  it('walls that stand in a room', () => {
    expect(roomWith([{ ring: rectangle(2, 2, 2, 0.12) }])).toEqual([]);
    expect(roomWith([{ ring: rectangle(2, 2, 0.8, 0.1) }])).toEqual([]);
  });
});

it('noise does not widen a shape', () => {
  const random = seededRandom(6, 'noise');
  const xy = Float64Array.from({ length: 4000 }, () => 0);
  for (let i = 0; i < 2000; i++) {
    const [along, out] = [random.between(-0.2, 0.2), 0.2 + 0.02 * random.normal()];
    const [x, y] = [
      [along, out],
      [along, -out],
      [out, along],
      [-out, along],
    ][i % 4];
    xy.set([x, y], 2 * i);
  }
  const { outline, rectangle: sides } = structureShape(xy, 0.02)!;
  expect(sides).not.toBeNull();
  expect(Math.sqrt(signedArea(outline))).toBeCloseTo(0.4, 1.7);
});
