import { describe, expect, test } from 'vitest';
import { areaOf } from '../../../../src/core/geometry/areas.ts';
import { boundsOf, pointInPolygon } from '../../../../src/core/geometry/rings.ts';
import { createRandom } from '../../../../src/core/random.ts';
import type { Solid, SolidGroup } from '../../../../src/core/types.ts';
import { extrude } from '../../../../src/solid/extrude.ts';
import { makeSolid } from '../../../../src/solid/make-solid.ts';
import { sideColour, topColour } from '../../../../src/write/pictures/model-clay.ts';
import { type Eye, makeEye } from '../../../../src/write/pictures/model-eye.ts';
import { drawModel } from '../../../../src/write/pictures/model-picture.ts';
import { castShadow } from '../../../../src/write/pictures/model-shadow.ts';
import { type SolidSlab, slabsOf } from '../../../../src/write/pictures/solid-slabs.ts';
import {
  disc,
  type PlanFacts,
  planOf,
  rectangle,
  reversed,
  ring,
  secondary,
  wallAround,
} from '../../solid/plans.ts';
import { parseXml, type XmlElement } from '../drawing/strict-xml.ts';
import { home } from '../products.ts';

const hall = ring(0, 0, 9, 0, 9, 7, 5, 7, 5, 4, 0, 4);
const round = disc(3, 3, 3, 48);
const court = rectangle(0, 0, 10, 8);
const well = rectangle(3.5, 3, 2.5, 2);

const PLANS: Record<string, PlanFacts> = {
  home: home(),
  'a round room with a round shaft': {
    storeys: [
      {
        primary: [{ outer: round, holes: [] }],
        walls: [{ outline: wallAround(round, 0.3), thickness: 0.3, confidence: 1 }],
        secondary: [secondary(disc(3.4, 2.5, 0.8, 32), 'independent')],
      },
    ],
  },
  'a courtyard': {
    storeys: [
      {
        primary: [{ outer: court, holes: [reversed(well)] }],
        walls: [
          { outline: wallAround(court, 0.2), thickness: 0.2, confidence: 1 },
          {
            outline: { outer: well, holes: [reversed(rectangle(3.7, 3.2, 2.1, 1.6))] },
            thickness: 0.2,
            confidence: 1,
          },
        ],
      },
    ],
  },
  'solids that run into walls': {
    storeys: [
      {
        primary: [{ outer: hall, holes: [] }],
        walls: [{ outline: wallAround(hall, 0.4), thickness: 0.4, confidence: 1 }],
        secondary: [
          secondary(ring(-1, 1, 1.5, 0.4, 2, 2.5, -0.5, 3), 'independent'),
          secondary(rectangle(4, 3, 2, 2), 'independent'),
        ],
      },
    ],
  },
  'two storeys': {
    storeys: [
      {
        primary: [{ outer: hall, holes: [] }],
        walls: [{ outline: wallAround(hall, 0.2), thickness: 0.2, confidence: 1 }],
      },
      {
        index: 1,
        floor: 2.8,
        primary: [{ outer: rectangle(5, 0, 4, 7), holes: [] }],
        walls: [{ outline: wallAround(rectangle(5, 0, 4, 7), 0.2), thickness: 0.2, confidence: 1 }],
      },
    ],
  },
};

describe('hidden faces are hidden: what is painted last at a place is what a ray meets first', () => {
  test.each(Object.entries(PLANS))('%s', async (_, facts) => {
    const plan = planOf(facts);
    const solid = await makeSolid(plan, plan.options);
    expectTruePicture(solid, drawModel({ solid })!.items);
  });

  test('a wall with a doorway, whose lintel hides less than the wall', () => {
    const solid = gate();
    expectTruePicture(solid, drawModel({ solid })!.items);
  });
});

