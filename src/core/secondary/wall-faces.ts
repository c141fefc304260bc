import { findBoundary } from '../boundary.ts';
import type { StageContext } from '../context.ts';
import type { Options } from '../params.ts';
import { restoreCorners } from '../regularise/restore-corners.ts';
import { simplifyRing } from '../regularise/simplify-ring.ts';
import { DEVIATION_BY_MEDIAN } from '../robust-scale.ts';
import type { Ring, Slice } from '../types.ts';
import { evenSample } from './even-sample.ts';
import { RingEdges } from './ring-edges.ts';

/** A wall's points lie within this many deviations of its outermost one. */
const BAND_DEVIATIONS = 6;
/** … and of its face within this many: one of 700 lies further in. */
const FACE_DEVIATIONS = 3;
/** Drawn lines scatter by rounding only; taken for noise this share of the spacing tells no points apart. */
const LEAST_NOISE_SPACINGS = 0.03;
/** Rounds in which the band grows; each at most by 1.7, so 10 cover three orders of magnitude. */
const BAND_ROUNDS = 10;
/** Points that tell the noise at most: more change it by less than a tenth. */
const SAMPLE = 4_000;

/** The faces of the walls around a slice. */
export interface WallFaces {
  /** Standard deviation of the points across a face, m. */
  readonly noise: number;
  /** Points this near to a face are on it, m. */
  readonly reach: number;
  /** Distance of a place in the room to the nearest face, m; negative behind it. */
  heightAt(x: number, y: number): number;
}

/**
 * Wall faces as the outline brought in to the middle of their points.
 *
 * Ours. The outline runs along the outermost points of a wall; {@link restoreCorners} fits lines to the points that each of
 * its edges stands for. How far these scatter is told by neighbours along the outline ({@link noiseAlong}): spacing says
 * nothing about it, so sparse and dense slices are treated alike. O(points · log edges) beside the outline.
 */
export function findWallFaces(slice: Slice, options: Options, context: StageContext): WallFaces {
  const own: Options = { ...options, boundary: 'gift-opening' };
  const { polygons } = findBoundary(slice, own, { ...context, warn: () => {} });
  const hulls = polygons.map(({ outer }) => outer);
  const found = noiseAlong(evenSample(slice.xy, SAMPLE), slice.spacing, simplified(hulls, slice.spacing));
  const noise = Math.max(found, LEAST_NOISE_SPACINGS * slice.spacing);
  const edges = new RingEdges(
    restoreCorners(simplified(hulls, 2 * noise), hulls, slice, { bandwidth: noise }),
  );
  return {
    noise,
    reach: FACE_DEVIATIONS * noise,
    heightAt(x, y) {
      edges.project(x, y);
      return (edges.across < 0 ? -1 : 1) * Math.hypot(edges.across, edges.past);
    },
  };
}

function simplified(rings: readonly Ring[], epsilon: number): readonly Ring[] {
  return rings.map((ring) => simplifyRing(ring, { epsilon, areaEpsilon: 0, passes: ['douglas-peucker'] }));
}

/**
 * Standard deviation of points across the walls, by the median distance of a point to the line between its neighbours
 * along the outline: corners and curves weigh little, structures none but where they stand in the band.
 */
function noiseAlong(xy: Float64Array, spacing: number, rings: readonly Ring[]): number {
  const edges = new RingEdges(rings);
  const n = xy.length / 2;
  const [way, depth] = [new Float64Array(n), new Float64Array(n)];
  for (let i = 0; i < n; i++) {
    edges.project(xy[2 * i], xy[2 * i + 1]);
    way[i] = edges.before[edges.edge] + edges.along;
    depth[i] = edges.across;
  }
  const order = Uint32Array.from(way.keys()).sort((a, b) => way[a] - way[b] || depth[a] - depth[b]);
  let band = 2 * spacing;
  let noise = 0;
  for (let round = 0; round < BAND_ROUNDS; round++) {
    noise = scatter(
      order.filter((i) => Math.abs(depth[i]) <= band),
      way,
      depth,
    );
    if (BAND_DEVIATIONS * noise <= band) break;
    band = BAND_DEVIATIONS * noise;
  }
  return noise;
}

function scatter(order: Uint32Array, way: Float64Array, depth: Float64Array): number {
  const distances: number[] = [];
  for (let k = 1; k + 1 < order.length; k++) {
    const [a, b, c] = [order[k - 1], order[k], order[k + 1]];
    const share = way[c] > way[a] ? (way[b] - way[a]) / (way[c] - way[a]) : 0.5;
    const distance = depth[b] - depth[a] - share * (depth[c] - depth[a]);
    distances.push(Math.abs(distance) / Math.sqrt(1 + share ** 2 + (1 - share) ** 2));
  }
  return DEVIATION_BY_MEDIAN * median(distances);
}

function median(values: number[]): number {
  if (values.length === 0) return 0;
  values.sort((a, b) => a - b);
  return values[values.length >> 1];
}
