import { FloorPlanError } from '../../core/errors.ts';
import { lineEnd } from './characters.ts';
import type { LineBlock } from './line-blocks.ts';
import type { RowParser } from './row-parser.ts';

/** Tells whether a file is cut off in its last row. */
export class LastRow {
  /** What is wrong with the row, where it shows. */
  fault: FloorPlanError | null = null;

  /** Whether the row at `begin` is the file's end and not whole. @param left rows to come, this one among them */
  isCut({ bytes, isCut }: LineBlock, begin: number, left: number, parser: RowParser): boolean {
    if (!isCut || lineEnd(bytes, begin) < bytes.length - 1) return false;
    // Where more rows were announced it is cut, whatever it looks like: 5.6 may have been 5.678.
    if (left > 1 && left < Infinity) return true;
    try {
      parser.read(bytes, begin, true);
      return false;
    } catch (error) {
      if (!(error instanceof FloorPlanError)) throw error;
      this.fault = error;
      return true;
    }
  }
}
