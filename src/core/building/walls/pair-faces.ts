import type { RoomEdge } from './room-edges.ts';

/** Thickness of an inner wall where no other tells, m: a stud wall. */
export const USUAL_THICKNESS = 0.12;
/** Thinnest wall, m: a glass or board partition. */
const THINNEST = 0.03;
/** Thickest wall between two rooms, m; farther apart, something else is between. */
const THICKEST = 0.75;
/** Cosine of the angle up to which two faces are those of one wall, 3°. */
const PARALLEL = 0.9986;
/** Shortest stretch that two faces have in common, m. */
const SHORTEST = 0.05;

/** A stretch over which a wall has rooms on both sides. */
export interface FacePair {
  readonly face: RoomEdge;
  readonly back: RoomEdge;
  /** Reach along `face`, m from its start. */
  readonly from: number;
  readonly to: number;
  readonly thickness: number;
}

/** Pairs of room edges that are the two faces of a wall. O(edges²) comparisons. */
export function pairFaces(edges: readonly RoomEdge[]): FacePair[] {
  const pairs: FacePair[] = [];
  edges.forEach((face, i) => {
    const backs = edges.flatMap((back, j) => {
      const pair = j === i ? null : facing(face, back);
      return pair && pair.thickness >= THINNEST && pair.thickness <= THICKEST ? [pair] : [];
    });
    backs.sort((a, b) => a.thickness - b.thickness || a.from - b.from);
    const free: [number, number][] = [[0, face.length]];
    for (const pair of backs) {
      for (const [from, to] of takeFrom(free, pair.from, pair.to)) {
        // Seen from the other side it comes again.
        if (edges.indexOf(pair.back) > i) pairs.push({ ...pair, from, to });
      }
    }
  });
  return pairs;
}

/**
 * Stretches that two rooms share without a wall's thickness between them: walls of which one face was seen.
 *
 * O(edges²) comparisons.
 */
export function sharedFaces(edges: readonly RoomEdge[]): FacePair[] {
  return edges.flatMap((face, i) =>
    edges.slice(i + 1).flatMap((back) => {
      const pair = back.owner === face.owner ? null : facing(face, back);
      return pair && Math.abs(pair.thickness) < THINNEST ? [pair] : [];
    }),
  );
}

/** Where an edge has another one opposite, however near or far. */
function facing(face: RoomEdge, back: RoomEdge): FacePair | null {
  if (face.ux * back.ux + face.uy * back.uy > -PARALLEL) return null;
  const along = (x: number, y: number) => (x - face.ax) * face.ux + (y - face.ay) * face.uy;
  const aside = (x: number, y: number) => (x - face.ax) * face.uy - (y - face.ay) * face.ux;
  const from = Math.max(0, along(back.bx, back.by));
  const to = Math.min(face.length, along(back.ax, back.ay));
  if (to - from < SHORTEST) return null;
  const thickness = (aside(back.ax, back.ay) + aside(back.bx, back.by)) / 2;
  return { face, back, from, to, thickness };
}

/** Takes a stretch out of those that are free and gives back what of it was. */
function takeFrom(free: [number, number][], from: number, to: number): [number, number][] {
  const taken: [number, number][] = [];
  for (let k = free.length - 1; k >= 0; k--) {
    const [a, b] = free[k];
    const [low, high] = [Math.max(a, from), Math.min(b, to)];
    if (high - low < SHORTEST) continue;
    taken.push([low, high]);
    free.splice(k, 1);
    if (low - a > SHORTEST) free.push([a, low]);
    if (b - high > SHORTEST) free.push([high, b]);
  }
  return taken;
}
