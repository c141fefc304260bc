import { kebabCase, PARAM_NAMES, type ParamName } from '../core/params.ts';
import type { Progress } from '../core/pipeline-run.ts';
import type { FloorPlan } from '../core/types.ts';

/** What people build on: `<floor-plan>` offers these and a test holds it to them. Add; do not rename. */
export const ATTRIBUTES = {
  src: 'URL of a scan; a change loads it.',
  poster: 'URL of a picture shown until the first plan is there.',
  view: '2d, 3d or split (the default; a narrow element shows one view at a time).',
  controls: 'Shows the bar, the steps with their parameters, and the exports.',
} as const;

export const PROPERTIES = {
  file: 'The File or Blob shown, or null; setting it loads it.',
  options: 'Parameters given so far; setting them makes the plan again from the first step they touch.',
  spawnWorker:
    'A function that makes the worker, e.g. from grundriss/worker, where the page refuses a blob; null for the one inside.',
  step: 'Name of the step whose picture stands in place of the drawing, or null.',
  plan: 'The FloorPlan shown, or null. Read only.',
  state: 'empty, loading, ready or failed. Read only.',
  error: 'The error of the last run, or null. Read only.',
} as const;

export const METHODS = {
  load: 'load(source: File | Blob | URL | string, or an array of them: parts of one scan): Promise<FloorPlan>. Rejects with a FloorPlanError.',
  cancel: 'cancel(): stops the run; the last plan stays.',
  export:
    'export(format): Promise<Blob>. Several files (one a storey) come as a ZIP; zip:svg,dxf packs these formats.',
  fit: 'fit(): shows everything in both views.',
} as const;

export const EVENTS = {
  progress: 'Where a run stands; detail: { stage, share }.',
  load: 'A scan was read and its plan is shown; detail: the FloorPlan.',
  error: 'A run failed; detail: the error. The last plan stays.',
  'plan-change': 'Another plan is shown, after a load or a changed parameter; detail: the FloorPlan.',
} as const;

export const PARTS = {
  bar: 'The bar along the top.',
  rail: 'Steps, warnings and exports.',
  sheet: 'The 2D view.',
  scene: 'The 3D view.',
  error: 'The error panel.',
  poster: 'The poster picture.',
} as const;

export const SLOTS = {
  'bar-start': 'Before the Open button.',
  'bar-middle': 'After the Open button.',
  'bar-end': 'At the end of the bar.',
  empty: 'Below the invitation shown while there is no scan.',
} as const;

export const LAYOUTS = ['2d', '3d', 'split'] as const;
export type Layout = (typeof LAYOUTS)[number];

export type PlanState = 'empty' | 'loading' | 'ready' | 'failed';

export interface FloorPlanEventMap {
  progress: CustomEvent<Progress>;
  load: CustomEvent<FloorPlan>;
  error: CustomEvent<Error>;
  'plan-change': CustomEvent<FloorPlan>;
}

/** Attribute → parameter. A parameter whose name is an attribute of the element itself would be shadowed. */
export const PARAM_ATTRIBUTES: ReadonlyMap<string, ParamName> = new Map(
  PARAM_NAMES.map((name) => [kebabCase(name), name]),
);
