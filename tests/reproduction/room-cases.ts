/** Made-up rooms for the experiments on gaps, recesses and narrow spaces. Metres. */
import type { Path } from '../unit/core/boundary/wall-slices.ts';

function polygon(corners: number, radius: number): Path {
  return Array.from({ length: corners }, (_, k) => {
    const angle = (2 * Math.PI * (k + 0.5)) / corners;
    return [radius * Math.cos(angle), radius * Math.sin(angle)] as const;
  });
}

export const ROOMS: Readonly<Record<string, Path>> = {
  rectangle: [
    [0, 0],
    [10, 0],
    [10, 4],
    [0, 4],
  ],
  ell: [
    [0, 0],
    [10, 0],
    [10, 4],
    [6, 4],
    [6, 7],
    [0, 7],
  ],
  tee: [
    [0, 4],
    [3.5, 4],
    [3.5, 0],
    [7, 0],
    [7, 4],
    [10, 4],
    [10, 8],
    [0, 8],
  ],
  you: [
    [0, 0],
    [12, 0],
    [12, 8],
    [8, 8],
    [8, 4],
    [4, 4],
    [4, 8],
    [0, 8],
  ],
  zed: [
    [0, 0],
    [7, 0],
    [7, 4],
    [12, 4],
    [12, 8],
    [4, 8],
    [4, 4],
    [0, 4],
  ],
  round: polygon(60, 4),
  octagon: polygon(8, 5),
  skew: [
    [0, 0],
    [8, 0.4],
    [9, 5],
    [1, 5.5],
  ],
  corridor: [
    [0, 0],
    [15, 0],
    [15, 2],
    [0, 2],
  ],
};

/** Recesses in the wall of a room of 10 × 6 m, by the width of their mouth and their depth. */
export const RECESSES: Readonly<Record<string, (width: number, depth: number) => Path>> = {
  'in a wall': (w, d) =>
    roomWith([
      [5 - w / 2, 0],
      [5 - w / 2, d],
      [5 + w / 2, d],
      [5 + w / 2, 0],
    ]),
  slanting: (w, d) =>
    roomWith([
      [5 - w / 2, 0],
      [5 - w / 2 + 0.3 * d, d],
      [5 + w / 2 + 0.3 * d, d],
      [5 + w / 2, 0],
    ]),
  tapering: (w, d) =>
    roomWith([
      [5 - w / 2, 0],
      [5 - w / 3, d],
      [5 + w / 3, d],
      [5 + w / 2, 0],
    ]),
  'near a corner': (w, d) =>
    roomWith([
      [0.5, 0],
      [0.5, d],
      [0.5 + w, d],
      [0.5 + w, 0],
    ]),
  'at a corner': (w, d) => [
    [0, 0],
    [10 - w, 0],
    [10 - w, d],
    [10, d],
    [10, 6],
    [0, 6],
  ],
};

function roomWith(recess: Path): Path {
  return [[0, 0], ...recess, [10, 0], [10, 6], [0, 6]];
}

/** Spaces with a part of a width, wall to wall, and the room they open to. */
export const NARROW_SPACES: Readonly<Record<string, (width: number) => Path>> = {
  duct: (w) => [
    [0, 0],
    [6, 0],
    [6, w],
    [0, w],
  ],
  'bent corridor': (w) => [
    [0, 0],
    [5, 0],
    [5, 4],
    [5 - w, 4],
    [5 - w, w],
    [0, w],
  ],
  'corridor off a hall': (w) => [
    [0, 0],
    [5, 0],
    [5, 2],
    [9, 2],
    [9, 2 + w],
    [5, 2 + w],
    [5, 4],
    [0, 4],
  ],
  // Its door is narrower than the closet.
  'closet behind a door': (w) => [
    [0, 0],
    [5, 0],
    [5, 2],
    [5.1, 2],
    [5.1, 1],
    [5.1 + w, 1],
    [5.1 + w, 3.5],
    [5.1, 3.5],
    [5.1, 2.7],
    [5, 2.7],
    [5, 4],
    [0, 4],
  ],
};

export function rotated(path: Path, angle: number): Path {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return path.map(([x, y]) => [c * x - s * y, s * x + c * y] as const);
}

/** Where the corners of a closed path lie along it, its whole length last. */
export function cornersAlong(path: Path): number[] {
  const at = [0];
  path.forEach(([x, y], k) => {
    const [nextX, nextY] = path[(k + 1) % path.length];
    at.push(at[k] + Math.hypot(nextX - x, nextY - y));
  });
  return at;
}

/** The place so many metres along a closed path, round and round. */
export function pointAlong(path: Path, metres: number): readonly [x: number, y: number] {
  const at = cornersAlong(path);
  const total = at.at(-1)!;
  const along = ((metres % total) + total) % total;
  const k = at.findLastIndex((corner) => corner <= along);
  const [[ax, ay], [bx, by]] = [path[k], path[(k + 1) % path.length]];
  const share = (along - at[k]) / (at[k + 1] - at[k]);
  return [ax + share * (bx - ax), ay + share * (by - ay)];
}

/**
 * Most area, m², that edges of up to `length` leave closed at the concave corners of a counter-clockwise room, square
 * ones: what gift opening may add to it, gap or none. A bay no wider is closed whole.
 */
export function closableArea(room: Path, length: number): number {
  const n = room.length;
  const side = (k: number) =>
    Math.hypot(room[(k + 1) % n][0] - room[k % n][0], room[(k + 1) % n][1] - room[k % n][1]);
  let area = 0;
  for (let k = 0; k < n; k++) {
    if (isConvexAt(room, k)) continue;
    const [before, after] = [side(k + n - 1), side(k)];
    const isBay = !isConvexAt(room, (k + 1) % n) && after <= length;
    if (isBay) area += after * Math.min(before, side(k + 1));
    const short = Math.min(before, after, length / Math.SQRT2);
    area += (short * Math.min(Math.max(before, after), Math.sqrt(length ** 2 - short ** 2))) / 2;
  }
  return area;
}

/** Whether a counter-clockwise path turns left at its vertex k. */
export function isConvexAt(path: Path, k: number): boolean {
  const n = path.length;
  const [ax, ay] = path[(k + n - 1) % n];
  const [bx, by] = path[k];
  const [cx, cy] = path[(k + 1) % n];
  return (bx - ax) * (cy - by) - (by - ay) * (cx - bx) > 0;
}
