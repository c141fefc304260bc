import { areaOf } from '../core/geometry/areas.ts';
import { polygonArea, vertexCount } from '../core/geometry/rings.ts';
import type { Axis, FrameUnit, Warning } from '../core/types.ts';
import { checkSolid } from '../solid/check-solid.ts';
import { planBounds } from './plan-bounds.ts';
import type { RunResult } from './result.ts';

/** What `report.json` holds. Heights of levels in metres above the floor. */
export interface Report {
  readonly version: 1;
  readonly input: {
    readonly name: string;
    readonly format: string;
    readonly bytes: number;
    readonly pointsRead: number;
    readonly pointsKept: number;
    readonly up: Axis;
    readonly unit: FrameUnit;
    readonly metresPerUnit: number;
    /** Source axes, units and coordinates; of the plan where that was opened without its scan. */
    readonly bounds: { readonly min: readonly number[]; readonly max: readonly number[] };
    /** Where each scanner stood, like the bounds; empty where the file does not tell. */
    readonly stations: readonly (readonly number[])[];
  };
  readonly levels: readonly {
    readonly low: number;
    readonly high: number;
    readonly points: number;
    readonly densityPerM2: number;
    readonly chosen: boolean;
  }[];
  readonly boundary: { readonly method: string; readonly vertices: number; readonly areaM2: number };
  readonly secondary: readonly {
    readonly operation: string;
    readonly type: string;
    readonly vertices: number;
    readonly areaM2: number;
  }[];
  readonly rooms: readonly { readonly name: string; readonly areaM2: number; readonly heightM: number }[];
  /** Things that stand in the rooms; absent unless they were asked for. */
  readonly furniture?: number;
  readonly mesh: { readonly vertices: number; readonly triangles: number; readonly watertight: boolean };
  readonly stages: readonly { readonly name: string; readonly ms: number }[];
  readonly totalMs: number;
  readonly peakMemoryMB?: number;
  readonly warnings: readonly Warning[];
}

/**
 * The numbers of a run, as `report.json` gives them.
 *
 * @param totalMs wall time of the whole run
 * @param peakMemoryMB highest resident memory, where the environment knows it
 */
export function makeReport(result: RunResult, totalMs: number, peakMemoryMB?: number): Report {
  const { read, level, boundary, plan, solid, stages, warnings } = result;
  const { name, format, bytes, pointsRead, pointsKept } = plan.source;
  const { up, unit, metresPerUnit } = plan.frame;
  const primary = plan.storeys.flatMap((storey) => storey.primary);
  return {
    version: 1,
    input: {
      name,
      format,
      bytes,
      pointsRead,
      pointsKept,
      up,
      unit,
      metresPerUnit,
      bounds: read?.bounds ?? planBounds(plan),
      stations: read?.stations ?? [],
    },
    levels: level?.levels ?? [],
    boundary: {
      method: boundary?.method ?? plan.options.boundary,
      vertices: vertexCount(primary),
      areaM2: round(areaOf(primary)),
    },
    secondary: plan.storeys.flatMap(({ secondary }) =>
      secondary.map(({ operation, type, outline }) => ({
        operation,
        type,
        vertices: vertexCount([outline]),
        areaM2: round(polygonArea(outline)),
      })),
    ),
    rooms: plan.storeys.flatMap(({ rooms }) =>
      rooms.map((room) => ({
        name: room.name,
        areaM2: round(polygonArea(room.outline)),
        heightM: round(room.height),
      })),
    ),
    ...(plan.storeys.some(({ furniture }) => furniture) && {
      furniture: plan.storeys.reduce((sum, { furniture = [] }) => sum + furniture.length, 0),
    }),
    mesh: {
      vertices: solid.positions.length / 3,
      triangles: solid.indices.length / 3,
      watertight: checkSolid(solid).watertight,
    },
    stages: stages.map(({ name: stage, ms }) => ({ name: stage, ms: round(ms) })),
    totalMs: round(totalMs),
    ...(peakMemoryMB === undefined ? {} : { peakMemoryMB: round(peakMemoryMB) }),
    warnings,
  };
}

/** To a ten-thousandth: 0.1 mm, 1 cm², 0.1 µs. */
function round(value: number): number {
  return Math.round(value * 1e4) / 1e4;
}
