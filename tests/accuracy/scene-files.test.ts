import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { measurePlan } from './measure.ts';
import { drawComparison } from './picture.ts';
import { scenesIn } from './scene-files.ts';
import { surveyedTruth } from './surveyed-room.ts';

const folder = mkdtempSync(join(tmpdir(), 'grundriss-scenes-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** 4 m × 3 m, floor at 0.1 m, a door in the wall z = 0. */
const room = {
  room_polygon_xz: [
    [0, 0],
    [4, 0],
    [4, -3],
    [0, -3],
  ],
  floor_y: 0.1,
  ceiling_y: 2.6,
  openings: [
    {
      type: 'DOOR_FRAME',
      segment: [
        [1, 0],
        [2, 0],
      ],
      y: [0.1, 2.1],
    },
    {
      type: 'LAMP',
      segment: [
        [1, 0],
        [2, 0],
      ],
      y: [2, 2.1],
    },
  ],
} as const;

describe('scenes of a folder', () => {
  it('have the truth beside them, or that of a survey, or none', () => {
    mkdirSync(join(folder, 'truth'));
    const truth = surveyedTruth('exact', room);
    writeFileSync(join(folder, 'exact.gt.json'), JSON.stringify(truth));
    writeFileSync(join(folder, 'truth/hall_plan_gt.json'), JSON.stringify(room));
    for (const file of ['exact.ply', 'hall_points.ply', 'other.e57', 'LICENSE-other.txt', 'README.md']) {
      writeFileSync(join(folder, file), '');
    }
    const found = scenesIn(folder);
    expect(found.map(({ name }) => name)).toEqual(['exact', 'hall_points', 'other']);
    expect(found[0].truth).toEqual(truth);
    expect(found[1].truth).toEqual({ ...truth, name: 'hall_points' });
    expect(found[2].truth).toBeNull();
  });

  it('surveyed rooms lie in the plan frame (x, −z)', () => {
    const truth = surveyedTruth('hall', room);
    const ring = [
      [0, 0],
      [4, 0],
      [4, 3],
      [0, 3],
      [0, 0],
    ];
    const plan = {
      features: [
        { geometry: { type: 'Polygon', coordinates: [ring] }, properties: { kind: 'room', heightM: 2.5 } },
        {
          geometry: {
            type: 'LineString',
            coordinates: [
              [1, 0],
              [2, 0],
            ],
          },
          properties: { kind: 'opening', type: 'door', sillM: 0, headM: 2 },
        },
      ],
    };
    const found = measurePlan(plan, truth);
    expect(found).toMatchObject({ roomF1: 1, doorF1: 1, cornerF1At5cm: 1 });
    expect(found.roomHeightErrorMm).toBeCloseTo(0, 6);
    expect(found.doorHeadErrorMm).toBeCloseTo(0, 6);
    const svg = drawComparison({ name: 'hall', plan, truth, points: [[1, 1]], storey: 0, figures: 'IoU 1' });
    expect(svg).toContain('hall, storey 0   IoU 1');
    expect(svg).not.toMatch(/NaN|Infinity/);
    const unknown = { name: 'x', plan: { features: [] }, truth: null, points: [], storey: 1, figures: '' };
    expect(drawComparison(unknown)).not.toMatch(/NaN|Infinity/);
  });
});
