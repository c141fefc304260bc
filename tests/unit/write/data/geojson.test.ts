import { expect, test } from 'vitest';
import { isSimpleRing } from '../../../../src/core/geometry/simplicity.ts';
import type { Storey } from '../../../../src/core/types.ts';
import { writeGeoJson } from '../../../../src/write/data/geojson.ts';
import { type PlanFacts, rectangle, reversed, ring, secondary } from '../../solid/plans.ts';
import { productOf } from '../products.ts';

interface Feature {
  readonly type: string;
  readonly geometry: { readonly type: string; readonly coordinates: number[][][] };
  readonly properties: Readonly<Record<string, unknown>>;
}

async function featuresOf(facts: PlanFacts): Promise<Feature[]> {
  const collection = JSON.parse(writeGeoJson(await productOf(facts))) as {
    type: string;
    features: Feature[];
  };
  expect(collection.type).toBe('FeatureCollection');
  return collection.features;
}

/** Twice the signed area. */
const turn = (positions: number[][]): number =>
  positions.slice(1).reduce((sum, [x, y], i) => sum + positions[i][0] * y - x * positions[i][1], 0);

const everything: Partial<Storey> = {
  secondary: [secondary(rectangle(1, 1, 0.5, 0.5), 'add')],
  rooms: [
    {
      name: 'Küche "1"',
      outline: { outer: rectangle(0, 0, 4, 3), holes: [] },
      height: 2.45,
      confidence: 0.9,
    },
  ],
  openings: [{ type: 'door', from: [1, 0], to: [1.9, 0], sill: 0, head: 2.1, confidence: 0.9 }],
};

test('every kind has the geometry and the properties of the contract', async () => {
  const features = await featuresOf({ storeys: [everything] });
  expect(features.map(({ geometry, properties }) => [geometry.type, properties])).toEqual([
    ['Polygon', { kind: 'primary-boundary', storey: 0, areaM2: 12 }],
    ['Polygon', { kind: 'secondary-boundary', storey: 0, operation: 'add', type: 'column' }],
    ['Polygon', { kind: 'room', storey: 0, name: 'Küche "1"', areaM2: 12, heightM: 2.45, confidence: 0.9 }],
    ['Polygon', { kind: 'wall', storey: 0, thicknessM: 0.2, confidence: 1 }],
    [
      'LineString',
      { kind: 'opening', storey: 0, type: 'door', widthM: 0.9, sillM: 0, headM: 2.1, confidence: 0.9 },
    ],
  ]);
  expect(features.every(({ type }) => type === 'Feature')).toBe(true);
});

test('a stretch that no point supports tells its length, and the room it is of where there are rooms', async () => {
  const gaps = [
    { from: [1, 0], to: [2.5, 0], width: 1.5, room: 'Room 2' },
    { from: [0, 1], to: [0, 2], width: 1 },
  ] as const;
  const features = await featuresOf({ storeys: [{ ...everything, gaps }] });
  const stretches = features.filter(({ properties }) => properties.kind === 'inferred-stretch');
  expect(stretches.map(({ geometry, properties }) => [geometry, properties])).toEqual([
    [
      {
        type: 'LineString',
        coordinates: [
          [1, 0],
          [2.5, 0],
        ],
      },
      { kind: 'inferred-stretch', storey: 0, lengthM: 1.5, room: 'Room 2' },
    ],
    [
      {
        type: 'LineString',
        coordinates: [
          [0, 1],
          [0, 2],
        ],
      },
      { kind: 'inferred-stretch', storey: 0, lengthM: 1 },
    ],
  ]);
});

test('rings are closed, outer ones counter-clockwise, holes clockwise, however they came', async () => {
  const primary = [{ outer: reversed(rectangle(0, 0, 4, 3)), holes: [rectangle(1, 1, 1, 1)] }];
  const [{ geometry }] = await featuresOf({ storeys: [{ primary }] });
  for (const positions of geometry.coordinates) expect(positions.at(-1)).toEqual(positions[0]);
  expect(geometry.coordinates.map((positions) => Math.sign(turn(positions)))).toEqual([1, -1]);
});

test('a UTM scan gives UTM coordinates to a tenth of a millimetre', async () => {
  const primary = [{ outer: ring(0, 0, 4.1234, 0.0001, 4.1235, 3, 0, 3.00006), holes: [] }];
  const frame = { planOrigin: [691_000.1234, 5_334_000.4321, 512.5] as const };
  const [{ geometry }] = await featuresOf({ storeys: [{ primary }], frame });
  expect(geometry.coordinates[0].slice(0, 4)).toEqual([
    [691_000.1234, 5_334_000.4321],
    [691_004.2468, 5_334_000.4322],
    [691_004.2469, 5_334_003.4321],
    [691_000.1234, 5_334_003.4322],
  ]);
});

test.each([
  ['mm', 0.001, [1000, 2000], [5000, 5000]],
  ['ft', 0.3048, [10, 20], [23.1234, 29.8425]],
  ['px', 0.01, [0, 0], [400, 300]],
] as const)('source units: %s', async (unit, metresPerUnit, [x, y], corner) => {
  const frame = { unit, metresPerUnit, planOrigin: [x, y, 0] as const };
  const [{ geometry, properties }] = await featuresOf({ frame });
  expect(geometry.coordinates[0][2]).toEqual(corner);
  expect(properties.areaM2).toBe(12);
});

test('vertices that rounding makes one are written once', async () => {
  const primary = [{ outer: ring(0, 0, 4, 0, 4, 0.00001, 4, 3, 0, 3, 0.00001, 0.00001), holes: [] }];
  const [{ geometry }] = await featuresOf({ storeys: [{ primary }] });
  expect(geometry.coordinates[0]).toHaveLength(5);
});

test('all storeys are in one file', async () => {
  const features = await featuresOf({ storeys: [{}, {}] });
  expect(features.map(({ properties }) => properties.storey)).toEqual([0, 0, 1, 1]);
});

test('rings stay simple when rounded to 0.1 mm', async () => {
  // A dent whose tip ends 20 µm before the edge across; rounded, it lies on that edge.
  const dented = ring(0, 0, 10, 3.00002, 10, 8, 6, 8, 5, 1.50003, 4, 8, 0, 8);
  const features = await featuresOf({ storeys: [{ primary: [{ outer: dented, holes: [] }] }] });
  const primary = features.filter(({ properties }) => properties.kind === 'primary-boundary');
  expect(primary).toHaveLength(2);
  for (const { geometry } of primary) {
    expect(geometry.coordinates).toHaveLength(1);
    expect(isSimpleRing(Float64Array.from(geometry.coordinates[0].slice(1).flat()))).toBe(true);
  }
  const areas = primary.map(({ properties }) => Number(properties.areaM2));
  expect(areas[0] + areas[1]).toBeCloseTo(58.5, 2);
});

test('a sliver that rounding turns over is written counter-clockwise all the same', async () => {
  const sliver = ring(0, 0, 1, 0.00006, 2, 0.00013);
  const features = await featuresOf({ storeys: [{ primary: [{ outer: sliver, holes: [] }], walls: [] }] });
  expect(turn(features[0].geometry.coordinates[0])).toBeGreaterThan(0);
});

test('what is thinner than a step of the file is left out', async () => {
  const hair = ring(0, 0, 1, 0.00001, 2, 0, 2, 0.00003, 1, 0.00002);
  const features = await featuresOf({ storeys: [{ primary: [{ outer: hair, holes: [] }], walls: [] }] });
  expect(features).toEqual([]);
});
