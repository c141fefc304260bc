import type { StageContext } from '../context.ts';
import { pointInPolygon } from '../geometry/rings.ts';
import { type Clusters, clusterPoints } from '../kmeans.ts';
import type { Options } from '../params.ts';
import { createRandom, type Random } from '../random.ts';
import type { ClusterSearch, Polygon, Ring, SecondaryRound, Slice } from '../types.ts';
import { averageDistance } from './average-distance.ts';
import { outlinePoints } from './outline-points.ts';
import { pointsInStroke } from './points-in-stroke.ts';
import {
  distanceToPolygons,
  type FoundStructure,
  pickPoints,
  type StructureSearch,
  typeOf,
} from './structure.ts';

/**
 * A cluster with more than this share of its points within a stroke of the primary boundary holds walls only.
 */
const HUGGING_SHARE = 0.9;

/**
 * Secondary boundaries as the paper finds them ([Stojanovic19] §3.1, Algorithms 1 and 2).
 *
 * k-means with one cluster more than structures; the cluster with the most points is a structure's. With
 * several asked for, the next largest follow, without those that hug the primary boundary: one cluster is
 * left for the walls. Then GenerateSecondaryBounds and GenBoundary, in `secondaryRounds` rounds, each inside
 * the boundary of the one before.
 */
export function findByClusters(
  slice: Slice,
  primary: readonly Polygon[],
  options: Options,
  context: StageContext,
): StructureSearch {
  const clusters = clusterPoints(slice.xy, options.secondaryCount + 1, options.seed);
  const random = createRandom(options.seed);
  const found: FoundStructure[] = [];
  const searches: ClusterSearch[] = [];
  for (const cluster of structureClusters(slice, clusters, primary, options)) {
    const points = pickPoints(slice.xy, (i) => clusters.clusterOf[i] === cluster);
    const centre = [clusters.centres[2 * cluster], clusters.centres[2 * cluster + 1]] as const;
    const { structure, rounds } = refine({ points, centre, random }, primary, options, context);
    searches.push({ cluster, rounds });
    if (structure) found.push(structure);
    context.progress(searches.length / options.secondaryCount);
  }
  return { clusters: clusters.clusterOf, found, searches };
}

/** Numbers of the clusters taken for structures, most points first. */
function structureClusters(
  { xy }: Slice,
  { clusterOf, sizes }: Clusters,
  primary: readonly Polygon[],
  { secondaryCount, strokeWidth }: Options,
): number[] {
  const bySize = [...sizes.keys()].sort((a, b) => sizes[b] - sizes[a] || a - b);
  if (secondaryCount === 1) return bySize.slice(0, 1);
  const near = new Uint32Array(sizes.length);
  for (let i = 0; i < clusterOf.length; i++) {
    if (distanceToPolygons(xy[2 * i], xy[2 * i + 1], primary) <= strokeWidth) near[clusterOf[i]]++;
  }
  return bySize.filter((k) => near[k] <= HUGGING_SHARE * sizes[k]).slice(0, secondaryCount);
}

/** Points of one cluster, x, y each, and its k-means centre. */
interface Cluster {
  readonly points: Float64Array;
  readonly centre: readonly [x: number, y: number];
  readonly random: Random;
}

function refine(
  cluster: Cluster,
  primary: readonly Polygon[],
  options: Options,
  context: StageContext,
): { readonly structure: FoundStructure | null; readonly rounds: readonly SecondaryRound[] } {
  let previous = primary;
  let structure: FoundStructure | null = null;
  const rounds: SecondaryRound[] = [];
  for (let round = 0; round < options.secondaryRounds; round++) {
    const near = generateSecondaryBounds(cluster, previous, options);
    const outline = outlinePoints(near, options, context);
    const innermost = outline ? pointsOffStroke(near, outline, options, context) : near.subarray(0, 0);
    const result = outlinePoints(innermost, options, context);
    rounds.push({ near, outline, innermost, result });
    if (!result) break;
    structure = { outline: result, type: typeOf(result, innermost), points: innermost.length / 2 };
    previous = [{ outer: result, holes: [] }];
  }
  return { structure, rounds };
}

/**
 * Algorithm 1: the points inside the previous boundary and closer to the cluster's centre than the cluster's
 * points lie apart on average. The paper compares a squared distance with a plain one; here both are plain.
 */
function generateSecondaryBounds(
  { points, centre, random }: Cluster,
  previous: readonly Polygon[],
  { secondarySample }: Options,
): Float64Array {
  const average = averageDistance(points, secondarySample, random);
  return pickPoints(points, (i) => {
    const [x, y] = [points[2 * i], points[2 * i + 1]];
    if (Math.hypot(x - centre[0], y - centre[1]) >= average) return false;
    return previous.some((polygon) => pointInPolygon(x, y, polygon) > 0);
  });
}

/** Algorithm 2: the points that a stroke along their concave outline does not cover. */
function pointsOffStroke(
  points: Float64Array,
  outline: Ring,
  { strokeWidth, pixelsPerMetre }: Options,
  { strokeTest }: StageContext,
): Float64Array {
  const isCovered = pointsInStroke(points, outline, { width: strokeWidth, pixelsPerMetre, strokeTest });
  return pickPoints(points, (i) => isCovered[i] === 0);
}
