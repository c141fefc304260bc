import { findBoundary } from '../boundary.ts';
import type { StageContext } from '../context.ts';
import type { Options } from '../params.ts';
import { simplifyRing } from '../regularise/simplify-ring.ts';
import type { Polygon, Slice } from '../types.ts';
import { evenSample } from './even-sample.ts';
import { RingEdges } from './ring-edges.ts';

/** A wall's points lie within this many deviations of its outermost one. */
const BAND_DEVIATIONS = 6;
/** … and of its face within this many: one of 700 lies further in. */
const FACE_DEVIATIONS = 3;
/** Drawn lines scatter by rounding only: what is nearer than this many spacings is on them. */
const LEAST_REACH_SPACINGS = 0.1;
/** Rounds in which the band grows; each at most by 1.7, so 10 cover three orders of magnitude. */
const BAND_ROUNDS = 10;
/** Points that tell the noise, and the faces, at most: more change them by less than a tenth of the noise. */
const NOISE_SAMPLE = 4_000;
const FACE_SAMPLE = 20_000;
/** Rounds of a line fit, each over the points near the line before. */
const LINE_ROUNDS = 3;
/** Fewer points tell no line. */
const FEWEST_ON_LINE = 8;
/** Standard deviation by median deviation of a normal distribution. */
const DEVIATION_BY_MEDIAN = 1.4826;

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
 * Wall faces as lines through the middle of their points.
 *
 * Ours. The outline runs along the outermost points of a wall, so lines are fitted to the points that each of its
 * edges stands for. How far these scatter is told by neighbours along the outline ({@link noiseAlong}): spacing says
 * nothing about it, so sparse and dense slices are treated alike. O(sample · edges) beside the outline.
 */
export function findWallFaces(slice: Slice, options: Options, context: StageContext): WallFaces {
  const own: Options = { ...options, boundary: 'gift-opening' };
  const { polygons } = findBoundary(slice, own, { ...context, warn: () => {} });
  const noise = noiseAlong(
    evenSample(slice.xy, NOISE_SAMPLE),
    slice.spacing,
    simplified(polygons, slice.spacing),
  );
  const edges = new RingEdges(simplified(polygons, 2 * noise));
  const lines = fitLines(evenSample(slice.xy, FACE_SAMPLE), edges, noise);
  return {
    noise,
    reach: Math.max(FACE_DEVIATIONS * noise, LEAST_REACH_SPACINGS * slice.spacing),
    heightAt(x, y) {
      edges.project(x, y);
      const { edge, along, across } = edges;
      const on = Math.max(0, Math.min(edges.length[edge], along));
      const height = across - lines.offset[edge] - lines.slope[edge] * on;
      // Past a corner of the walls the line of an edge runs through the room: the outline tells in from out.
      return along === on ? height : (across < 0 ? -1 : 1) * Math.hypot(height, along - on);
    },
  };
}

function simplified(polygons: readonly Polygon[], epsilon: number): readonly Polygon[] {
  const tolerances = { epsilon, areaEpsilon: 0, passes: ['douglas-peucker'] } as const;
  return polygons.map(({ outer }) => ({ outer: simplifyRing(outer, tolerances), holes: [] }));
}

/**
 * Standard deviation of points across the walls, by the median distance of a point to the line between its neighbours
 * along the outline: corners and curves weigh little, structures none but where they stand in the band.
 */
function noiseAlong(xy: Float64Array, spacing: number, polygons: readonly Polygon[]): number {
  const edges = new RingEdges(polygons);
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

/** The line of each edge's points: across = offset + slope · along. */
interface Lines {
  readonly offset: Float64Array;
  readonly slope: Float64Array;
}

function fitLines(xy: Float64Array, edges: RingEdges, noise: number): Lines {
  const along: number[][] = Array.from({ length: edges.count }, () => []);
  const across: number[][] = Array.from({ length: edges.count }, () => []);
  for (let i = 0; i < xy.length; i += 2) {
    edges.project(xy[i], xy[i + 1]);
    if (Math.abs(edges.across) > BAND_DEVIATIONS * noise) continue;
    along[edges.edge].push(edges.along);
    across[edges.edge].push(edges.across);
  }
  const usual = median(across.flat());
  const lines = { offset: new Float64Array(edges.count).fill(usual), slope: new Float64Array(edges.count) };
  for (let e = 0; e < edges.count; e++) {
    for (let round = 0; round < LINE_ROUNDS; round++)
      fitLine(along[e], across[e], e, lines, FACE_DEVIATIONS * noise);
  }
  return lines;
}

/** One round of least squares over the points near the line so far. */
function fitLine(
  along: readonly number[],
  across: readonly number[],
  e: number,
  { offset, slope }: Lines,
  reach: number,
): void {
  let [n, t, d, tt, td] = [0, 0, 0, 0, 0];
  for (let k = 0; k < along.length; k++) {
    if (Math.abs(across[k] - offset[e] - slope[e] * along[k]) > reach) continue;
    n++;
    t += along[k];
    d += across[k];
    tt += along[k] ** 2;
    td += along[k] * across[k];
  }
  const spread = n * tt - t * t;
  if (n < FEWEST_ON_LINE || spread <= 0) return;
  slope[e] = (n * td - t * d) / spread;
  offset[e] = (d - slope[e] * t) / n;
}

function median(values: number[]): number {
  if (values.length === 0) return 0;
  values.sort((a, b) => a - b);
  return values[values.length >> 1];
}
