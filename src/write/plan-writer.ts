import type { StageResults } from '../core/stage-results.ts';

/** All that writers may draw on: what one run's stages made; pictures alone need more than plan, slice and solid. */
export type Product = Partial<StageResults> &
  Pick<StageResults, 'plan' | 'slice' | 'solid'> & {
    /** Base name of the input, without extension; titles drawings. */
    readonly name: string;
  };

/** A file to be saved: its name within the output folder and its content. */
export interface WrittenFile {
  readonly name: string;
  readonly mime: string;
  readonly content: string | Uint8Array<ArrayBuffer>;
}

interface FormatFacts {
  readonly label: string;
  readonly doc: string;
  readonly extension: string;
  readonly mime: string;
  /** The command writes it only when `--formats` names it. */
  readonly isOnRequest?: boolean;
}

/** A format of one file, or under a building of several storeys one a storey. */
export interface FileFormat extends FormatFacts {
  /** Under a building of several storeys the file is written once a storey: plan-0.svg, plan-1.svg … */
  readonly isPerStorey: boolean;
  /** Base name of the file: plan, slice, rooms … */
  readonly base: string;
  /** @param storey index of the storey where the format is per storey, else 0 */
  write(product: Product, storey: number): WrittenFile['content'];
}

/** A format of as many files as the product gives. */
export interface FileSetFormat extends FormatFacts {
  writeAll(product: Product): readonly WrittenFile[];
}

/** A row of WRITE_FORMATS, keyed by the name used in `--formats` and `export(format)`. */
export type WriteFormat = FileFormat | FileSetFormat;
