import { withArcs } from '../geometry/ring-arcs.ts';
import { centroid, perimeter } from '../geometry/rings.ts';
import { medianOf } from '../robust-scale.ts';
import type {
  Furniture,
  Gap,
  Opening,
  PointCloud,
  Polygon,
  Room,
  SecondaryBoundary,
  Wall,
} from '../types.ts';
import { type HeightColumns, hasPlane, heightColumns } from './columns/height-columns.ts';
import { localCeiling } from './columns/local-ceiling.ts';
import type { StoreyHeights } from './find-storeys.ts';
import { findFurniture } from './furniture/find-furniture.ts';
import { type FoundOpening, findOpenings, placeOpening } from './openings/find-openings.ts';
import { joinedOpenings } from './openings/joined-openings.ts';
import { type WallStretch, type WallStrip, wallStrip } from './openings/wall-strip.ts';
import { findRooms } from './space/find-rooms.ts';
import { findStructures } from './structures/find-structures.ts';
import { innerWalls } from './walls/inner-walls.ts';
import { type FacePair, pairFaces, sharedFaces } from './walls/pair-faces.ts';
import { primaryOutline } from './walls/primary-outline.ts';
import { edgesOf, type RoomEdge } from './walls/room-edges.ts';
import { roomHeights } from './walls/room-heights.ts';
import { unseenStretches } from './walls/unseen-stretches.ts';

/** How deep an outer wall is looked into, m. */
const DEEPEST = 0.8;
/** How deep an inner wall is looked into where one of its faces was seen, m. */
const DEEPEST_INNER = 0.4;
/** An opening there is as sure as this: with no second face to agree, one jamb or a lintel alone may be furniture's. */
const SHARED_CONFIDENCE = 0.5;
/** Thickness of an inner wall where no two rooms share one, m: what the outline closes over then does not matter. */
const USUAL_INNER = 0.12;
/** Half thickness of a face, m, or so many deviations of its points. */
const FACE_BAND = 0.03;
const FACE_DEVIATIONS = 3;
/** Least noise of a face, m, where none is known. */
const USUAL_NOISE = 0.01;
/** Rows of rooms are read from above: rooms whose middles differ by less than this in height are in one, m. */
const READING_ROW = 2;

/** What a storey holds; metres, plan frame. */
export interface StoreyPlan extends StoreyHeights {
  readonly primary: readonly Polygon[];
  readonly rooms: readonly Room[];
  /** Walls between rooms, and their openings. */
  readonly innerWalls: readonly Wall[];
  readonly innerOpenings: readonly Opening[];
  /** What each edge of `primary` shows of the wall along it, ring by ring. */
  readonly outer: readonly LookedInto[];
  readonly secondary: readonly SecondaryBoundary[];
  /** Stretches of room outlines that no point supports. */
  readonly unseen: readonly Gap[];
  /** Absent unless asked for. */
  readonly furniture?: readonly Furniture[];
}

/** A stretch of wall with its holes, along the face it is looked at from. */
export interface LookedInto {
  readonly stretch: WallStretch;
  readonly found: readonly FoundOpening[];
}

/** What every wall of a storey is looked at with. */
interface Site {
  readonly cloud: PointCloud;
  readonly columns: HeightColumns;
  /** Standard deviation of points across a face, m. */
  readonly noise: number;
  /** Height of the ceiling above the floor, m. */
  readonly height: number;
}

