import { describe, expect, it } from 'vitest';
import { rectangle, type XY } from '../../fixtures/simulator/ring.ts';
import type { Truth } from '../../fixtures/simulator/truth.ts';
import type { PlanFile } from './facts.ts';
import { measurePlan } from './measure.ts';
import { meanOfScenes } from './measures.ts';

const closed = (ring: readonly XY[]): number[][] => [...ring, ring[0]].map(([x, y]) => [x, y]);

/** Two rooms of 4 m × 5 m beside each other, 0.2 m apart, a column in the first, a door between them. */
const truth = {
  rooms: [[closed(rectangle(0, 0, 4, 5))], [closed(rectangle(4.2, 0, 4, 5))]],
  interior_outline: [closed(rectangle(0, 0, 8.2, 5))],
  outer: [closed(rectangle(-0.3, -0.3, 8.8, 5.6))],
  columns: [[closed(rectangle(1, 1, 0.5, 0.5))]],
  openings: [
    {
      kind: 'door',
      seg: [
        [4.1, 1],
        [4.1, 1.9],
      ],
      z0: 0,
      z1: 2.05,
    },
    {
      kind: 'window',
      seg: [
        [1, -0.15],
        [2, -0.15],
      ],
      z0: 0.9,
      z1: 2.1,
    },
  ],
  height: 2.5,
  floor: 0,
  name: 'two rooms',
  up: 'z',
  unit: 1,
  plan_axes: 'x,y',
  points: 0,
} as const satisfies Truth;

interface Wanted {
  readonly primary?: readonly XY[];
  readonly rooms?: readonly (readonly XY[])[];
  readonly structures?: readonly (readonly XY[])[];
  readonly openings?: readonly { type: string; line: number[][]; sillM: number; headM: number }[];
}

function plan({ primary, rooms = [], structures = [], openings = [] }: Wanted, storey = 0): PlanFile {
  const polygon = (kind: string) => (ring: readonly XY[]) => ({
    geometry: { type: 'Polygon', coordinates: [closed(ring)] },
    properties: { kind, storey, heightM: 2.55 },
  });
  const lines = openings.map(({ type, line, sillM, headM }) => ({
    geometry: { type: 'LineString', coordinates: line },
    properties: { kind: 'opening', storey, type, sillM, headM },
  }));
  return {
    features: [
      ...(primary ? [primary] : []).map(polygon('primary-boundary')),
      ...rooms.map(polygon('room')),
      ...structures.map(polygon('secondary-boundary')),
      ...lines,
    ],
  };
}

