import type { PlainError } from '../core/errors.ts';
import type { GivenValues, Options } from '../core/params.ts';
import type { Progress, StageReport } from '../core/pipeline-run.ts';
import type { FloorPlan, Level, SecondaryResult, Slice, Solid } from '../core/types.ts';
import type { Report } from '../session/report.ts';

/** What the page needs to show a plan; arrays are transferred or copied, never shared. */
export interface PlanView {
  readonly options: Options;
  readonly plan: FloorPlan;
  /** One drawing a storey: the very SVG that is exported. */
  readonly drawings: readonly string[];
  readonly solid: Solid;
  /** A uniform sample of the cloud for display: metres, z up, the solid's frame. */
  readonly cloud: CloudView;
  readonly slice: Slice;
  readonly levels: readonly Level[];
  readonly secondary: SecondaryResult;
  readonly stages: readonly StageReport[];
  readonly report: Report;
}

export interface CloudView {
  readonly positions: Float32Array;
  /** r, g, b a point, 0 to 255, when the scan has colours. */
  readonly colour?: Uint8Array;
  /** Points the sample stands for. */
  readonly total: number;
}

export interface ExportedFile {
  readonly name: string;
  readonly blob: Blob;
}

/** Page → worker. `id` pairs a request with its answer. */
export type Request =
  | {
      readonly kind: 'load';
      readonly id: number;
      readonly source: Blob | string;
      readonly name: string;
      readonly options: GivenValues;
    }
  | { readonly kind: 'update'; readonly id: number; readonly options: GivenValues }
  | { readonly kind: 'export'; readonly id: number; readonly format: string };

/** Worker → page. */
export type Response =
  | { readonly kind: 'ready' }
  | { readonly kind: 'progress'; readonly id: number; readonly progress: Progress }
  /** Points seen so far while reading: metres are not known yet, so source units relative to the first point. */
  | { readonly kind: 'preview'; readonly id: number; readonly positions: Float32Array }
  | { readonly kind: 'view'; readonly id: number; readonly view: PlanView }
  | {
      readonly kind: 'files';
      readonly id: number;
      readonly files: readonly ExportedFile[];
    }
  | { readonly kind: 'error'; readonly id: number; readonly error: PlainError };
