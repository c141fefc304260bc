import type { Polygon, SecondaryBoundary, SolidGroup } from '../core/types.ts';
import type { OpeningBox } from './opening-boxes.ts';
import type { TriangleMesh } from './triangle-mesh.ts';

/** A vertical piece of a storey before the secondary boundaries have done their work on it. */
export interface Part {
  /** What its groups are called, before their number: wall, floor, ceiling, column … */
  readonly name: string;
  readonly kind: SolidGroup['kind'];
  readonly storey: number;
  /** Disjoint polygons, metres. */
  readonly base: readonly Polygon[];
  readonly changes: readonly SecondaryBoundary[];
  /** What openings take out of walls; added structures stay. */
  readonly openings: readonly OpeningBox[];
  readonly low: number;
  readonly high: number;
}

/** Makes the closed shells of a part: one for each piece that hangs together. */
export type Engine = (part: Part) => TriangleMesh[];