/** Rooms, walls, openings and structures of a storey, and its furniture where that is asked for. */
export function planStorey(
  cloud: PointCloud,
  kept: Uint32Array,
  heights: StoreyHeights,
  hasFurniture = false,
): StoreyPlan {
  const columns = heightColumns(cloud, kept, heights);
  const ceiling = localCeiling(columns);
  const { faces, curves, rooms: found } = findRooms(cloud, columns, ceiling);
  const outlines = inReadingOrder(found.map(({ outline }) => withArcs(outline, curves)));
  const noise = faces.length > 0 ? medianOf(Float64Array.from(faces, (face) => face.noise)) : USUAL_NOISE;
  const site: Site = { cloud, columns, noise, height: heights.ceiling - heights.floor };
  const edges = edgesOf(outlines);
  const pairs = pairFaces(edges);
  const thickest = pairs.reduce((most, { thickness }) => Math.max(most, thickness), USUAL_INNER);
  const primary = primaryOutline(outlines, thickest).map((outline) => withArcs(outline, curves));
  const inner = pairs.map((pair) => lookIntoInner(site, pair));
  const outer = edgesOf(primary).map((edge) => lookIntoOuter(site, edge));
  const shared = sharedFaces(edges).flatMap((pair) => lookIntoShared(site, pair).map(apartFrom(inner)));
  const unseen = edges.map((edge) => unseenOf(site, edge, [...inner, ...shared, ...outer]));
  const byRoom = outlines.map((_, i) => unseen.filter((_, e) => edges[e].owner === i).flat());
  const tall = roomHeights(cloud, columns, outlines);
  const rooms = outlines.map((outline, i) => ({
    name: `Room ${i + 1}`,
    outline,
    height: tall[i],
    confidence: seenShare(outline, byRoom[i]),
  }));
  const secondary = findStructures(site, ceiling, outlines);
  return {
    ...heights,
    primary,
    rooms,
    innerWalls: innerWalls(outlines, primary, pairs, byRoom),
    innerOpenings: joinedOpenings([
      ...inner.flatMap(({ stretch, found: holes }, i) =>
        holes.map((hole) => placeOpening(hole, stretch, pairs[i].thickness / 2)),
      ),
      ...shared.flatMap(({ stretch, found: holes }) =>
        holes.map((hole) => placeOpening(hole, stretch, (hole.reveal || 0) / 2)),
      ),
    ]),
    outer,
    secondary,
    unseen: byRoom.flatMap((gaps, i) => gaps.map((gap) => ({ ...gap, room: `Room ${i + 1}` }))),
    ...(hasFurniture && { furniture: findFurniture({ cloud, columns, ceiling, noise, rooms, secondary }) }),
  };
}

/** Row by row from above, each from left to right. */
function inReadingOrder(outlines: readonly Polygon[]): Polygon[] {
  const placed = outlines.map((outline) => {
    const [x, y] = centroid(outline.outer);
    return { outline, x, row: Math.round(-y / READING_ROW) };
  });
  return placed.sort((a, b) => a.row - b.row || a.x - b.x).map(({ outline }) => outline);
}

function lookIntoInner(site: Site, { face, from, to, thickness }: FacePair): LookedInto {
  const { cloud, columns } = site;
  const stretch = stretchAt(face, from, to, thickness);
  const look = { strip: wallStrip(cloud, columns, stretch), length: to - from, thickness };
  const isThrough = throughAt(columns, stretch, thickness / 2);
  const found = findOpenings({ ...look, noise: site.noise, ceiling: site.height, isThrough });
  return { stretch, found };
}

/**
 * Looks into a wall of which two rooms share the one face that was seen: it may stand on either side of that, and where both
 * show an opening at a place, the surer one holds.
 */
function lookIntoShared(site: Site, { face, back, from, to }: FacePair): LookedInto[] {
  const alongBack = (x: number, y: number) => (x - back.ax) * back.ux + (y - back.ay) * back.uy;
  const begin = alongBack(face.ax + to * face.ux, face.ay + to * face.uy);
  const length = to - from;
  const [ahead, behind] = [
    stretchAt(face, from, to, DEEPEST_INNER),
    stretchAt(back, begin, begin + length, DEEPEST_INNER),
  ].map((stretch): LookedInto => {
    const { cloud, columns, noise, height } = site;
    const look = { strip: wallStrip(cloud, columns, stretch), length, thickness: Infinity };
    const isThrough = throughAt(columns, stretch, USUAL_INNER / 2);
    const found = findOpenings({ ...look, noise, ceiling: height, isThrough });
    return {
      stretch,
      found: found.filter(({ type, confidence }) => type !== 'window' && confidence >= SHARED_CONFIDENCE),
    };
  });
  const isSurer = (own: FoundOpening, others: readonly FoundOpening[], isFirst: boolean) =>
    others.every(({ from: a, to: b, confidence }) => {
      const meets = length - b < own.to && own.from < length - a;
      return !meets || own.confidence > confidence || (isFirst && own.confidence === confidence);
    });
  return [
    { ...ahead, found: ahead.found.filter((own) => isSurer(own, behind.found, true)) },
    { ...behind, found: behind.found.filter((own) => isSurer(own, ahead.found, false)) },
  ];
}

