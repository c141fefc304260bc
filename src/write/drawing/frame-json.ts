import { type Affine, chain, inverse, type Sheet } from '../../core/sheet.ts';
import type { FloorPlan } from '../../core/types.ts';
import type { Product } from '../plan-writer.ts';

/** The georeference an SVG cannot hold: how places on a drawing are places in the scan. */
export interface FrameFacts {
  readonly version: 1;
  readonly source: string;
  readonly unit: string;
  readonly metresPerUnit: number;
  readonly up: string;
  readonly crs: string | null;
  /** source = origin + rotationᵀ · plan / metresPerUnit; source units. */
  readonly origin: readonly number[];
  readonly rotation: readonly number[];
  /** Seen from above: plan in source units = planOrigin + plan / metresPerUnit. */
  readonly planOrigin: readonly number[];
  readonly storey: number;
  /** Height of the floor over `origin`, m. */
  readonly floorM: number;
  readonly sheet: {
    readonly paper: string;
    readonly widthMm: number;
    readonly heightMm: number;
    readonly scale: number;
    /** Plan metres → mm on plan.svg. */
    readonly planToSheet: Affine;
    /** mm on plan.svg → source units and coordinates, seen from above (as in plan.geojson). */
    readonly sheetToSource: Affine;
  };
  readonly minimal: {
    /** Units of plan.minimal.svg → source units and coordinates, seen from above. */
    readonly svgToSource: Affine;
  };
}

/** Collects the georeference of a storey's drawings. */
export function frameFacts(plan: FloorPlan, sheet: Sheet): FrameFacts {
  const { frame, storeys, source } = plan;
  const { paper, scale, planToSheet } = sheet;
  const [x, y] = frame.planOrigin;
  const units = 1 / frame.metresPerUnit;
  return {
    version: 1,
    source: source.name,
    unit: frame.unit,
    metresPerUnit: frame.metresPerUnit,
    up: frame.up,
    crs: frame.crs ?? null,
    origin: frame.origin,
    rotation: frame.rotation,
    planOrigin: frame.planOrigin,
    storey: sheet.storey,
    floorM: storeys[sheet.storey].floor,
    sheet: {
      paper: paper.name,
      widthMm: paper.width,
      heightMm: paper.height,
      scale,
      planToSheet,
      sheetToSource: chain([units, 0, 0, units, x, y], inverse(planToSheet)),
    },
    minimal: { svgToSource: [units, 0, 0, -units, x, y] },
  };
}

/** Writes plan.frame.json: the paper's sidecar, which brings the georeference an SVG lacks ([Stojanovic19] §3). */
export function writeFrameJson({ plan, sheet }: Product, storey: number): string {
  return `${JSON.stringify(frameFacts(plan, sheet[storey]), null, 2)}\n`;
}
