import type { StoreyPlan } from './building/plan-storey.ts';
import type { ChosenLevel } from './level.ts';
import type { Sheet } from './sheet.ts';
import type {
  Boundary,
  FloorPlan,
  PointCloud,
  RegularisedBoundary,
  Scan,
  SecondaryResult,
  Slice,
  Solid,
} from './types.ts';

/** What each stage makes; a run that failed holds those before the failing stage. */
export interface StageResults {
  readonly read: Scan;
  readonly frame: PointCloud;
  /** The points of {@link frame} in the crop box; the same cloud where there is none. */
  readonly crop: PointCloud;
  /** Indices of the points that are no outliers. */
  readonly outliers: Uint32Array;
  readonly level: ChosenLevel;
  readonly slice: Slice;
  readonly boundary: Boundary;
  readonly regularise: RegularisedBoundary;
  readonly secondary: SecondaryResult;
  /** Empty where the plan is made of outlines. */
  readonly rooms: readonly StoreyPlan[];
  readonly plan: FloorPlan;
  readonly solid: Solid;
  /** One a storey, lowest first. */
  readonly sheet: readonly Sheet[];
}
