import type { Axis, Unit, Warning } from '../core/types.ts';
export interface Report {
  readonly version: 1;
  readonly input: {
    readonly name: string;
    readonly format: string;
    readonly bytes: number;
    readonly pointsRead: number;
    readonly pointsKept: number;
    readonly up: Axis;
    readonly unit: Unit;
    /** Source axes, units and coordinates. */
    readonly bounds: { readonly min: readonly number[]; readonly max: readonly number[] };
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
  readonly mesh: { readonly vertices: number; readonly triangles: number; readonly watertight: boolean };
  readonly stages: readonly { readonly name: string; readonly ms: number }[];
  readonly totalMs: number;
  readonly peakMemoryMB?: number;
  readonly warnings: readonly Warning[];
}
