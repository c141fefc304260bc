/** Our measure against the independent scorer, on true plans made worse in all ways. */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { simulate } from '../../fixtures/simulator/index.ts';
import { homeBuilding, officeBuilding, roundHallBuilding } from '../../fixtures/simulator/layouts.ts';
import { type Random, seededRandom } from '../../fixtures/simulator/random.ts';
import type { Truth, TruthStorey } from '../../fixtures/simulator/truth.ts';
import type { PlanFile } from './facts.ts';
import { measurePlan } from './measure.ts';
import { MEASURE_NAMES, type Measures, rowOf } from './measures.ts';

const scorer = resolve(import.meta.dirname, '../../../shared/design/score.py');
const pythons = [process.env.PYTHON, 'python3'].filter((name) => name !== undefined);
const python = pythons.find((name) => spawnSync(name, ['-c', 'import numpy, scipy, shapely']).status === 0);
const missing = [
  ...(existsSync(scorer) ? [] : [`the reference scorer ${scorer}`]),
  ...(python ? [] : ['a Python with numpy, scipy and shapely (set PYTHON)']),
];

if (missing.length > 0) console.warn(`The measure is not compared: no ${missing.join(', no ')}.`);

const folder = mkdtempSync(join(tmpdir(), 'grundriss-measure-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const few = { raysPerStation: 500, stationsPerRoom: 1 };
const truths: readonly Truth[] = [
  simulate({ name: 'u', building: homeBuilding(21, { shape: 'U' }), scan: few, pose: { heading: 0.31 } })
    .truth,
  simulate({ name: 'office', building: officeBuilding(22), scan: few, pose: { heading: 1.1 } }).truth,
  simulate({ name: 'round', building: roundHallBuilding(23), scan: few, pose: { heading: 0.2, unit: 'mm' } })
    .truth,
  simulate({ name: 'house', building: homeBuilding(24, { storeys: 2 }), scan: few, pose: { heading: -0.4 } })
    .truth,
  simulate({
    name: 'utm',
    building: homeBuilding(25, { shape: 'L', skew: 0.05 }),
    scan: few,
    pose: { heading: 0.7, offset: [691_870, 5_336_020, 519] },
  }).truth,
];

/** A plan as the truth has it, with corners moved, rooms left out, doubled and joined, structures and doors astray. */
function worsened(truth: Truth, random: Random): PlanFile {
  const storeys = 'storeys' in truth ? truth.storeys : [truth];
  return { features: storeys.flatMap((storey, i) => worsenedStorey(storey, i, truth.unit, random)) };
}

type Feature = PlanFile['features'][number];

function worsenedStorey(storey: TruthStorey, index: number, unit: number, random: Random): Feature[] {
  // Vertices of curves lie 15 cm apart: moved by more, they cross.
  const isCurved = storey.outer[0].length > 30;
  const size = (isCurved ? 0.01 : random.between(0.01, 0.12)) * unit;
  const shifted = ([x, y]: readonly number[]): number[] => [
    x + random.normal() * size,
    y + random.normal() * size,
  ];
  const ringOf = (ring: readonly (readonly number[])[]): number[][] => {
    const open = ring.slice(0, -1).map(shifted);
    return [...open, open[0]];
  };
  const polygon = (kind: string, ring: readonly (readonly number[])[]): Feature => ({
    geometry: { type: 'Polygon', coordinates: [ringOf(ring)] },
    properties: { kind, storey: index, heightM: 2.5 },
  });
  const rooms = storey.rooms.flatMap(([ring]) => {
    if (random.chance(0.15)) return [];
    return random.chance(0.15) ? [polygon('room', ring), polygon('room', ring)] : [polygon('room', ring)];
  });
  const kinds = ['door', 'window', 'passage'] as const;
  const openings = storey.openings.flatMap(({ kind, seg }): Feature[] => {
    if (random.chance(0.2)) return [];
    return [
      {
        geometry: { type: 'LineString', coordinates: seg.map(shifted) },
        properties: {
          kind: 'opening',
          storey: index,
          type: random.chance(0.1) ? random.pick(kinds) : kind,
          sillM: 0,
          headM: 2,
        },
      },
    ];
  });
  return [
    polygon('primary-boundary', storey.interior_outline[0]),
    ...rooms,
    ...storey.columns.map(([ring]) => polygon('secondary-boundary', ring)),
    ...openings,
  ];
}

function referenceScore(plan: PlanFile, truth: Truth): Record<string, number | boolean | null> {
  const [planPath, truthPath] = [join(folder, 'plan.json'), join(folder, 'truth.json')];
  writeFileSync(planPath, JSON.stringify(plan));
  writeFileSync(truthPath, JSON.stringify(truth));
  // Its own command line rounds to four digits: too few for shares of a millimetre.
  const script = `import sys, json; sys.path.insert(0, ${JSON.stringify(join(scorer, '..'))})
from score import score
r = score(json.load(open(sys.argv[1])), json.load(open(sys.argv[2])))
print(json.dumps({k: v if v is None else float(v) for k, v in r.items()}))`;
  const { stdout, stderr, status } = spawnSync(python!, ['-c', script, planPath, truthPath], {
    encoding: 'utf8',
  });
  if (status !== 0) throw new Error(stderr);
  return JSON.parse(stdout);
}

function expectAgreement(ours: Measures, theirs: Record<string, unknown>, context: string): number {
  let compared = 0;
  for (const name of MEASURE_NAMES) {
    const { reference } = rowOf(name);
    if (reference === undefined) continue;
    const wanted = theirs[reference] ?? undefined;
    if (wanted === undefined) expect(ours[name], `${context}: ${name}`).toBeUndefined();
    else
      expect(
        Math.abs(ours[name]! - Number(wanted)),
        `${context}: ${name} ${ours[name]} ${wanted}`,
      ).toBeLessThan(1e-4);
    compared++;
  }
  return compared;
}

describe('our measure and the reference scorer', () => {
  it.skipIf(missing.length > 0)(
    `agree on every figure${missing.map((what) => ` (skipped: no ${what})`)}`,
    () => {
      let valid = 0;
      for (const truth of truths) {
        for (let round = 0; round < 3; round++) {
          const plan = worsened(truth, seededRandom(round, truth.name));
          // Crossing rings are mended differently by the two, so they are left to the tests by hand.
          const figures = measurePlan(plan, truth);
          const theirs = referenceScore(plan, truth);
          expect(figures.valid, `${truth.name} ${round}: valid`).toBe(Number(theirs.valid));
          if (figures.valid !== 1) continue;
          valid++;
          expect(expectAgreement(figures, theirs, `${truth.name} ${round}`)).toBeGreaterThan(20);
        }
      }
      expect(valid).toBeGreaterThan(7);
    },
  );

  it.skipIf(missing.length > 0)('agree on an empty plan', () => {
    for (const truth of truths) {
      expectAgreement(
        measurePlan({ features: [] }, truth),
        referenceScore({ features: [] }, truth),
        truth.name,
      );
    }
  });
});
