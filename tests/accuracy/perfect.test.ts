/** The truth itself, written as a plan, gets every figure right: whatever the unit, the axes and the shape. */
import { describe, expect, it } from 'vitest';
import { simulate } from '../../fixtures/simulator/index.ts';
import type { Truth } from '../../fixtures/simulator/truth.ts';
import { CORPUS } from './corpus.ts';
import type { PlanFile } from './facts.ts';
import { measurePlan } from './measure.ts';
import { MEASURE_NAMES, rowOf } from './measures.ts';

const KINDS = [
  'home-u-utm',
  'home-t-y-up',
  'home-alcoves',
  'wing-45',
  'hall-columns',
  'house-1',
  'open-plan-1',
];
const scenes = CORPUS.filter(
  ({ name, isHeldBack }) => !isHeldBack && KINDS.some((kind) => name.startsWith(kind)),
);

function planOf(truth: Truth): PlanFile {
  const { unit } = truth;
  const storeys = 'storeys' in truth ? truth.storeys : [truth];
  const features = storeys.flatMap((facts, storey): PlanFile['features'][number][] => {
    const feature = (type: string, kind: string, coordinates: unknown, properties: object = {}) => ({
      geometry: { type, coordinates },
      properties: { kind, storey, ...properties },
    });
    return [
      feature('Polygon', 'primary-boundary', facts.interior_outline),
      ...facts.rooms.map((room, i) =>
        feature('Polygon', 'room', room, { heightM: facts.heights![i] / unit }),
      ),
      ...facts.columns.map((column) => feature('Polygon', 'secondary-boundary', column)),
      ...facts.openings.map(({ kind, seg, z0, z1 }) =>
        feature('LineString', 'opening', seg, { type: kind, sillM: z0 / unit, headM: z1 / unit }),
      ),
      ...facts.hidden!.map((stretch) => feature('LineString', 'inferred-stretch', stretch)),
    ];
  });
  return { features };
}

describe('a perfect plan', () => {
  it.each(scenes.map(({ name, spec }) => ({ name, spec })))('$name', ({ spec }) => {
    const given = spec();
    const { truth } = simulate({ ...given, scan: { ...given.scan, mostRays: 30_000 } });
    const found = measurePlan(planOf(truth), truth);
    // Walls stand for no feature of the truth; every other figure is known and perfect.
    const judged = MEASURE_NAMES.filter((name) => found[name] !== undefined && name !== 'wallsMeasured');
    expect(judged.length).toBeGreaterThan(35);
    for (const name of judged) {
      const { kind } = rowOf(name);
      if (kind === 'share') expect(found[name], name).toBeCloseTo(1, 6);
      if (kind === 'error') expect(found[name], name).toBeCloseTo(0, 4);
    }
    expect(found.inferredRightM).toBeCloseTo(found.inferredM!, 6);
  });
});