test('what is cut out of the floor shows dashed through the walls', async () => {
  const wall = { outline: wallAround(hall, 0.2), thickness: 0.2, confidence: 1 };
  const room = { primary: [{ outer: hall, holes: [] }], walls: [wall] };
  const drawn = async (facts: PlanFacts) => {
    const plan = planOf(facts);
    const solid = await makeSolid(plan, plan.options);
    const dashed = drawModel({ solid })!.items.filter((item) => item.includes('stroke-dasharray'));
    return { eye: makeEye(solid, 0), lines: dashed.flatMap(strokesOf) };
  };
  const shaft = rectangle(4, 0.4, 1, 1);
  const { eye, lines } = await drawn({ storeys: [{ ...room, secondary: [secondary(shaft, 'subtract')] }] });
  expect(lines).toHaveLength(1);
  const rounded = (xy: ArrayLike<number>) => Array.from(xy, (value) => value.toFixed(1)).sort();
  expect(rounded(lines[0])).toEqual(rounded(eye.map(shaft, 0)));
  expect((await drawn({ storeys: [room] })).lines).toEqual([]);
});

test('a slab has the whole section, without the triangulation', () => {
  const [jambs, lintel] = slabsOf(gate());
  expect(jambs.sections[0].rings.map((section) => section.length / 2)).toEqual([4, 4]);
  expect(lintel.sections[0].rings.map((section) => section.length / 2)).toEqual([4]);
  expect(lintel.tops[0].rings.map((top) => top.length / 2)).toEqual([4]);
  expect(jambs.tops).toEqual([]);
});

test('a wall over a doorway has a line where its face ends, none where it goes on', () => {
  const { items } = drawModel({ solid: gate() })!;
  const lines = items.flatMap(strokesOf);
  const eye = makeEye(gate(), 0);
  const at = (x: number) => eye.map([x, 0], 2);
  const isDrawn = ([ax, ay]: Float64Array, [bx, by]: Float64Array): boolean =>
    lines.some(
      ([px, py, qx, qy]) => Math.hypot(px - ax, py - ay) < 0.05 && Math.hypot(qx - bx, qy - by) < 0.05,
    );
  expect(isDrawn(at(2), at(3))).toBe(true);
  expect(isDrawn(at(0), at(5))).toBe(false);
  expect(isDrawn(at(0), at(2))).toBe(false);
});

/** A wall of 5 m × 0.3 m × 2.6 m with a doorway of 1 m × 2 m: two jambs under a lintel in one group. */
function gate(): Solid {
  const parts = [
    extrude({ outer: rectangle(0, 0, 2, 0.3), holes: [] }, 0, 2),
    extrude({ outer: rectangle(3, 0, 2, 0.3), holes: [] }, 0, 2),
    extrude({ outer: rectangle(0, 0, 5, 0.3), holes: [] }, 2, 2.6),
  ];
  const positions: number[] = [];
  const indices: number[] = [];
  for (const part of parts) {
    const first = positions.length / 3;
    positions.push(...part.positions);
    // Jambs and lintel share their faces: only the lintel's over the doorway is left.
    for (let t = 0; t < part.indices.length; t += 3) {
      const corners = [...part.indices.subarray(t, t + 3)];
      const isInner = corners.every((corner) => part.positions[3 * corner + 2] === 2);
      if (!isInner) indices.push(...corners.map((corner) => first + corner));
    }
  }
  // The underside of the lintel, looking down.
  const soffit = positions.length / 3;
  positions.push(2, 0, 2, 3, 0, 2, 3, 0.3, 2, 2, 0.3, 2);
  indices.push(soffit, soffit + 2, soffit + 1, soffit, soffit + 3, soffit + 2);
  const group: SolidGroup = { name: 'wall-0', kind: 'wall', storey: 0, start: 0, count: indices.length };
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices), groups: [group] };
}

/** Places looked at on a picture; nearer than this to an edge, px, the pictures may differ. */
const PLACES = 3000;
const NEAR = 0.8;

function expectTruePicture(solid: Solid, items: readonly string[]): void {
  const eye = makeEye(solid, 0);
  const triangles = project(solid, eye);
  const painted = items.flatMap(fillsOf);
  const random = createRandom(7);
  let looked = 0;
  for (let place = 0; place < PLACES; place++) {
    const [x, y] = [24 + 592 * random(), 24 + eye.height * random()];
    const met = triangles.filter((triangle) => place2d(triangle.corners, x, y) > -NEAR);
    if (met.some((triangle) => Math.abs(place2d(triangle.corners, x, y)) < NEAR)) continue;
    const nearest = Math.max(...met.map((triangle) => triangle.depthAt(x, y)));
    // Where two solids end at the same height either may show.
    const seen = met
      .filter((triangle) => triangle.depthAt(x, y) > nearest - 1e-6)
      .map(({ colour }) => colour);
    const last = painted.findLast(({ rings }) => isInside(rings, x, y))?.fill;
    expect(seen.length === 0 ? [undefined] : seen, `at ${x.toFixed(1)}, ${y.toFixed(1)}`).toContain(last);
    if (last !== undefined) looked++;
  }
  expect(looked).toBeGreaterThan(PLACES / 20);
}