describe('measurePlan, by hand', () => {
  it('footprint: a boundary 1 m too long', () => {
    const found = measurePlan(plan({ primary: rectangle(0, 0, 9.2, 5) }), truth);
    expect(found.footprintIou).toBeCloseTo(41 / 46, 9);
    expect(found.footprintAreaErrorPct).toBeCloseTo((100 * 5) / 41, 6);
    // Of 568 samples the 100 of the far side lie 1 m off, the 40 on the way there 0 to 1 m.
    expect(found.footprintP95).toBeCloseTo(1, 9);
    expect(found.boundaryVertices).toBe(4);
    expect(found.valid).toBe(1);
  });

  it('footprint: holes do not count, crossing rings do', () => {
    const withHole: PlanFile = {
      features: [
        {
          geometry: {
            type: 'Polygon',
            coordinates: [closed(rectangle(0, 0, 8.2, 5)), closed([...rectangle(1, 1, 2, 2)].reverse())],
          },
          properties: { kind: 'primary-boundary', storey: 0 },
        },
      ],
    };
    expect(measurePlan(withHole, truth)).toMatchObject({
      footprintIou: 1,
      footprintAreaErrorPct: 0,
      valid: 1,
    });
    const bowTie = plan({
      primary: [
        [0, 0],
        [8, 5],
        [8, 0],
        [0, 5],
      ],
    });
    expect(measurePlan(bowTie, truth).valid).toBe(0);
  });

  it('rooms: one right, one merged away, one too many', () => {
    const rooms = [rectangle(0, 0, 4, 4), rectangle(20, 0, 2, 2), rectangle(30, 0, 2, 2)];
    const found = measurePlan(plan({ rooms }), truth);
    expect(found.roomPrecision).toBeCloseTo(1 / 3, 12);
    expect(found.roomRecall).toBeCloseTo(1 / 2, 12);
    expect(found.roomF1).toBeCloseTo(0.4, 12);
    expect(found.roomIou).toBeCloseTo(0.8, 9);
    expect(found.roomAreaErrorPct).toBeCloseTo(20, 9);
    expect(found.roomHeightErrorMm).toBeCloseTo(50, 9);
  });

  it('rooms: one that shares more than 5 % of itself with another is not right', () => {
    const rooms = [rectangle(0, 0, 4.4, 5), rectangle(4, 0, 4.2, 5)];
    const found = measurePlan(plan({ rooms }), truth);
    expect(found.roomF1).toBe(0);
    expect(found.roomIou).toBe(0);
    expect(found.roomAreaErrorPct).toBeUndefined();
    expect(found.roomOverlapM2).toBeCloseTo(2, 9);
  });

  it('corners: two of four within 5 cm, all within 10 cm; a vertex on a wall is none', () => {
    const room: XY[] = [
      [0, 0],
      [2, 0],
      [4.08, 0],
      [4.08, 5],
      [0, 5],
    ];
    const found = measurePlan(plan({ rooms: [room] }), truth);
    const f1 = (right: number): number => (2 * (right / 4) * (right / 8)) / (right / 4 + right / 8);
    expect(found.cornerF1At5cm).toBeCloseTo(f1(2), 12);
    expect(found.cornerF1At10cm).toBeCloseTo(f1(4), 12);
    expect(found.cornerF1At20cm).toBeCloseTo(f1(4), 12);
    expect(found.cornerF1At30cm).toBeCloseTo(f1(4), 12);
  });

  it('faces: one room 3 cm too small all round', () => {
    const found = measurePlan(plan({ rooms: [rectangle(0.03, 0.03, 3.94, 4.94)] }), truth);
    expect(found.faceMedianMm).toBeCloseTo(30, 6);
    expect(found.faceCorrectness).toBe(1);
    // The second room is 0.2 m away at its near side, so none of it is found.
    expect(found.faceCompleteness).toBeCloseTo(0.5, 12);
  });

  it('structures: one right, one false', () => {
    const structures = [rectangle(1, 1, 0.5, 0.4), rectangle(6, 2, 0.3, 0.3)];
    const found = measurePlan(plan({ structures }), truth);
    expect(found).toMatchObject({ structuresFound: 2, structuresTrue: 1, structuresMatched: 1 });
    expect(found.structureF1).toBeCloseTo(2 / 3, 12);
  });

  it('openings: by kind, place, width, sill and head', () => {
    const openings = [
      {
        type: 'door',
        line: [
          [4.1, 1.1],
          [4.1, 1.9],
        ],
        sillM: 0,
        headM: 2,
      },
      {
        type: 'door',
        line: [
          [0, 3],
          [0, 4],
        ],
        sillM: 0,
        headM: 2,
      },
      {
        type: 'passage',
        line: [
          [1, 0],
          [2, 0],
        ],
        sillM: 0,
        headM: 2.5,
      },
    ];
    const found = measurePlan(plan({ openings }), truth);
    expect(found.doorF1).toBeCloseTo(2 / 3, 12);
    expect(found.doorWidthErrorMm).toBeCloseTo(100, 6);
    expect(found.doorHeadErrorMm).toBeCloseTo(50, 6);
    expect(found.windowF1).toBe(0);
    expect(found.windowWidthErrorMm).toBeUndefined();
    expect(found.passageF1).toBe(0);
  });

  it('counts what is not valid: a crossing ring and a pair of rooms that overlap', () => {
    const apart = plan({ rooms: [rectangle(0, 0, 4, 5), rectangle(4, 0, 4, 5)] });
    expect(measurePlan(apart, truth).invalidCount).toBe(0);
    const bowTie: XY[] = [
      [0, 0],
      [8, 5],
      [8, 0],
      [0, 5],
    ];
    const rooms = [rectangle(0, 0, 4.01, 5), rectangle(4, 0, 4, 5)];
    expect(measurePlan(plan({ primary: bowTie, rooms }), truth).invalidCount).toBe(2);
  });

  it('ISPRS accuracy: only faces within 10 cm count', () => {
    const rooms = [rectangle(0.04, 0.04, 3.92, 4.92), rectangle(20, 20, 9, 9)];
    const found = measurePlan(plan({ rooms }), truth);
    expect(found.isprsAccuracyMm).toBeCloseTo(40, 6);
    expect(found.faceMedianMm).toBeGreaterThan(1000);
  });

  it('walls and inferred stretches come from features of their own', () => {
    const features: PlanFile['features'] = [
      {
        geometry: { type: 'Polygon', coordinates: [closed(rectangle(4, 2, 0.21, 3))] },
        properties: { kind: 'wall', storey: 0, thicknessM: 0.21 },
      },
      {
        geometry: {
          type: 'LineString',
          coordinates: [
            [0, 1],
            [0, 2],
          ],
        },
        properties: { kind: 'inferred-stretch', storey: 0, room: 'Room 1' },
      },
    ];
    const hidden = [
      [
        [0, 0],
        [0, 4],
      ],
    ] as const;
    const found = measurePlan({ features }, { ...truth, hidden });
    expect(found.wallThicknessErrorMm).toBeCloseTo(10, 6);
    expect(found).toMatchObject({ inferredM: 1, hiddenM: 4, inferredPrecision: 1 });
    // 15 cm beyond each end are as good as told.
    expect(found.inferredRecall).toBeCloseTo(1.3 / 4, 1);
    expect(measurePlan({ features }, truth).inferredRecall).toBeUndefined();
  });

  it('is in metres whatever the unit, and as exact far from the origin', () => {
    const far = (v: number): number => (v + 5_300_000) * 1000;
    const move = (rings: readonly (readonly (readonly number[])[])[]) =>
      rings.map((ring) => ring.map((p) => p.map(far)));
    const moved: Truth = {
      ...truth,
      rooms: truth.rooms.map(move),
      columns: truth.columns.map(move),
      interior_outline: move(truth.interior_outline),
      outer: move(truth.outer),
      openings: truth.openings.map((o) => ({
        ...o,
        seg: [o.seg[0].map(far), o.seg[1].map(far)],
        z0: o.z0 * 1000,
        z1: o.z1 * 1000,
      })),
      height: 2500,
      unit: 1000,
    };
    const here = plan({ primary: rectangle(0, 0, 8.3, 5), rooms: [rectangle(0.03, 0.03, 3.94, 4.94)] });
    const there: PlanFile = {
      features: here.features.map((feature) => ({
        ...feature,
        geometry: { type: 'Polygon', coordinates: move(feature.geometry!.coordinates as number[][][]) },
      })),
    };
    const [a, b] = [measurePlan(here, truth), measurePlan(there, moved)];
    for (const name of Object.keys(a) as (keyof typeof a)[]) expect(b[name], name).toBeCloseTo(a[name]!, 4);
  });

  it('averages storeys; what a storey lacks counts 0', () => {
    const house: Truth = {
      storeys: [truth, truth],
      name: 'house',
      up: 'z',
      unit: 1,
      plan_axes: 'x,y',
      points: 0,
    };
    const ground = plan({ primary: rectangle(0, 0, 8.2, 5), rooms: [rectangle(0, 0, 4, 5)] }, 0);
    const found = measurePlan(ground, house);
    expect(found.footprintIou).toBeCloseTo(0.5, 9);
    expect(found.roomF1).toBeCloseTo((2 / 3 + 0) / 2, 9);
    expect(found.roomHeightErrorMm).toBeCloseTo(50, 9);
  });
});

describe('meanOfScenes', () => {
  it('pools structures and counts a scene without a plan as 0', () => {
    const mean = meanOfScenes([
      {
        footprintIou: 1,
        faceMedianMm: 4,
        structuresFound: 1,
        structuresTrue: 1,
        structuresMatched: 1,
        structureF1: 1,
      },
      { footprintIou: 0.8, structuresFound: 0, structuresTrue: 3, structuresMatched: 0, structureF1: 0 },
      null,
    ]);
    expect(mean.footprintIou).toBeCloseTo(0.6, 12);
    expect(mean.faceMedianMm).toBe(4);
    expect(mean.structureF1).toBeCloseTo(0.4, 12);
  });
});