/** Leaves out openings that a look from elsewhere has found already: rooms share a bit of a face beside the wall's own. */
function apartFrom(others: readonly LookedInto[]) {
  const taken = others.flatMap(({ stretch, found }) => found.map((hole) => middleOf(hole, stretch)));
  return ({ stretch, found }: LookedInto): LookedInto => ({
    stretch,
    found: found.filter((hole) => {
      const [x, y] = middleOf(hole, stretch);
      return taken.every(([u, v]) => Math.hypot(x - u, y - v) > (hole.to - hole.from) / 2);
    }),
  });
}

function middleOf({ from, to }: FoundOpening, { x, y, ux, uy }: WallStretch): readonly [number, number] {
  const along = (from + to) / 2;
  return [x + along * ux, y + along * uy];
}

function lookIntoOuter(site: Site, edge: RoomEdge): LookedInto {
  const { cloud, columns, noise, height } = site;
  const stretch = stretchAt(edge, 0, edge.length, DEEPEST);
  const look = { strip: wallStrip(cloud, columns, stretch), length: edge.length, thickness: Infinity };
  const found = findOpenings({ ...look, noise, ceiling: height, isThrough: () => false });
  return { stretch, found };
}

/** The wall along an edge, from one place along it to another. */
function stretchAt({ ax, ay, ux, uy }: RoomEdge, from: number, to: number, depth: number): WallStretch {
  return { x: ax + from * ux, y: ay + from * uy, ux, uy, length: to - from, depth };
}

function throughAt(columns: HeightColumns, { x, y, ux, uy }: WallStretch, deep: number) {
  return (along: number) => hasPlane(columns, x + along * ux + deep * uy, y + along * uy - deep * ux);
}

function unseenOf(site: Site, edge: RoomEdge, looks: readonly LookedInto[]): Gap[] {
  const band = Math.max(FACE_BAND, FACE_DEVIATIONS * site.noise);
  const stretch = stretchAt(edge, 0, edge.length, band);
  const strip: WallStrip = wallStrip(site.cloud, site.columns, stretch);
  return unseenStretches(
    edge,
    strip,
    band,
    looks.flatMap((look) => holesAlong(edge, look)),
  );
}

/** Openings of a wall that go through an edge, by their reach along it. */
function holesAlong(edge: RoomEdge, { stretch, found }: LookedInto): { from: number; to: number }[] {
  const turn = stretch.ux * edge.uy - stretch.uy * edge.ux;
  const aside = (stretch.x - edge.ax) * edge.uy - (stretch.y - edge.ay) * edge.ux;
  if (Math.abs(turn) > 0.05 || Math.abs(aside) > DEEPEST) return [];
  const along = (t: number) =>
    (stretch.x + t * stretch.ux - edge.ax) * edge.ux + (stretch.y + t * stretch.uy - edge.ay) * edge.uy;
  return found.map(({ from, to }) => {
    const [a, b] = [along(from), along(to)];
    return { from: Math.min(a, b), to: Math.max(a, b) };
  });
}

/** Share of an outline's length that points support. */
function seenShare({ outer, holes }: Polygon, unseen: readonly Gap[]): number {
  const length = [outer, ...holes].reduce((sum, ring) => sum + perimeter(ring), 0);
  return Math.max(0, 1 - unseen.reduce((sum, { width }) => sum + width, 0) / length);
}