interface Triangle {
  /** x, y a corner, px. */
  readonly corners: readonly number[];
  readonly colour: string;
  depthAt(x: number, y: number): number;
}

function project({ positions, indices, groups }: Solid, eye: Eye): Triangle[] {
  return groups.flatMap(({ kind, start, count }) =>
    Array.from({ length: count / 3 }, (_, t) => {
      const vertices = [0, 1, 2].map((k) => {
        const at = 3 * indices[start + 3 * t + k];
        return [positions[at], positions[at + 1], positions[at + 2]] as const;
      });
      const corners = vertices.flatMap(([x, y, z]) => [...eye.map([x, y], z)]);
      const depths = vertices.map(
        ([x, y, z]) =>
          Math.cos(eye.elevation) * (eye.towards[0] * x + eye.towards[1] * y) + Math.sin(eye.elevation) * z,
      );
      const [a, b, c] = vertices;
      const normal = cross(minus(b, a), minus(c, a));
      const flat = Math.hypot(normal[0], normal[1]);
      const isSide = flat > Math.abs(normal[2]);
      const colour = isSide
        ? sideColour(kind, [normal[0] / flat, normal[1] / flat], eye.light)
        : topColour(kind);
      return { corners, colour, depthAt: (x: number, y: number) => interpolate(corners, depths, x, y) };
    }),
  );
}

type Vector = readonly [x: number, y: number, z: number];
const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = ([a, b, c]: Vector, [p, q, r]: Vector): Vector => [b * r - c * q, c * p - a * r, a * q - b * p];

/** Distance of a place from the triangle's edges, px; positive inside; far outside where the triangle is edge-on. */
function place2d([ax, ay, bx, by, cx, cy]: readonly number[], x: number, y: number): number {
  const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  if (Math.abs(area) < 1e-9) return -Infinity;
  const side = (px: number, py: number, qx: number, qy: number): number =>
    (Math.sign(area) * ((qx - px) * (y - py) - (x - px) * (qy - py))) / Math.hypot(qx - px, qy - py);
  return Math.min(side(ax, ay, bx, by), side(bx, by, cx, cy), side(cx, cy, ax, ay));
}

function interpolate(
  [ax, ay, bx, by, cx, cy]: readonly number[],
  depths: readonly number[],
  x: number,
  y: number,
): number {
  const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  const b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
  const c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
  return depths[0] * (1 - b - c) + depths[1] * b + depths[2] * c;
}

interface Fill {
  readonly fill: string;
  readonly rings: readonly (readonly number[])[];
}

/** Opaque areas of a mark; shadows let the face beneath through. */
function fillsOf(mark: string): Fill[] {
  const found = parseXml(mark);
  const fill = found.getAttribute('fill')!;
  return fill === 'none' || found.hasAttribute('fill-opacity') ? [] : [{ fill, rings: linesOf(found) }];
}

function strokesOf(mark: string): (readonly number[])[] {
  const found = parseXml(mark);
  return found.getAttribute('fill') === 'none' ? linesOf(found) : [];
}

/** Rings and lines of a path that knows M, l and z only. */
function linesOf(path: XmlElement): number[][] {
  return path
    .getAttribute('d')!
    .split('M')
    .slice(1)
    .map((part) => {
      const numbers = part.match(/-?(\d+\.?\d*|\.\d+)/g)!.map(Number);
      return numbers.map((_, i) =>
        numbers.slice(0, i + 1).reduce((sum, value, k) => (k % 2 === i % 2 ? sum + value : sum), 0),
      );
    });
}

function isInside(rings: readonly (readonly number[])[], x: number, y: number): boolean {
  let inside = false;
  for (const line of rings) {
    for (let i = 0, j = line.length - 2; i < line.length; j = i, i += 2) {
      const [ax, ay, bx, by] = [line[j], line[j + 1], line[i], line[i + 1]];
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
    }
  }
  return inside;
}

