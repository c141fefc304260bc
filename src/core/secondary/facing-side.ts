import { perimeter } from '../geometry/rings.ts';
import type { Ring } from '../types.ts';
import { RingEdges } from './ring-edges.ts';
import type { WallFaces } from './wall-faces.ts';

/** The facing side ends where the outline rises by so much of the structure's size: past a corner of 45° half its side. */
const FACING_RISE = 0.15;
/** A place on an outline is seen when a point lies within so many mean gaps along it … */
const SEEN_GAPS = 1.5;
/** … and deviations across it: one of 20 places is missed by chance. */
const SEEN_DEVIATIONS = 3;
/** Within so many deviations of its ends the points may be those of the sides next to it. */
const END_DEVIATIONS = 2;
/** Places looked at along an outline. */
const PLACES = 256;

/**
 * Share of the side of an outline that faces the walls along which points were seen.
 *
 * A column in front of a wall has points there; what grows out of the wall has none.
 *
 * @param xy points of the structure, x, y each, m
 * @returns 0 where the side is too short to tell. O(points · vertices).
 */
export function facingSideSeen(outline: Ring, xy: Float64Array, faces: WallFaces): number {
  const edges = new RingEdges([{ outer: outline, holes: [] }]);
  const length = perimeter(outline);
  const step = length / PLACES;
  const { isSeen, gap } = seenPlaces(edges, xy, length, faces.noise);
  const heights = placeHeights(outline, edges, step, faces);
  let lowest = 0;
  for (let k = 1; k < PLACES; k++) if (heights[k] < heights[lowest]) lowest = k;
  const top = heights.reduce((most, height) => Math.max(most, height), -Infinity);
  const limit = heights[lowest] + Math.max(faces.reach, FACING_RISE * (top - heights[lowest]));
  const from = lowest - runLength(heights, lowest, -1, limit);
  const to = lowest + runLength(heights, lowest, 1, limit);
  const ends = Math.ceil((END_DEVIATIONS * faces.noise + SEEN_GAPS * gap) / step);
  let seen = 0;
  for (let k = from + ends; k <= to - ends; k++) seen += isSeen[(k + PLACES) % PLACES];
  return seen / Math.max(1, to - from - 2 * ends + 1);
}

/** Which of the places along an outline have points near, and the mean way between points along it. */
function seenPlaces(edges: RingEdges, xy: Float64Array, length: number, noise: number) {
  const ways: number[] = [];
  for (let i = 0; i < xy.length; i += 2) {
    edges.project(xy[i], xy[i + 1]);
    if (Math.abs(edges.across) > SEEN_DEVIATIONS * noise) continue;
    ways.push(edges.before[edges.edge] + Math.max(0, Math.min(edges.length[edges.edge], edges.along)));
  }
  const gap = length / Math.max(1, ways.length);
  const step = length / PLACES;
  const reach = Math.ceil((SEEN_GAPS * gap) / step);
  const isSeen = new Uint8Array(PLACES);
  for (const way of ways) {
    const at = Math.round(way / step);
    for (let k = at - reach; k <= at + reach; k++) isSeen[((k % PLACES) + PLACES) % PLACES] = 1;
  }
  return { isSeen, gap };
}

function placeHeights(outline: Ring, edges: RingEdges, step: number, faces: WallFaces): Float64Array {
  const heights = new Float64Array(PLACES);
  let e = 0;
  for (let k = 0; k < PLACES; k++) {
    const way = k * step;
    while (e + 1 < edges.count && way >= edges.before[e + 1]) e++;
    const share = (way - edges.before[e]) / edges.length[e];
    const [i, j] = [2 * e, (2 * e + 2) % outline.length];
    const x = outline[i] + share * (outline[j] - outline[i]);
    heights[k] = faces.heightAt(x, outline[i + 1] + share * (outline[j + 1] - outline[i + 1]));
  }
  return heights;
}

function runLength(heights: Float64Array, from: number, turn: 1 | -1, limit: number): number {
  let steps = 0;
  while (steps < PLACES / 2 && heights[(from + turn * (steps + 1) + PLACES) % PLACES] <= limit) steps++;
  return steps;
}
