/** How secondary boundaries are found ([Stojanovic19] §3.1, Fig. 3), seen from above. */
import { countOf } from '../../core/count-words.ts';
import { type Bounds, boundsOfAll, ringsOf, vertexCount } from '../../core/geometry/rings.ts';
import type { StageResults } from '../../core/stage-results.ts';
import type { ClusterSearch, Polygon, SecondaryResult, SecondaryRound, Slice } from '../../core/types.ts';
import { dots, element, path, pixels } from './marks.ts';
import { mappedRings, outlineMarks } from './outline-pictures.ts';
import { CONTENT_WIDTH, type Drawing, MARGIN } from './page.ts';
import { ACCENT, clusterColour, INK, OKABE_ITO, PALE } from './palette.ts';
import type { PictureFacts } from './picture.ts';
import { shownShare, type TopView, thinned, topView } from './top-view.ts';

type Results = Partial<StageResults>;

const POINT = 2.4;
/** Points the filter drops, and those of the room beneath, px. */
const FAINT_POINT = 1.6;
const [, VERMILION] = OKABE_ITO;
/** The detail around one structure shows this share of its extent to every side. */
const SURROUNDINGS = 0.25;

/** Fig. 3a: the points taken for structures, within the primary boundary. */
export function drawRegion({ slice, regularise, secondary }: Results): Drawing | null {
  if (!slice || !regularise || !secondary) return null;
  const taken = takenClusters(secondary);
  if (taken.length === 0) return null;
  const view = wholeView(slice, regularise.polygons);
  const isTaken = (cluster: number): boolean => taken.includes(cluster);
  const inside = pointsOf(slice, secondary, isTaken);
  const outside = pointsOf(slice, secondary, (cluster) => !isTaken(cluster));
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: [
      dots(view.map(thinned(outside)), { colour: PALE, size: FAINT_POINT }),
      ...primaryMarks(regularise.polygons, view),
      dots(view.map(thinned(inside)), { colour: INK, size: POINT }, { id: 'region-points' }),
    ],
    counts: [
      countOf(taken.length, 'region'),
      `${countOf(inside.length / 2, 'point')} of ${(slice.xy.length / 2).toLocaleString('en-GB')}`,
    ],
    legend: [
      { colour: ACCENT, label: 'Primary boundary' },
      { colour: INK, label: 'Region of a secondary boundary' },
    ],
  };
}

/** Fig. 3b: the slice's points by cluster, each cluster to be picked by its number. */
export function drawClusters({ slice, regularise, secondary }: Results): Drawing | null {
  if (!slice || !secondary) return null;
  const clusters = clustersOf(secondary);
  if (clusters.length < 2) return null;
  const view = wholeView(slice, regularise?.polygons ?? []);
  const groups = clusters.map((cluster) => ({
    cluster,
    points: pointsOf(slice, secondary, (other) => other === cluster),
  }));
  const share = shownShare(slice.xy.length / 2);
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: groups.map(({ cluster, points }) =>
      dots(
        view.map(thinned(points, share)),
        { colour: clusterColour(cluster), size: POINT },
        { id: `cluster-${cluster}`, 'data-pick': `cluster:${cluster}` },
      ),
    ),
    counts: [countOf(clusters.length, 'cluster'), countOf(slice.xy.length / 2, 'point')],
    legend: groups.map(({ cluster, points }) => ({
      colour: clusterColour(cluster),
      label: `${cluster}: ${countOf(points.length / 2, 'point')}`,
    })),
  };
}

/** Fig. 3c: the points Algorithm 1 keeps, their outline, and which of them the stroke along it covers. */
export function drawSecondaryOutline(results: Results, facts: PictureFacts): Drawing | null {
  const { regularise, secondary, plan } = results;
  const found = secondary?.searches.flatMap((search) => roundOf(search, facts.round)) ?? [];
  if (!regularise || found.length === 0) return null;
  const view = topView(grown(boundsOfAll(found.map(({ near }) => near))));
  const strokeWidth = (facts.options ?? plan?.options)?.strokeWidth ?? 0;
  const dropped = found.map(({ near, innermost }) => without(near, innermost));
  const kept = sizeOf(found.map(({ innermost }) => innermost));
  const items = found.flatMap(({ outline, innermost }, i) => [
    ...(outline === null ? [] : [strokeBand(outline, strokeWidth, view)]),
    dots(view.map(dropped[i]), { colour: VERMILION, size: POINT }),
    dots(view.map(innermost), { colour: INK, size: POINT + 0.6 }),
    ...(outline === null ? [] : outlineMarks([{ outer: outline, holes: [] }], view, VERMILION)),
  ]);
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: [clipped([...primaryMarks(regularise.polygons, view), ...items], view)],
    counts: [
      ...(facts.round === undefined ? [] : [`round ${facts.round}`]),
      `${sizeOf(found.map(({ near }) => near)).toLocaleString('en-GB')} points`,
      `${sizeOf(dropped).toLocaleString('en-GB')} dropped`,
      `${kept.toLocaleString('en-GB')} kept`,
    ],
    legend: [
      { colour: VERMILION, label: 'Outline, and the points its stroke covers' },
      { colour: INK, label: 'Innermost points' },
    ],
  };
}

