import type { FloorPlan, Scan, Slice, Solid } from '../core/types.ts';

/** All that writers may draw on; made by one run of the pipeline. */
export interface Product {
  /** Base name of the input, without extension; titles drawings. */
  readonly name: string;
  readonly plan: FloorPlan;
  readonly slice: Slice;
  readonly solid: Solid;
}

/** A file to be saved: its name within the output folder and its content. */
export interface WrittenFile {
  readonly name: string;
  readonly mime: string;
  readonly content: string | Uint8Array<ArrayBuffer>;
}

/** A row of WRITE_FORMATS, keyed by the name used in `--formats` and `export(format)`. */
export interface WriteFormat {
  readonly label: string;
  readonly doc: string;
  readonly extension: string;
  readonly mime: string;
  /** Under a building of several storeys the file is written once a storey: plan-0.svg, plan-1.svg … */
  readonly isPerStorey: boolean;
  /** Base name of the file: plan, slice, rooms … */
  readonly base: string;
  /** @param storey index of the storey where the format is per storey, else 0 */
  write(product: Product, storey: number): string | Uint8Array<ArrayBuffer>;
}

export type { FloorPlan, Scan };
