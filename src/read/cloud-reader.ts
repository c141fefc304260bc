import type { Axis, PointAttributes, Unit, Vec3, Warning } from '../core/types.ts';
import type { ByteSource } from './bytes/source.ts';

/** Entries a point of each attribute. */
export const ATTRIBUTE_WIDTHS: Readonly<Record<keyof PointAttributes, number>> = {
  colour: 3,
  intensity: 1,
  classification: 1,
  station: 1,
};
export const ATTRIBUTES = Object.keys(ATTRIBUTE_WIDTHS) as readonly (keyof PointAttributes)[];

/** Some tens of thousands of points on their way from a reader to the thinning. The arrays may be used again. */
export interface PointChunk extends PointAttributes {
  readonly count: number;
  /** x, y, z a point, float64, source axes, units and coordinates; entries past 3 · count are stale. */
  readonly xyz: Float64Array;
}

/** A cloud whose header has been read. */
export interface OpenCloud {
  /** Two columns only: a ready slice in the plan frame. */
  readonly isSlice: boolean;
  readonly unit?: Unit;
  /** The axis that is up by the format's own rule. */
  readonly up?: Axis;
  readonly crs?: string;
  /** Points the header announces; undefined where it does not. */
  readonly pointsAnnounced?: number;
  /** What the chunks hold depends on the spacing asked for: surfaces that are sampled, an octree. */
  readonly isAdaptive?: boolean;
  /** A grid of directions, of which those without a return are points without a place: no reason for a warning. */
  readonly hasEmptyPlaces?: boolean;
  /** Where each scanner stood, source units and coordinates, by `station`; filled while reading. */
  readonly stations?: readonly Vec3[];
  /**
   * Points in file order, NaN and infinite ones included. May be called again to read once more.
   *
   * @param spacing two points closer than this may be told as one, source units; 0 where the unit is not known yet: an
   * adaptive cloud then yields a rough whole of some hundred thousand points, to judge its unit from
   * @param budget points that are kept at most: an adaptive cloud yields no more than serve them
   * @throws FloorPlanError input/…
   */
  chunks(progress: ReadProgress, spacing: number, budget?: number): AsyncIterable<PointChunk>;
  /** Filled while reading. */
  readonly warnings: Warning[];
}

/** Called by a reader after each chunk of bytes. @throws cancelled, when the person has asked */
export type ReadProgress = (bytesRead: number) => void;

/** A row of READ_FORMATS. */
export interface ReadFormat {
  readonly label: string;
  /** Without the dot, lower case. */
  readonly extensions: readonly string[];
  readonly doc: string;
  /** Whether the first bytes (up to 64 KiB) are of this format, whatever the name. */
  detect(head: Uint8Array): boolean;
  /** Reads the header. @throws FloorPlanError input/… */
  open(source: ByteSource): Promise<OpenCloud>;
}
