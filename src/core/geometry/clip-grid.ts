import { ClipperOffset, EndType, JoinType, type Path64, type Paths64 } from 'clipper2-ts';
import type { Ring } from '../types.ts';
import { orientRing, perimeter, signedArea } from './rings.ts';

/** The sweeps of clipper2 are exact on integers: steps of a micrometre, so lengths given in decimals come back digit for digit. */
export const STEPS_PER_METRE = 1e6;

/** How a grid gives rings back. */
interface Returning {
  /** A ring thinner than this on average, m, is debris of rounding, not a shape. */
  readonly debris: number;
  /** Whether vertices that went in come back unrounded. */
  readonly keepsVertices?: boolean;
}

/** Metres to whole micrometres around a place, and back. */
export class ClipGrid {
  /** Whole metres that are subtracted before rounding. */
  readonly #x: number;
  readonly #y: number;
  readonly #debris: number;
  readonly #exact: Map<string, readonly [x: number, y: number]> | null;

  /** @param near a ring among those to come */
  constructor(near: Ring, { debris, keepsVertices = false }: Returning) {
    this.#x = Math.round(near[0]);
    this.#y = Math.round(near[1]);
    this.#debris = debris;
    this.#exact = keepsVertices ? new Map() : null;
  }

  toPath(ring: Ring): Path64 {
    const path: Path64 = [];
    for (let i = 0; i < ring.length; i += 2) {
      const x = Math.round((ring[i] - this.#x) * STEPS_PER_METRE);
      const y = Math.round((ring[i + 1] - this.#y) * STEPS_PER_METRE);
      path.push({ x, y });
      this.#exact?.set(`${x} ${y}`, [ring[i], ring[i + 1]]);
    }
    return path;
  }

  /** Null for what rounding left over. */
  toRing(path: Path64, turn: 'counter-clockwise' | 'clockwise'): Ring | null {
    const ring = new Float64Array(2 * path.length);
    path.forEach(({ x, y }, i) => {
      const exact = this.#exact?.get(`${x} ${y}`);
      // One division, so the result is the double nearest to the decimal.
      ring[2 * i] = exact?.[0] ?? (this.#x * STEPS_PER_METRE + x) / STEPS_PER_METRE;
      ring[2 * i + 1] = exact?.[1] ?? (this.#y * STEPS_PER_METRE + y) / STEPS_PER_METRE;
    });
    const isDebris = path.length < 3 || Math.abs(signedArea(ring)) < (perimeter(ring) / 2) * this.#debris;
    return isDebris ? null : orientRing(ring, turn);
  }
}

/**
 * Paths of a grid moved outwards by a distance, m, or inwards by a negative one; corners stay corners.
 *
 * @param mitreLimit corners reach no farther out than so many distances: sharper ones are squared
 */
export function offsetPaths(paths: Paths64, distance: number, mitreLimit: number): Paths64 {
  const offset = new ClipperOffset(mitreLimit);
  offset.addPaths(paths, JoinType.Miter, EndType.Polygon);
  const moved: Paths64 = [];
  offset.execute(distance * STEPS_PER_METRE, moved);
  return moved;
}
