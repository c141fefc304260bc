import { distanceToRing } from '../../fixtures/simulator/ring.ts';
import { paperSlice } from '../../fixtures/simulator/slices.ts';
import { alphaShape } from '../../src/core/boundary/alpha-shape.ts';
import { distinctPoints } from '../../src/core/geometry/point-order.ts';
import { pointInPolygon } from '../../src/core/geometry/rings.ts';
import type { Polygon } from '../../src/core/types.ts';
import { type PaperSet, structureFaces } from './paper-sets.ts';

/** A point this near a face was scanned on it: four deviations in x and y of the sets' noise, px. */
const ON_FACE = 4 * 1.2 * Math.SQRT2;
/** α is tried at every whole pixel up to this. */
const LARGEST = 200;

/** For which α, in whole pixels of circumradius, an α-shape tells a room's structure from its walls. */
export interface AlphaRange {
  /** "Smallest value with which the SB is […] completely detected and separated" ([Stojanovic19] §4); null: none. */
  readonly separateFrom: number | null;
  readonly separateTo: number | null;
  /** Pieces the points fall into at `separateFrom`. */
  readonly pieces: number;
  /** Smallest α at which all wall points are in one piece. */
  readonly wallsWholeFrom: number | null;
}

/** Delaunay triangulation once an α; a slice has few hundred points. */
export function alphaRange({ name }: PaperSet): AlphaRange {
  const faces = structureFaces(name);
  const points = distinctPoints(paperSlice(name).xy);
  const isStructure = (i: number) =>
    faces.some((face) => distanceToRing(face, points[2 * i], points[2 * i + 1]) <= ON_FACE);
  const all = Array.from({ length: points.length / 2 }, (_, i) => i);
  const onStructure = all.filter(isStructure);
  const onWall = all.filter((i) => !isStructure(i));
  const covers = (piece: Polygon) => (i: number) =>
    pointInPolygon(points[2 * i], points[2 * i + 1], piece) >= 0;
  let range: AlphaRange = { separateFrom: null, separateTo: null, pieces: 0, wallsWholeFrom: null };
  for (let alpha = 1; alpha <= LARGEST; alpha++) {
    const shape = alphaShape(points, alpha);
    const apart = shape.some((piece) => onStructure.every(covers(piece)) && !onWall.some(covers(piece)));
    if (apart && range.separateFrom === null) {
      range = { ...range, separateFrom: alpha, pieces: shape.length };
    }
    if (apart) range = { ...range, separateTo: alpha };
    if (range.wallsWholeFrom === null && shape.some((piece) => onWall.every(covers(piece)))) {
      range = { ...range, wallsWholeFrom: alpha };
    }
  }
  return range;
}