describe('castShadow', () => {
  const ground = [rectangle(-20, -20, 40, 40)];
  const slabOf = (rings: Float64Array[], low: number, high: number): SolidSlab => ({
    low,
    high,
    sections: [{ group: { name: 'wall-0', kind: 'wall', storey: 0, start: 0, count: 0 }, rings }],
    tops: [],
  });

  test('of a column is its section swept as far as its height throws it', () => {
    const column = slabOf([rectangle(0, 0, 1, 1)], 0, 2);
    expect(areaOf(castShadow(ground, 0, [column], [0.5, 0]))).toBeCloseTo(2, 9);
    const beam = slabOf([rectangle(0, 0, 1, 1)], 4, 6);
    const [shadow] = castShadow(ground, 0, [beam], [0.5, 0]);
    expect(boundsOf(shadow.outer)).toEqual({ minX: 2, minY: 0, maxX: 4, maxY: 1 });
  });

  test('falls on the ground alone, and from nothing beneath it', () => {
    const column = slabOf([rectangle(0, 0, 1, 1)], 0, 2);
    expect(areaOf(castShadow([rectangle(0, 0, 1.5, 1)], 0, [column], [0.5, 0]))).toBeCloseTo(1.5, 9);
    expect(castShadow(ground, 1, [column], [0.5, 0])).toEqual([]);
  });

  test('a place lies in it where the way to the light meets the wall', () => {
    const { outer, holes } = wallAround(hall, 0.3);
    const light = [0.4, 0.7] as const;
    const shadow = castShadow(ground, 0, [slabOf([outer, ...holes], 0, 2.5)], light);
    const random = createRandom(3);
    let wrong = 0;
    for (let k = 0; k < 2000; k++) {
      const [x, y] = [-1 + 12 * random(), -1 + 10 * random()];
      const isDark = shadow.some((polygon) => pointInPolygon(x, y, polygon) > 0);
      const heights = Array.from({ length: 400 }, (_, i) => (2.5 * i) / 399);
      const meets = heights.some(
        (h) => pointInPolygon(x - light[0] * h, y - light[1] * h, { outer, holes }) > 0,
      );
      if (isDark !== meets) wrong++;
    }
    // Steps towards the light may pass over a corner.
    expect(wrong).toBeLessThanOrEqual(4);
  });
});

test('vertices that Boolean operations leave on upright faces cut no slabs', () => {
  const box = extrude({ outer: rectangle(0, 0, 4, 3), holes: [] }, 0, 2.5);
  // A side's upper triangle becomes two at a vertex halfway up one of its edges.
  const [a, b] = firstUprightEdge(box);
  const middle = [0, 1, 2].map((k) => (box.positions[3 * a + k] + box.positions[3 * b + k]) / 2);
  const added = box.positions.length / 3;
  const triangles: number[] = [];
  for (let at = 0; at < box.indices.length; at += 3) {
    const corners = [...box.indices.subarray(at, at + 3)];
    const edge = corners.findIndex((from, k) => isBetween([from, corners[(k + 1) % 3]], a, b));
    if (edge < 0) triangles.push(...corners);
    else {
      const [from, to, apex] = [0, 1, 2].map((k) => corners[(edge + k) % 3]);
      triangles.push(from, added, apex, added, to, apex);
    }
  }
  const solid: Solid = {
    positions: Float64Array.of(...box.positions, ...middle),
    indices: Uint32Array.from(triangles),
    groups: [{ name: 'wall-0', kind: 'wall', storey: 0, start: 0, count: triangles.length }],
  };
  const slabs = slabsOf(solid);
  expect(slabs.map(({ low, high }) => [low, high])).toEqual([[0, 2.5]]);
  expect(slabs[0].sections[0].rings).toHaveLength(1);
});

function firstUprightEdge({ positions, indices }: { positions: Float64Array; indices: Uint32Array }) {
  for (let at = 0; at < indices.length; at++) {
    const [a, b] = [indices[at], indices[at - (at % 3) + ((at + 1) % 3)]];
    const isUpright = [0, 1].every((k) => positions[3 * a + k] === positions[3 * b + k]);
    if (isUpright) return [a, b] as const;
  }
  throw new Error('expected an upright edge');
}

function isBetween([from, to]: readonly [number, number], a: number, b: number): boolean {
  return (from === a && to === b) || (from === b && to === a);
}
