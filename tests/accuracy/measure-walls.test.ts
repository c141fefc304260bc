import { describe, expect, it } from 'vitest';
import { arc, rectangle, type XY } from '../../fixtures/simulator/ring.ts';
import type { StoreyFacts, Stretch, WallFacts } from './facts.ts';
import { measureInferred } from './measure-inferred.ts';
import { measureWalls } from './measure-walls.ts';
import { inferredShares, meanOfScenes, meanOfStoreys } from './measures.ts';
import { trueWalls } from './true-walls.ts';

const NOTHING: StoreyFacts = {
  primary: [],
  rooms: [],
  roomHeights: [],
  structures: [],
  openings: [],
  outer: [],
  walls: [],
  hidden: null,
};

/** Two rooms 4 m × 5 m, a wall of 0.2 m between them, one of 0.3 m around them, a door in the inner wall. */
const truth: StoreyFacts = {
  ...NOTHING,
  rooms: [[rectangle(0, 0, 4, 5)], [rectangle(4.2, 0, 4, 5)]],
  outer: [[rectangle(-0.3, -0.3, 8.8, 5.6)]],
  openings: [
    { kind: 'door', from: [4.1, 1], to: [4.1, 1.9], centre: [4.1, 1.45], width: 0.9, sill: 0, head: 2 },
  ],
  hidden: [],
};

const wall = (outline: readonly XY[], thickness: number, isInferred = false): WallFacts => ({
  outline: [outline],
  thickness,
  isInferred,
});

describe('trueWalls', () => {
  it('finds each wall once, cut at the door, with its thickness', () => {
    const walls = trueWalls(truth);
    const inner = walls.filter(({ isOuter }) => !isOuter);
    // Samples within half a thickness of the door's jambs belong to the opening.
    expect(inner.map(({ axis, thickness }) => [axis.length, Number(thickness.toFixed(9))])).toEqual([
      [9, 0.2],
      [30, 0.2],
    ]);
    expect(inner.every(({ isSeen }) => isSeen)).toBe(true);
    const outer = walls.filter(({ isOuter }) => isOuter);
    expect(outer.length).toBe(6);
    for (const { thickness, isSeen } of outer) {
      expect(thickness).toBeCloseTo(0.3, 9);
      expect(isSeen).toBe(false);
    }
  });

  it('takes a curved wall as one', () => {
    const quarter = arc([0, 0], 3, 0, Math.PI / 2);
    const beyond = arc([0, 0], 3.2, 0, Math.PI / 2).reverse();
    const room: XY[] = [[0, 0], ...quarter];
    const around: XY[] = [...beyond, [6, 0], [6, 6], [0, 6]].reverse() as XY[];
    const walls = trueWalls({ ...NOTHING, rooms: [[room], [around]], outer: [[rectangle(-9, -9, 30, 30)]] });
    expect(walls.length).toBe(1);
    expect(walls[0].thickness).toBeCloseTo(0.2, 2);
  });

  it('knows a wall as unseen where one of its faces was mostly hidden', () => {
    const hidden: Stretch[] = [
      [
        [4.2, 1.9],
        [4.2, 5],
      ],
    ];
    const inner = trueWalls({ ...truth, hidden }).filter(({ isOuter }) => !isOuter);
    expect(inner.map(({ isSeen }) => isSeen)).toEqual([true, false]);
  });
});

describe('measureWalls', () => {
  const near = wall(rectangle(4.01, 0, 0.18, 1), 0.18);
  const far = wall(rectangle(4, 1.9, 0.23, 3.1), 0.23);

  it('takes the median error over walls, and leaves inferred ones out', () => {
    const both = measureWalls({ ...NOTHING, walls: [near, far] }, truth);
    expect(both.wallThicknessErrorMm).toBeCloseTo(25, 6);
    expect(both.wallsMeasured).toBe(1);
    const one = measureWalls({ ...NOTHING, walls: [near, { ...far, isInferred: true }] }, truth);
    expect(one.wallThicknessErrorMm).toBeCloseTo(20, 6);
    expect(one).toMatchObject({ wallsMeasured: 0.5, wallsInferred: 1 });
  });

  it('judges outer walls apart, where the plan knows them', () => {
    const outer = wall(rectangle(-0.3, -0.3, 0.3, 5.6), 0.34);
    const found = measureWalls({ ...NOTHING, walls: [outer] }, truth);
    expect(found.outerThicknessErrorMm).toBeCloseTo(40, 6);
    expect(found.wallThicknessErrorMm).toBeUndefined();
    expect(found.wallsMeasured).toBe(0);
  });
});

describe('measureInferred', () => {
  const hidden: Stretch[] = [
    [
      [0, 1],
      [0, 3],
    ],
    [
      [4, 4],
      [4, 4.2],
    ],
  ];

  it('by length: half of what is told is right, a quarter of what is hidden is told', () => {
    const told: Stretch[] = [
      [
        [0.02, 2.65],
        [0.02, 3.15],
      ],
      [
        [2, 5],
        [2.5, 5],
      ],
    ];
    const found = measureInferred({ ...NOTHING, hidden: told }, { ...truth, hidden });
    expect(found.inferredM).toBeCloseTo(1, 9);
    // Within 15 cm of the hidden stretch: all of the first.
    expect(found.inferredRightM).toBeCloseTo(0.5, 9);
    // Stretches shorter than 30 cm are asked of nobody.
    expect(found.hiddenM).toBeCloseTo(2, 9);
    expect(found.hiddenToldM).toBeCloseTo(0.5, 9);
    expect(inferredShares(found)).toEqual({
      inferredPrecision: found.inferredRightM! / found.inferredM!,
      inferredRecall: found.hiddenToldM! / found.hiddenM!,
    });
  });

  it('says nothing where the truth does not know, and of a plan that tells nothing that it misses all', () => {
    expect(measureInferred(NOTHING, { ...truth, hidden: null })).toEqual({});
    const silent = measureInferred(NOTHING, { ...truth, hidden });
    expect(silent).toMatchObject({ inferredM: 0, hiddenM: 2, hiddenToldM: 0 });
    expect(inferredShares(silent)).toEqual({ inferredRecall: 0 });
  });

  it('adds lengths up over storeys and scenes', () => {
    const a = { inferredM: 3, inferredRightM: 3, hiddenM: 6, hiddenToldM: 3 };
    const b = { inferredM: 1, inferredRightM: 0, hiddenM: 0, hiddenToldM: 0 };
    for (const mean of [meanOfStoreys([a, b]), meanOfScenes([a, b, {}])]) {
      expect(mean).toMatchObject({ inferredM: 4, hiddenM: 6, inferredPrecision: 0.75, inferredRecall: 0.5 });
    }
  });
});
