import type { StageContext } from '../context.ts';
import { countOf } from '../count-words.ts';
import { pointInPolygon, ringsOf } from '../geometry/rings.ts';
import { type Clusters, clusterPoints } from '../kmeans.ts';
import type { Options } from '../params.ts';
import { createRandom, type Random } from '../random.ts';
import type { ClusterSearch, Polygon, Ring, SecondaryRound, Slice } from '../types.ts';
import { averageDistance } from './average-distance.ts';
import { outlinePoints } from './outline-points.ts';
import { pointsInStroke } from './points-in-stroke.ts';
import { proposeCount } from './propose-count.ts';
import { RingEdges } from './ring-edges.ts';
import { type FoundStructure, pickPoints, type StructureSearch, typeOf } from './structure.ts';

/**
 * A cluster with more than this share of its points within a stroke of the primary boundary holds walls only.
 */
const HUGGING_SHARE = 0.9;

/**
 * Secondary boundaries as the paper finds them ([Stojanovic19] §3.1, Algorithms 1 and 2).
 *
 * k-means with one cluster more than structures; the cluster with the most points is a structure's, unless
 * `secondaryCluster` names another. With several asked for, the next largest follow, without those that hug the
 * primary boundary: one cluster is left for the walls. Then GenerateSecondaryBounds and GenBoundary, in
 * `secondaryRounds` rounds, each inside the boundary of the one before.
 */
export function findByClusters(
  slice: Slice,
  primary: readonly Polygon[],
  options: Options,
  context: StageContext,
): StructureSearch {
  const { secondaryCount, seed } = options;
  const wanted = secondaryCount === 'auto' ? proposeCount(slice.xy, seed) : secondaryCount;
  const clusters = clusterPoints(slice.xy, wanted + 1, seed);
  warnOfTooMany(clusters, wanted, context);
  const random = createRandom(seed);
  const found: FoundStructure[] = [];
  const searches: ClusterSearch[] = [];
  for (const cluster of structureClusters(slice, clusters, wanted, { primary, options, context })) {
    const points = pickPoints(slice.xy, (i) => clusters.clusterOf[i] === cluster);
    const centre = [clusters.centres[2 * cluster], clusters.centres[2 * cluster + 1]] as const;
    const { structure, rounds } = refine({ points, centre, random }, primary, options, context);
    searches.push({ cluster, rounds });
    if (structure) found.push(structure);
    warnOfNoOutline(cluster, points.length / 2, rounds, context);
    context.progress(searches.length / wanted);
  }
  return { clusters: clusters.clusterOf, wanted, found, searches };
}

function warnOfTooMany({ sizes }: Clusters, wanted: number, context: StageContext): void {
  if (sizes.length === wanted + 1) return;
  context.warn({
    code: 'secondary/too-many',
    message: `${countOf(wanted, 'secondary boundary needs', 'secondary boundaries need')} ${wanted + 1} clusters, but the slice has only ${countOf(sizes.length, 'distinct point')}.`,
    hint: 'Ask for fewer secondary boundaries, or take a level with more points.',
  });
}

/** A round without an outline ends the search; the one before it, if any, counts. */
function warnOfNoOutline(
  cluster: number,
  points: number,
  rounds: readonly SecondaryRound[],
  context: StageContext,
): void {
  const { near, outline, innermost, result } = rounds[rounds.length - 1];
  if (result) return;
  const [left, hint] = outline
    ? [
        `${countOf(innermost.length / 2, 'point')} that the stroke leaves`,
        'Try a thinner stroke, or the robust method.',
      ]
    : [
        `${countOf(near.length / 2, 'point')} inside the boundary before and near its centre`,
        'Pick another cluster, or ask for another number of secondary boundaries.',
      ];
  const end =
    rounds.length === 1 ? 'it gives no secondary boundary' : `round ${rounds.length - 1} is taken instead`;
  context.warn({
    code: 'secondary/no-outline',
    message: `Cluster ${cluster} has ${countOf(points, 'point')}, but in round ${rounds.length} there is no area around the ${left}; ${end}.`,
    hint,
  });
}

interface ClusterChoice {
  readonly primary: readonly Polygon[];
  readonly options: Options;
  readonly context: StageContext;
}

/** Numbers of the clusters taken for structures: the one picked first, then by points, most first. */
function structureClusters(
  slice: Slice,
  { clusterOf, sizes }: Clusters,
  wanted: number,
  { primary, options, context }: ClusterChoice,
): number[] {
  const bySize = [...sizes.keys()].sort((a, b) => sizes[b] - sizes[a] || a - b);
  const { secondaryCluster } = options;
  if (secondaryCluster !== 'auto' && secondaryCluster >= sizes.length) {
    context.warn({
      code: 'secondary/no-such-cluster',
      message: `Cluster ${secondaryCluster} was picked, but clusters are numbered from 0 to ${sizes.length - 1}; the one with the most points is taken.`,
      hint: 'Pick one of them, or ask for more secondary boundaries.',
    });
  }
  const picked = bySize.filter((cluster) => cluster === secondaryCluster);
  const rest = bySize.filter((cluster) => cluster !== secondaryCluster);
  if (wanted === 1) return [...picked, ...rest].slice(0, 1);
  const isWall = wallClusters(slice, { clusterOf, sizes }, primary, options);
  return [...picked, ...rest.filter((cluster) => !isWall[cluster])].slice(0, wanted);
}

/** Which clusters hug the primary boundary. */
function wallClusters(
  { xy }: Slice,
  { clusterOf, sizes }: Pick<Clusters, 'clusterOf' | 'sizes'>,
  primary: readonly Polygon[],
  { strokeWidth }: Options,
): boolean[] {
  const near = new Uint32Array(sizes.length);
  const edges = new RingEdges(ringsOf(primary));
  for (let i = 0; i < clusterOf.length; i++) {
    if (edges.distanceTo(xy[2 * i], xy[2 * i + 1]) <= strokeWidth) near[clusterOf[i]]++;
  }
  return Array.from(sizes, (size, cluster) => near[cluster] > HUGGING_SHARE * size);
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
