import type { PlainError } from '../core/errors.ts';
import type { GivenValues, Options } from '../core/params.ts';
import type { Progress, StageReport } from '../core/pipeline-run.ts';
import type { StageName } from '../core/stages.ts';
import type { FloorPlan, Level, PointCloud, SecondaryResult, Slice, Solid, Vec3 } from '../core/types.ts';
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
  readonly surroundings: Surroundings;
  /** The scan is a ready slice, already in the plan frame. */
  readonly isSlice: boolean;
  /** A plan.json was opened: there are no points, and stages before the plan made nothing. */
  readonly isSavedPlan: boolean;
  /** One sentence each: why this unit, why this axis. */
  readonly reasons: PointCloud['reasons'];
  readonly slice: Slice;
  readonly levels: readonly Level[];
  readonly secondary: SecondaryResult;
  readonly stages: readonly StageReport[];
  readonly report: Report;
  readonly pictures: readonly PictureFacts[];
}

/** A picture of a stage that can be asked for. */
export interface PictureFacts {
  readonly name: string;
  /** Name of its file. */
  readonly file: string;
  readonly stage: StageName;
  readonly label: string;
  /** What it shows, one sentence. */
  readonly doc: string;
  /** The figure of the paper it corresponds to, or `ours`. */
  readonly figure: string;
  /** What came out, in words. */
  readonly outcome: string;
  /** Of its stage, when it last ran. */
  readonly ms: number;
  /** Rounds of the search for structures that can be asked for; 1 where there is no choice. */
  readonly rounds: number;
}

/** How far a run that failed got. */
export interface Evidence {
  /** The stage that failed. */
  readonly stage: StageName;
  /** Of the stages before the failing one. */
  readonly pictures: readonly PictureFacts[];
}

/** Whose picture: of the plan shown, or of the run that failed after it. */
export type PictureOf = 'plan' | 'failed';

/** Which picture is asked for. */
export interface PictureAsked {
  readonly name: string;
  readonly of: PictureOf;
  /** From 1; where absent the last. */
  readonly round?: number | undefined;
}

/** What is asked of a comparison. */
export type ComparisonRequest = Pick<Extract<Request, { kind: 'compare' }>, 'options' | 'labels'>;

/** The plan shown beside what other parameters make of the same scan. */
export interface Comparison {
  readonly overlaid: string;
  readonly beside: string;
  /** Whose figures follow: the primary boundaries', or where these are the same the secondary ones'. */
  readonly subject: 'primary' | 'secondary';
  readonly here: ComparedPlan;
  readonly there: ComparedPlan;
  /** Intersection over union. */
  readonly iou: number;
  /** 95 % of either outline lie within this of the other, m; infinite where only one has an outline. */
  readonly distance: number;
}

export interface ComparedPlan {
  readonly vertices: number;
  readonly areaM2: number;
  readonly triangles: number;
  /** Of the stages that make the two differ. */
  readonly ms: number;
}

export interface CloudView {
  readonly positions: Float32Array;
  /** r, g, b a point, 0 to 255. */
  readonly colour?: Uint8Array;
  /** The scan's intensities as greys, likewise. */
  readonly intensity?: Uint8Array;
  /** Points the sample stands for. */
  readonly total: number;
}

/** The cloud before the crop box; plan frame, m. */
export interface Surroundings {
  readonly min: Vec3;
  readonly max: Vec3;
  /** A sample of the points that the box left out: x, y a point. */
  readonly cropped: Float64Array;
}

export interface ExportedFile {
  readonly name: string;
  readonly blob: Blob;
}

/** A file of a scan, or its address. */
export interface ScanFile {
  readonly data: Blob | string;
  readonly name: string;
}

/** Page → worker. `id` pairs a request with its answer. */
export type Request =
  | {
      readonly kind: 'load';
      readonly id: number;
      /** Parts of one scan, at least one. */
      readonly files: readonly ScanFile[];
      readonly options: GivenValues;
    }
  | { readonly kind: 'update'; readonly id: number; readonly options: GivenValues }
  | { readonly kind: 'export'; readonly id: number; readonly format: string }
  | ({ readonly kind: 'picture'; readonly id: number } & PictureAsked)
  /** What other parameters make of the scan; the plan shown stays. */
  | {
      readonly kind: 'compare';
      readonly id: number;
      readonly options: GivenValues;
      /** What the plan shown and the other are called. */
      readonly labels: readonly [here: string, there: string];
    }
  /** Ends the comparison of this id. */
  | { readonly kind: 'stop'; readonly id: number };

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
  /** Null where that run has no such picture. */
  | { readonly kind: 'picture'; readonly id: number; readonly svg: string | null }
  | { readonly kind: 'comparison'; readonly id: number; readonly comparison: Comparison }
  /** `evidence` of a load or an update. */
  | {
      readonly kind: 'error';
      readonly id: number;
      readonly error: PlainError;
      readonly evidence?: Evidence;
    };
