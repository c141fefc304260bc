import { withArcs } from '../geometry/ring-arcs.ts';
import { perimeter } from '../geometry/rings.ts';
import { medianOf } from '../robust-scale.ts';
import { automaticName } from '../room-names.ts';
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
import { heightColumns } from './columns/height-columns.ts';
import { localCeiling } from './columns/local-ceiling.ts';
import type { StoreyHeights } from './find-storeys.ts';
import { findFurniture } from './furniture/find-furniture.ts';
import { placeOpening } from './openings/find-openings.ts';
import { joinedOpenings } from './openings/joined-openings.ts';
import {
  apartFrom,
  holesAlong,
  type LookedInto,
  type LookSite,
  lookIntoInner,
  lookIntoOuter,
  lookIntoShared,
  stretchAt,
} from './openings/look-into-walls.ts';
import { wallStrip } from './openings/wall-strip.ts';
import { inReadingOrder } from './reading-order.ts';
import { findRooms } from './space/find-rooms.ts';
import { aroundStructures } from './structures/around-structures.ts';
import { findStructures } from './structures/find-structures.ts';
import { innerWalls } from './walls/inner-walls.ts';
import { pairFaces, sharedFaces, USUAL_THICKNESS } from './walls/pair-faces.ts';
import { primaryOutline } from './walls/primary-outline.ts';
import { edgesOf, type RoomEdge } from './walls/room-edges.ts';
import { roomHeights } from './walls/room-heights.ts';
import { CEILING_LOOK, unseenStretches } from './walls/unseen-stretches.ts';

/** Half thickness of a face, m, or so many deviations of its points. */
const FACE_BAND = 0.03;
const FACE_DEVIATIONS = 3;
/** Least noise of a face, m, where none is known. */
const USUAL_NOISE = 0.01;

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
  const traced = inReadingOrder(found.map(({ outline }) => outline));
  const noise = faces.length > 0 ? medianOf(Float64Array.from(faces, (face) => face.noise)) : USUAL_NOISE;
  const site: LookSite = { cloud, columns, noise, height: heights.ceiling - heights.floor };
  const secondary = findStructures(site, ceiling, traced);
  const outlines = traced.map((outline) => withArcs(aroundStructures(outline, secondary), curves));
  const edges = edgesOf(outlines);
  const pairs = pairFaces(edges);
  const thickest = pairs.reduce((most, { thickness }) => Math.max(most, thickness), USUAL_THICKNESS);
  const primary = primaryOutline(outlines, thickest).map((outline) => withArcs(outline, curves));
  const inner = pairs.map((pair) => lookIntoInner(site, pair));
  const outer = edgesOf(primary).map((edge) => lookIntoOuter(site, edge));
  const shared = sharedFaces(edges).flatMap((pair) => lookIntoShared(site, pair).map(apartFrom(inner)));
  const unseen = edges.map((edge) => unseenOf(site, edge, [...inner, ...shared, ...outer]));
  const byRoom = outlines.map((_, i) => unseen.filter((_, e) => edges[e].owner === i).flat());
  const tall = roomHeights(cloud, columns, outlines);
  const rooms = outlines.map((outline, i) => ({
    name: automaticName(i),
    outline,
    height: tall[i],
    confidence: seenShare(outline, byRoom[i]),
  }));
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
        holes.map((hole) => placeOpening(hole, stretch, Math.min(hole.reveal || 0, USUAL_THICKNESS) / 2)),
      ),
    ]),
    outer,
    secondary,
    unseen: byRoom.flatMap((gaps, i) => gaps.map((gap) => ({ ...gap, room: automaticName(i) }))),
    ...(hasFurniture && { furniture: findFurniture({ cloud, columns, ceiling, noise, rooms, secondary }) }),
  };
}

function unseenOf(site: LookSite, edge: RoomEdge, looks: readonly LookedInto[]): Gap[] {
  const band = Math.max(FACE_BAND, FACE_DEVIATIONS * site.noise);
  const { cloud, columns } = site;
  const stretch = stretchAt(edge, 0, edge.length, band);
  const [x, y] = [stretch.x - CEILING_LOOK * stretch.uy, stretch.y + CEILING_LOOK * stretch.ux];
  const above = { ...columns, points: columns.overPoints, start: columns.overStart };
  return unseenStretches(
    edge,
    {
      face: wallStrip(cloud, columns, stretch),
      ceiling: wallStrip(cloud, above, { ...stretch, x, y, depth: CEILING_LOOK + band }),
    },
    band,
    looks.flatMap((look) => holesAlong(edge, look)),
  );
}

/** Share of an outline's length that points support. */
function seenShare({ outer, holes }: Polygon, unseen: readonly Gap[]): number {
  const length = [outer, ...holes].reduce((sum, ring) => sum + perimeter(ring), 0);
  return Math.max(0, 1 - unseen.reduce((sum, { width }) => sum + width, 0) / length);
}
