import type { Opening, PointCloud, Polygon, Room, SecondaryBoundary, Wall } from '../types.ts';
import { findColumns } from './find-columns.ts';
import { type FoundOpening, findOpenings } from './find-openings.ts';
import { findRooms } from './find-rooms.ts';
import type { StoreyHeights } from './find-storeys.ts';
import { type HeightColumns, hasPlane, heightColumns } from './height-columns.ts';
import { localCeiling } from './local-ceiling.ts';
import { type FacePair, pairFaces } from './pair-faces.ts';
import { primaryOutline } from './primary-outline.ts';
import { edgesOf, type RoomEdge } from './room-edges.ts';
import { type WallStretch, wallStrip } from './wall-strip.ts';

/** How deep an outer wall is looked into, m. */
const DEEPEST = 0.8;
/** Thickness of an inner wall where none is known, m. */
const USUAL_INNER = 0.12;

export interface StoreyPlan {
  readonly primary: readonly Polygon[];
  readonly rooms: readonly Room[];
  readonly walls: readonly Wall[];
  readonly openings: readonly Opening[];
  readonly secondary: readonly SecondaryBoundary[];
}

export function planStorey(cloud: PointCloud, kept: Uint32Array, heights: StoreyHeights): StoreyPlan {
  const columns = heightColumns(cloud, kept, heights);
  const found = findRooms(cloud, columns);
  const outlines = found.rooms.map(({ outline }) => outline);
  const noise = medianNoise(found.faces.map((face) => face.noise));
  const ceiling = heights.ceiling - heights.floor;
  const pairs = pairFaces(edgesOf(outlines));
  const thickest = pairs.reduce((most, { thickness }) => Math.max(most, thickness), USUAL_INNER);
  const primary = primaryOutline(outlines, thickest);
  const openings: Opening[] = [];
  const walls: Wall[] = [];
  for (const pair of pairs) {
    const { face, from, to, thickness } = pair;
    const stretch = { ...startOf(face, from), ux: face.ux, uy: face.uy, length: to - from, depth: thickness };
    const strip = wallStrip(cloud, columns, stretch);
    for (const opening of findOpenings({
      strip,
      length: to - from,
      thickness,
      noise,
      ceiling,
      isThrough: throughAt(columns, stretch, thickness / 2),
    })) {
      openings.push(placed(opening, stretch, thickness / 2));
    }
    walls.push({ outline: { outer: pairRing(pair), holes: [] }, thickness, confidence: 1 });
  }
  const outer = edgesOf(primary).map((edge) => {
    const stretch = { x: edge.ax, y: edge.ay, ux: edge.ux, uy: edge.uy, length: edge.length, depth: DEEPEST };
    const strip = wallStrip(cloud, columns, stretch);
    return {
      edge,
      stretch,
      openings: findOpenings({
        strip,
        length: edge.length,
        thickness: Infinity,
        noise,
        ceiling,
        isThrough: () => false,
      }),
    };
  });
  const reveals = outer
    .flatMap(({ openings: own }) => own.map(({ reveal }) => reveal))
    .filter((r) => r > 0.1);
  const usual = reveals.length > 0 ? reveals.sort((a, b) => a - b)[reveals.length >> 1] : 0.3;
  for (const { stretch, openings: own } of outer) {
    const mine = own
      .map(({ reveal }) => reveal)
      .filter((r) => r > 0.1)
      .sort((a, b) => a - b);
    const thickness = mine.length > 0 ? mine[mine.length >> 1] : usual;
    for (const opening of own) openings.push(placed(opening, stretch, thickness / 2));
  }
  const rooms = found.rooms.map(({ outline }, i) => ({
    name: `Room ${i + 1}`,
    outline,
    height: ceiling,
    confidence: 1,
  }));
  const secondary = findColumns(cloud, columns, localCeiling(columns), outlines);
  return { primary, rooms, walls, openings, secondary };
}

function throughAt(columns: HeightColumns, { x, y, ux, uy }: WallStretch, deep: number) {
  return (along: number) => hasPlane(columns, x + along * ux + deep * uy, y + along * uy - deep * ux);
}

function medianNoise(values: number[]): number {
  return values.sort((a, b) => a - b)[values.length >> 1] ?? 0.01;
}

function startOf(edge: RoomEdge, from: number) {
  return { x: edge.ax + from * edge.ux, y: edge.ay + from * edge.uy };
}

function placed(
  opening: FoundOpening,
  { x, y, ux, uy }: { readonly x: number; readonly y: number; readonly ux: number; readonly uy: number },
  deep: number,
): Opening {
  const at = (along: number) => [x + along * ux + deep * uy, y + along * uy - deep * ux] as const;
  const { type, from, to, sill, head, confidence } = opening;
  return { type, from: at(from), to: at(to), sill, head, confidence };
}

function pairRing({ face, back, from, to }: FacePair): Float64Array {
  const onBack = (along: number): readonly [number, number] => {
    const [x, y] = [face.ax + along * face.ux, face.ay + along * face.uy];
    const t = (x - back.ax) * back.ux + (y - back.ay) * back.uy;
    return [back.ax + t * back.ux, back.ay + t * back.uy];
  };
  const [a, b] = [startOf(face, from), startOf(face, to)];
  const [c, d] = [onBack(to), onBack(from)];
  // The room is on the face's left, so the wall is on its right.
  return Float64Array.of(a.x, a.y, d[0], d[1], c[0], c[1], b.x, b.y);
}
