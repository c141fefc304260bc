import { FloorPlanError } from '../core/errors.ts';
import type { Options } from '../core/params.ts';
import type { StageResults } from '../core/stage-results.ts';
import type { WriteTools } from './drawing/raster.ts';

/** All that writers may draw on: what one run's stages made; pictures alone need more. */
export type Product = Partial<StageResults> &
  Pick<StageResults, 'plan' | 'slice' | 'solid' | 'sheet'> & {
    readonly options: Options;
    /** Base name of the input, without extension; titles drawings. */
    readonly name: string;
  };

/** A file to be saved: its name within the output folder and its content. */
export interface WrittenFile {
  readonly name: string;
  readonly mime: string;
  readonly content: string | Uint8Array<ArrayBuffer>;
}

/** What a format is for: to be looked at and drawn on, to be walked around, to be computed with. */
export type FormatGroup = 'drawing' | 'model' | 'data';

interface FormatFacts {
  readonly label: string;
  readonly group: FormatGroup;
  readonly doc: string;
  readonly extension: string;
  readonly mime: string;
  /** What a plan may lack: its scan's points, or the coordinate system that the scan tells. */
  readonly needs?: 'points' | 'crs';
  /** The command writes it only when `--formats` names it. */
  readonly isOnRequest?: boolean;
}

/** A format of one file, or under a building of several storeys one a storey. */
export interface FileFormat extends FormatFacts {
  /** Under a building of several storeys the file is written once a storey: plan-0.svg, plan-1.svg … */
  readonly isPerStorey: boolean;
  /** Base name of the file: plan, slice, rooms … */
  readonly base: string;
  load(): Promise<FileWriter>;
}

/** @param storey index of the storey where the format is per storey, else 0 */
export type FileWriter = (
  product: Product,
  storey: number,
  tools: WriteTools,
) => WrittenFile['content'] | Promise<WrittenFile['content']>;

/** A format of as many files as the product gives. */
export interface FileSetFormat extends FormatFacts {
  loadAll(): Promise<(product: Product) => readonly WrittenFile[]>;
}

/** Why a file of points cannot be written of a plan that was opened without its scan. */
export function noPointsFor(file: string, format: string): FloorPlanError {
  return new FloorPlanError(
    'result/cannot-write',
    `${file}: expected points, found a plan without its scan`,
    { hint: 'Load the scan itself to write its points.', detail: { format } },
  );
}

/** A row of WRITE_FORMATS, keyed by the name used in `--formats` and `export(format)`; its writer is loaded when it is asked for. */
export type WriteFormat = FileFormat | FileSetFormat;