/** Fig. 3d: the secondary boundaries, with the points they were outlined from. */
export function drawSecondary({ slice, regularise, secondary }: Results): Drawing | null {
  if (!slice || !regularise || !secondary || secondary.boundaries.length === 0) return null;
  const { boundaries, searches } = secondary;
  const view = wholeView(slice, regularise.polygons);
  const innermost = searches.flatMap(({ rounds }) => rounds.slice(-1).map((round) => round.innermost));
  const taken = takenClusters(secondary);
  const sources =
    searches.length > 0 ? innermost : [pointsOf(slice, secondary, (cluster) => taken.includes(cluster))];
  const outlines = boundaries.map(({ outline }) => outline);
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: [
      dots(view.map(thinned(slice.xy)), { colour: PALE, size: FAINT_POINT }),
      ...primaryMarks(regularise.polygons, view),
      ...sources.map((xy) => dots(view.map(thinned(xy)), { colour: INK, size: POINT })),
      ...outlineMarks(outlines, view, VERMILION),
    ],
    counts: [
      `${boundaries.length} found`,
      countOf(vertexCount(outlines), 'vertex', 'vertices'),
      countOf(sizeOf(sources), 'point'),
    ],
    legend: [
      { colour: ACCENT, label: 'Primary boundary' },
      { colour: VERMILION, label: 'Secondary boundary' },
    ],
  };
}

/** Numbers of the clusters that hold points. */
export function clustersOf({ clusters }: SecondaryResult): number[] {
  return [...new Set(clusters)].sort((a, b) => a - b);
}

/** Clusters that stand for structures: those searched, or for the robust method all but the walls' 0. */
export function takenClusters({ clusters, searches }: SecondaryResult): number[] {
  if (searches.length > 0) return searches.map(({ cluster }) => cluster);
  return [...new Set(clusters)].filter((cluster) => cluster > 0);
}

function roundOf({ rounds }: ClusterSearch, round = rounds.length): SecondaryRound[] {
  const found = rounds[round - 1];
  return found === undefined || found.near.length === 0 ? [] : [found];
}

function pointsOf(
  { xy }: Slice,
  { clusters }: SecondaryResult,
  isWanted: (cluster: number) => boolean,
): Float64Array {
  const points: number[] = [];
  for (let i = 0; i < clusters.length; i++) if (isWanted(clusters[i])) points.push(xy[2 * i], xy[2 * i + 1]);
  return Float64Array.from(points);
}

/** The points of `all` that are not in `some`, which holds a part of them in the same order. */
function without(all: Float64Array, some: Float64Array): Float64Array {
  const rest: number[] = [];
  let at = 0;
  for (let i = 0; i < all.length; i += 2) {
    if (all[i] === some[at] && all[i + 1] === some[at + 1]) at += 2;
    else rest.push(all[i], all[i + 1]);
  }
  return Float64Array.from(rest);
}

const sizeOf = (parts: readonly Float64Array[]): number =>
  parts.reduce((sum, { length }) => sum + length / 2, 0);

function wholeView({ xy }: Slice, primary: readonly Polygon[]): TopView {
  return topView(boundsOfAll([xy, ...ringsOf(primary)]));
}

function primaryMarks(polygons: readonly Polygon[], view: TopView): string[] {
  return [path(mappedRings(polygons, view), true, { fill: 'none', stroke: ACCENT, 'stroke-width': 1.5 })];
}

/** What the stroke test covers. */
function strokeBand(outline: Float64Array, width: number, view: TopView): string {
  return path([view.map(outline)], true, {
    id: 'stroke',
    fill: 'none',
    stroke: VERMILION,
    'stroke-opacity': 0.18,
    'stroke-width': (width * view.pixelsPerMetre).toFixed(2),
  });
}

function grown({ minX, minY, maxX, maxY }: Bounds): Bounds {
  const by = SURROUNDINGS * Math.max(maxX - minX, maxY - minY);
  return { minX: minX - by, minY: minY - by, maxX: maxX + by, maxY: maxY + by };
}

/** An inner svg element clips without a name that could clash with another picture's. */
function clipped(items: readonly string[], view: TopView): string {
  const [x, y, width, height] = [MARGIN, MARGIN, CONTENT_WIDTH, pixels(view.height - MARGIN)];
  const viewBox = [x, y, width, height].join(' ');
  return element('svg', { x, y, width, height, viewBox }, items);
}
