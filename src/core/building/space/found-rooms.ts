import type { Circle } from '../../geometry/circle.ts';
import type { Face } from '../faces/face.ts';
import type { FaceSupport } from '../faces/face-support.ts';
import type { Arrangement } from './arrangement.ts';
import type { Space } from './label-space.ts';
import type { RoomFaces } from './trace-rooms.ts';

/** A face, and how far it is drawn on past its ends, m. */
export type WallFace = Face & { readonly reach: number };

/** Faces that stand as walls, with their support. */
export interface WallFaces {
  readonly faces: readonly WallFace[];
  readonly supports: readonly FaceSupport[];
}

/** The rooms of a storey, in the plan's subdivision by its walls. */
export interface FoundRooms {
  readonly faces: readonly WallFace[];
  readonly arrangement: Arrangement;
  /** Share of wall along each edge, 0 to 1. */
  readonly support: Float64Array;
  readonly space: Space;
  /** Circles that curved walls follow. */
  readonly curves: readonly Circle[];
  readonly rooms: readonly RoomFaces[];
}
