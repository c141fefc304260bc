import { eroded, filled, type Pixel, type PixelMap } from './pixel-map.ts';

export interface Structured3dScores {
  readonly roomPrecision: number;
  readonly roomRecall: number;
  readonly cornerPrecision: number;
  readonly cornerRecall: number;
  readonly anglePrecision: number;
  readonly angleRecall: number;
}

type Outline = readonly Pixel[];

/** A room is found above this IoU. */
const MATCH_IOU = 0.5;
/** px */
const CORNER_REACH = 10;
const ANGLE_REACH_DEG = 5;
/** The protocol adds it wherever it divides by a length. */
const EPSILON = 1e-4;

/**
 * The protocol the learned methods report on Structured3D: rooms on a map of 256 px, corners within 10 px, angles within
 * 5°. Precision of corners and angles counts all found corners, those of wrong rooms too.
 *
 * [Stekovic21] Stekovic et al., "MonteFloor", 2021, §4.
 *
 * @param ignored pixels that count for no room: the outer wall, drawn 5 px wide
 */
export function structured3dScores(
  wanted: readonly Outline[],
  found: readonly Outline[],
  ignored: PixelMap,
): Structured3dScores {
  const maps = found.map(filled);
  const bySize = wanted
    .map((outline) => ({ outline, map: filled(outline) }))
    .sort((a, b) => count(b.map) - count(a.map));
  const partners = bySize.map(({ map }) => bestMatch(map, maps, ignored));
  const overlaps = overlapping(maps.map(eroded));
  let [rooms, corners, angles] = [0, 0, 0];
  found.forEach((outline, k) => {
    const partner = partners.indexOf(k);
    if (partner < 0 || overlaps[k]) return;
    const right = rightCorners(bySize[partner].outline, outline);
    rooms++;
    corners += right.corners;
    angles += right.angles;
  });
  const [foundCorners, wantedCorners] = [found, wanted].map((outlines) => outlines.flat().length);
  const share = (part: number, whole: number): number => (whole === 0 ? 0 : part / whole);
  return {
    roomPrecision: share(rooms, found.length),
    roomRecall: share(rooms, wanted.length),
    cornerPrecision: share(corners, foundCorners),
    cornerRecall: share(corners, wantedCorners),
    anglePrecision: share(angles, foundCorners),
    angleRecall: share(angles, wantedCorners),
  };
}

const count = (map: PixelMap): number => map.reduce((sum, value) => sum + value, 0);

function bestMatch(wanted: PixelMap, found: readonly PixelMap[], ignored: PixelMap): number {
  let [best, at] = [MATCH_IOU, -1];
  found.forEach((map, k) => {
    let [shared, united] = [0, 0];
    for (let i = 0; i < map.length; i++) {
      if (ignored[i]) continue;
      shared += map[i] & wanted[i];
      united += map[i] | wanted[i];
    }
    const iou = shared / (united + 1);
    if (iou > best) [best, at] = [iou, k];
  });
  return at;
}

function overlapping(maps: readonly PixelMap[]): boolean[] {
  const layers = new Uint16Array(maps[0]?.length ?? 0);
  for (const map of maps) for (let i = 0; i < map.length; i++) layers[i] += map[i];
  return maps.map((map) => map.some((value, i) => value === 1 && layers[i] > 1));
}

/** Found corners near a true one, and those of them whose angle is right, by the last true corner that took them. */
function rightCorners(wanted: Outline, found: Outline): { corners: number; angles: number } {
  const angleRight = new Map<number, boolean>();
  wanted.forEach(([x, y], i) => {
    const distances = found.map(([u, v]) => Math.hypot(u - x, v - y));
    const nearest = distances.indexOf(Math.min(...distances));
    if (distances[nearest] > CORNER_REACH) return;
    angleRight.set(nearest, Math.abs(angleAt(found, nearest) - angleAt(wanted, i)) <= ANGLE_REACH_DEG);
  });
  return { corners: angleRight.size, angles: [...angleRight.values()].filter(Boolean).length };
}

/** Angle at a corner, degrees, positive where the outline is convex. */
function angleAt(outline: Outline, at: number): number {
  const total = outline.reduce((sum, _, i) => sum + turnAt(outline, i), 0);
  return Math.sign(total) * turnAt(outline, at);
}

function turnAt(outline: Outline, at: number): number {
  const size = outline.length;
  const [a, b, c] = [outline[(at + size - 1) % size], outline[at], outline[(at + 1) % size]];
  const side = Math.sign((b[1] - a[1]) * (c[0] - b[0]) - (c[1] - b[1]) * (b[0] - a[0]));
  const [[ux, uy], [vx, vy]] = [normal(a, b), normal(b, c)];
  return (side * Math.acos(Math.max(-1, Math.min(1, ux * vx + uy * vy))) * 180) / Math.PI;
}

/** Of the line through two pixels, by the protocol's own road: scaled twice, over the offset to the map's origin. */
function normal([px, py]: Pixel, [qx, qy]: Pixel): [number, number] {
  const line = [qy - py, px - qx, qx * py - px * qy];
  const scale = Math.hypot(...line) + EPSILON;
  const offset = line[2] / scale + EPSILON;
  const [x, y] = [line[0] / scale / offset, line[1] / scale / offset];
  const length = Math.hypot(x, y) + EPSILON;
  return [x / length, y / length];
}
