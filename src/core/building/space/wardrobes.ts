import { pointInPolygon } from '../../geometry/rings.ts';
import { weightedMedian } from '../../robust-scale.ts';
import type { Polygon, Ring } from '../../types.ts';
import { OPEN_SHARE, type SeenSpace } from '../columns/seen-space.ts';
import { pointOn } from '../faces/face.ts';
import type { FoundRooms, WallFaces } from './found-rooms.ts';

/** Where walls' points spread this far, m, the few centimetres that a wardrobe leaves below the ceiling are lost. */
const BLURRING_NOISE = 0.01;
/** How deep wardrobes are, m, and how wide, by themselves or in a row: most chimneys and shafts are shallower or narrower. */
const SHALLOWEST = 0.35;
const DEEPEST = 0.75;
const NARROWEST = 0.8;
const WIDEST = 4;
/** So much of the wall was seen beside it, m … */
const LEAST_WALL = 0.3;
/** … and on its other side it goes on so near the same line, m. */
const SAME_LINE = 0.06;
/** Cosine of the angle up to which edges run along the wall, or square to it: 10°. */
const STRAIGHT = 0.985;
/** Places within are so far apart, m, and off its faces. */
const PLACE = 0.1;
/** A face so near outside a wardrobe, m, is its own; so near the wall, it is the wall's. */
const NEAR = 0.08;

/** A rectangle on the floor: `width` along a wall from a point of it on, `depth` into the room to the left. */
interface Box {
  readonly x: number;
  readonly y: number;
  /** Unit vector along the wall. */
  readonly ux: number;
  readonly uy: number;
  readonly width: number;
  readonly depth: number;
  /** Its sides' faces lie so far along the wall: past its ends, but where it stands against another wall. */
  readonly from: number;
  readonly to: number;
}

/**
 * The walls without those that are wardrobes, which seem to reach a ceiling that noise blurs: boxes as deep and as wide as
 * wardrobes that stand before a wall, within which nothing was seen. The same walls where there are none.
 *
 * What stands like that in a building whose gaps below the ceiling can be told is a chimney or a shaft, and stays. O(vertices²
 * + boxes · bits).
 */
export function withoutWardrobes(walls: WallFaces, found: FoundRooms, seen: SeenSpace): WallFaces {
  const noise = weightedMedian(
    walls.faces.map((face) => face.noise),
    walls.faces.map((face) => face.members.length),
  );
  if (!(noise >= BLURRING_NOISE)) return walls;
  const outlines = found.rooms.map(({ outline }) => outline);
  const boxes = outlines
    .flatMap(({ outer }) => [...boxesOn(outer), ...boxesOn(mirrored(outer)).map(mirroredBox)])
    .filter((box) => isUnseen(box, outlines, seen));
  if (boxes.length === 0) return walls;
  const supports = walls.supports.map((support, i) => ({
    ...support,
    shares: support.shares.map((share, k) => {
      const [x, y] = pointOn(walls.faces[i], support.from + (k + 0.5) * support.step);
      return boxes.some((box) => hasFaceAt(box, x, y)) ? 0 : share;
    }),
  }));
  return { faces: walls.faces, supports };
}

/** Boxes that follow, along a ring, on a wall seen before them. */
function boxesOn(ring: Ring): Box[] {
  const n = ring.length / 2;
  const boxes: Box[] = [];
  for (let i = 0; i < n; i++) {
    const j = (i + 1) % n;
    const [x, y] = [ring[2 * j], ring[2 * j + 1]];
    const [dx, dy] = [x - ring[2 * i], y - ring[2 * i + 1]];
    const length = Math.hypot(dx, dy);
    if (length < LEAST_WALL) continue;
    const [ux, uy] = [dx / length, dy / length];
    const places = Array.from({ length: n - 1 }, (_, k) => {
      const at = 2 * ((j + k) % n);
      const [px, py] = [ring[at] - x, ring[at + 1] - y];
      return [px * ux + py * uy, py * ux - px * uy] as const;
    });
    const size = sizeOfBox(places);
    if (size !== null) boxes.push({ x, y, ux, uy, ...size });
  }
  return boxes;
}

/**
 * The size of a box that a ring goes around, from its foot on until it meets the wall again, or one square to it; null where it
 * is none.
 *
 * @param places along the wall and off it, m
 */
function sizeOfBox(
  places: readonly (readonly [number, number])[],
): Pick<Box, 'width' | 'depth' | 'from' | 'to'> | null {
  let depth = 0;
  for (let k = 1; k < places.length; k++) {
    const [[width, before], [along, off]] = [places[k - 1], places[k]];
    const length = Math.hypot(along - width, off - before);
    const isAcross = Math.abs(off - before) >= STRAIGHT * length;
    if (!isAcross && (k === 1 || along - width < STRAIGHT * length)) return null;
    if (off >= SHALLOWEST && off <= DEEPEST) {
      depth = Math.max(depth, off);
      continue;
    }
    const isCorner = off > DEEPEST;
    const isEnd = isAcross && depth > 0 && (isCorner || Math.abs(off) < SAME_LINE);
    if (!isEnd || width < NARROWEST || width > WIDEST) return null;
    return { width, depth, from: -NEAR, to: width + (isCorner ? -NEAR : NEAR) };
  }
  return null;
}

/** A ring in a mirror along y, still with its inside to the left: what came before a wall comes after it. */
function mirrored(ring: Ring): Ring {
  const last = ring.length - 2;
  return ring.map((_, i) => (i % 2 === 0 ? -ring[last - i] : ring[last - i + 2]));
}

function mirroredBox({ x, y, ux, uy, width, depth, from, to }: Box): Box {
  // Along the mirrored wall the box runs the other way.
  const [fromThere, toThere] = [width - to, width - from];
  return { x: -(x + ux * width), y: y + uy * width, ux, uy: -uy, width, depth, from: fromThere, to: toThere };
}

/** Whether nothing was seen in a box, nor is it in any room. */
function isUnseen(box: Box, outlines: readonly Polygon[], seen: SeenSpace): boolean {
  const { x, y, ux, uy, width, depth } = box;
  let [places, shown] = [0, 0];
  for (let along = PLACE; along < width - PLACE / 2; along += PLACE) {
    for (let off = PLACE; off < depth - PLACE / 2; off += PLACE) {
      const place = [x + ux * along - uy * off, y + uy * along + ux * off] as const;
      places++;
      if (seen.at(...place) || outlines.some((outline) => pointInPolygon(...place, outline) > 0)) shown++;
    }
  }
  return shown <= OPEN_SHARE * places;
}

/** Whether what stands at a place is a box's front or side. */
function hasFaceAt({ x, y, ux, uy, depth, from, to }: Box, px: number, py: number): boolean {
  const along = (px - x) * ux + (py - y) * uy;
  const off = (py - y) * ux - (px - x) * uy;
  return along > from && along < to && off > NEAR && off < depth + NEAR;
}
