import type { PointCloud } from '../../types.ts';
import { type HeightColumns, hasPlane } from '../columns/height-columns.ts';
import { type FacePair, USUAL_THICKNESS } from '../walls/pair-faces.ts';
import type { RoomEdge } from '../walls/room-edges.ts';
import { type FoundOpening, findOpenings } from './find-openings.ts';
import { type WallStretch, wallStrip } from './wall-strip.ts';

/** How deep an outer wall is looked into, m. */
const DEEPEST = 0.8;
/** How deep an inner wall is looked into where one of its faces was seen, m. */
const DEEPEST_INNER = 0.4;
/** An opening there is as sure as this: with no second face to agree, one jamb or a lintel alone may be furniture's. */
const SHARED_CONFIDENCE = 0.5;
/** Edges turned less than this, radians, are of one wall. */
const ALONG = 0.05;

/** A stretch of wall with its holes, along the face it is looked at from. */
export interface LookedInto {
  readonly stretch: WallStretch;
  readonly found: readonly FoundOpening[];
}

/** What every wall of a storey is looked at with. */
export interface LookSite {
  readonly cloud: PointCloud;
  readonly columns: HeightColumns;
  /** Standard deviation of points across a face, m. */
  readonly noise: number;
  /** Height of the ceiling above the floor, m. */
  readonly height: number;
}

/** Looks into a wall between two rooms. O(points of the wall). */
export function lookIntoInner(site: LookSite, { face, from, to, thickness }: FacePair): LookedInto {
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
export function lookIntoShared(site: LookSite, { face, back, from, to }: FacePair): LookedInto[] {
  const alongBack = (x: number, y: number) => (x - back.ax) * back.ux + (y - back.ay) * back.uy;
  const begin = alongBack(face.ax + to * face.ux, face.ay + to * face.uy);
  const length = to - from;
  const [ahead, behind] = [
    stretchAt(face, from, to, DEEPEST_INNER),
    stretchAt(back, begin, begin + length, DEEPEST_INNER),
  ].map((stretch): LookedInto => {
    const { cloud, columns, noise, height } = site;
    const look = { strip: wallStrip(cloud, columns, stretch), length, thickness: Infinity };
    const isThrough = throughAt(columns, stretch, USUAL_THICKNESS / 2);
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
export function apartFrom(others: readonly LookedInto[]) {
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

/** Looks into an outer wall from the room. O(points of the wall). */
export function lookIntoOuter(site: LookSite, edge: RoomEdge): LookedInto {
  const { cloud, columns, noise, height } = site;
  const stretch = stretchAt(edge, 0, edge.length, DEEPEST);
  const look = { strip: wallStrip(cloud, columns, stretch), length: edge.length, thickness: Infinity };
  const found = findOpenings({ ...look, noise, ceiling: height, isThrough: () => false });
  return { stretch, found };
}

/** The wall along an edge, from one place along it to another. */
export function stretchAt(
  { ax, ay, ux, uy }: RoomEdge,
  from: number,
  to: number,
  depth: number,
): WallStretch {
  return { x: ax + from * ux, y: ay + from * uy, ux, uy, length: to - from, depth };
}

function throughAt(columns: HeightColumns, { x, y, ux, uy }: WallStretch, deep: number) {
  return (along: number) => hasPlane(columns, x + along * ux + deep * uy, y + along * uy - deep * ux);
}

/** Openings of a wall that go through an edge, by their reach along it. */
export function holesAlong(edge: RoomEdge, { stretch, found }: LookedInto): { from: number; to: number }[] {
  const turn = stretch.ux * edge.uy - stretch.uy * edge.ux;
  const aside = (stretch.x - edge.ax) * edge.uy - (stretch.y - edge.ay) * edge.ux;
  if (Math.abs(turn) > ALONG || Math.abs(aside) > DEEPEST) return [];
  const along = (t: number) =>
    (stretch.x + t * stretch.ux - edge.ax) * edge.ux + (stretch.y + t * stretch.uy - edge.ay) * edge.uy;
  return found.map(({ from, to }) => {
    const [a, b] = [along(from), along(to)];
    return { from: Math.min(a, b), to: Math.max(a, b) };
  });
}
