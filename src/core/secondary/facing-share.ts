import { perimeter } from '../geometry/rings.ts';
import type { Ring } from '../types.ts';
import { RingEdges } from './ring-edges.ts';
import type { WallFaces } from './wall-faces.ts';

/** A side faces the walls as far as its outward normal points at them within 60°. */
const FACING_COSINE = 0.5;
/** A place on an outline is seen when a point of its face lies within so many mean gaps: one of 20 is missed by chance. */
const SEEN_GAPS = 1.5;
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
export function facingShare(outline: Ring, xy: Float64Array, faces: WallFaces): number {
  const edges = new RingEdges([outline]);
  const length = perimeter(outline);
  const step = length / PLACES;
  const { isSeen, gap } = seenPlaces(edges, xy, length, faces.reach);
  const { lowest, isFacing } = facingPlaces(outline, edges, step, faces);
  const from = lowest - runLength(isFacing, lowest, -1);
  const to = lowest + runLength(isFacing, lowest, 1);
  const ends = Math.ceil((END_DEVIATIONS * faces.noise + SEEN_GAPS * gap) / step);
  let seen = 0;
  for (let k = from + ends; k <= to - ends; k++) seen += isSeen[(k + PLACES) % PLACES];
  return seen / Math.max(1, to - from - 2 * ends + 1);
}

/** Which of the places along an outline have points near, and the mean way between points along it. */
function seenPlaces(edges: RingEdges, xy: Float64Array, length: number, faceReach: number) {
  const ways: number[] = [];
  for (let i = 0; i < xy.length; i += 2) {
    edges.project(xy[i], xy[i + 1]);
    if (Math.abs(edges.across) > faceReach) continue;
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

/** Which places look at the walls, and the one of these nearest to them. */
function facingPlaces(outline: Ring, edges: RingEdges, step: number, { noise, heightAt }: WallFaces) {
  const isFacing = new Uint8Array(PLACES);
  let [e, lowest, least] = [0, 0, Infinity];
  const look = Math.max(noise, step);
  for (let k = 0; k < PLACES; k++) {
    while (e + 1 < edges.count && k * step >= edges.before[e + 1]) e++;
    const [i, j] = [2 * e, (2 * e + 2) % outline.length];
    const [dx, dy] = [outline[j] - outline[i], outline[j + 1] - outline[i + 1]].map(
      (d) => d / edges.length[e],
    );
    const along = k * step - edges.before[e];
    const [x, y] = [outline[i] + along * dx, outline[i + 1] + along * dy];
    const height = heightAt(x, y);
    isFacing[k] = heightAt(x + look * dy, y - look * dx) <= height - FACING_COSINE * look ? 1 : 0;
    if (isFacing[k] === 0 || height >= least) continue;
    least = height;
    lowest = k;
  }
  return { lowest, isFacing };
}

/** How many facing places follow one. */
function runLength(isFacing: Uint8Array, from: number, turn: 1 | -1): number {
  let steps = 0;
  while (steps < PLACES / 2 && isFacing[(from + turn * (steps + 1) + PLACES) % PLACES] === 1) steps++;
  return steps;
}
