import type { Polygon, Storey } from '../../core/types.ts';
import type { IfcModel } from './ifc-model.ts';
import type { Ref } from './step-file.ts';
import type { OpeningPart, WallPart } from './storey-parts.ts';

/** Our own set: how well the points show a thing. */
export const EVIDENCE = 'Grundriss_Evidence';

/** A storey being written. */
export interface StoreyModel {
  readonly model: IfcModel;
  readonly storey: Storey;
  readonly place: Ref;
  /** Rooms of the storeys before it. */
  readonly roomsBelow: number;
  readonly walls: readonly WallPart[];
  readonly openings: readonly OpeningPart[];
}

/** What tells a thing from others of its kind: where it stands. */
export const contentOf = ({ index }: Storey, { outer }: Polygon): string => `${index} ${outer.join(' ')}`;
