import type { TruthOpening } from '../../fixtures/simulator/truth.ts';
import type { CorpusTruth } from './classes.ts';

/** A room captured by a person with a headset, as `truth/NAME_plan_gt.json` has it: y up, metres, one polygon. */
export interface SurveyedRoom {
  readonly room_polygon_xz: readonly (readonly [x: number, z: number])[];
  readonly floor_y: number;
  readonly ceiling_y: number;
  readonly openings: readonly {
    readonly type: string;
    readonly segment: readonly (readonly [x: number, z: number])[];
    readonly y: readonly [low: number, high: number];
  }[];
}

const KINDS: Readonly<Record<string, TruthOpening['kind']>> = { DOOR_FRAME: 'door', WINDOW_FRAME: 'window' };

/** The room as truth of one storey; its walls were not captured, so its inner face is its outer face. */
export function surveyedTruth(name: string, room: SurveyedRoom): CorpusTruth {
  // The plan frame of a cloud with y up is (x, −z).
  const point = ([x, z]: readonly number[]): readonly number[] => [x, 0 - z];
  const open = room.room_polygon_xz.map(point);
  const ring = [...open, open[0]];
  return {
    name,
    rooms: [[ring]],
    columns: [],
    interior_outline: [ring],
    outer: [ring],
    openings: room.openings.flatMap(({ type, segment: [from, to], y: [low, high] }) =>
      KINDS[type] === undefined
        ? []
        : [
            {
              kind: KINDS[type],
              seg: [point(from), point(to)] as const,
              z0: low - room.floor_y,
              z1: high - room.floor_y,
            },
          ],
    ),
    height: room.ceiling_y - room.floor_y,
    floor: room.floor_y,
    up: 'y',
    unit: 1,
    plan_axes: 'x,-z',
    points: 0,
  };
}
