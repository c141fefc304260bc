import type { PointChunk } from '../cloud-reader.ts';
import { FARTHEST, isPlace } from '../is-place.ts';
import { CHUNK_POINTS } from '../point-buffer.ts';
import type { Mesh } from './mesh.ts';

/** Farther than so many steps from the lattice's 0 steps cannot be counted; only a broken mesh is so far apart. */
const MOST_STEPS = 2 ** 50;
/**
 * The lattice is turned by atan(1 / golden ratio): of all slopes the one farthest from every fraction, so that along a
 * wall's edges points do not line up, and from above a wall's points fall between each other and not onto each other.
 */
const GOLDEN_RATIO = (1 + Math.sqrt(5)) / 2;
const COS = GOLDEN_RATIO / Math.hypot(1, GOLDEN_RATIO);
const SIN = 1 / Math.hypot(1, GOLDEN_RATIO);

/** A corner in the lattice of its triangle's plane: (α, β) steps along the lattice's axes. */
interface Corner {
  at: number;
  alpha: number;
  beta: number;
}

/**
 * Points of one square lattice in the plane of each triangle: exactly one a step² of its area, on the average over
 * where the triangle lies.
 *
 * Axes and phase of the lattice depend on nothing but the plane's direction and the mesh's lowest coordinates. So the points
 * do not depend on the order of triangles and corners, and both triangles of a rectangle, cut along either diagonal, give
 * the same points; a point on a shared edge belongs to one side only.
 */
export class LatticeSampler {
  /** Points gathered. */
  count = 0;
  /** Points on the triangle at hand. */
  found = 0;
  readonly #mesh: Mesh;
  readonly #step: number;
  readonly #origin: readonly [number, number, number];
  readonly #xyz = new Float64Array(3 * CHUNK_POINTS);
  readonly #colour: Uint8Array | undefined;
  /** By β: lowest, middle, highest. */
  readonly #corners: [Corner, Corner, Corner];
  /** The lattice's two steps in space: x, y, z each. */
  readonly #steps = new Float64Array(6);
  /** Change of r, g, b by a step along each axis. */
  readonly #shades = new Float64Array(6);
  #row = 0;
  #column = 0;
  #rowEnd = 0;

  constructor(mesh: Mesh, step: number) {
    this.#mesh = mesh;
    this.#step = step;
    this.#origin = lowest(mesh.xyz);
    if (mesh.colour) this.#colour = new Uint8Array(3 * CHUNK_POINTS);
    const corner = (): Corner => ({ at: 0, alpha: 0, beta: 0 });
    this.#corners = [corner(), corner(), corner()];
  }

  get free(): number {
    return CHUNK_POINTS - this.count;
  }

  /** The points so far, as a chunk whose arrays are used again. */
  take(): PointChunk {
    const count = this.count;
    this.count = 0;
    return { count, xyz: this.#xyz, ...(this.#colour && { colour: this.#colour }) };
  }

  /** Adds a vertex as it is; there is room. */
  addVertex(vertex: number): void {
    const at = 3 * this.count++;
    for (let axis = 0; axis < 3; axis++) {
      this.#xyz[at + axis] = this.#mesh.xyz[3 * vertex + axis];
      if (this.#colour && this.#mesh.colour) this.#colour[at + axis] = this.#mesh.colour[3 * vertex + axis];
    }
  }

  /** Turns to a triangle, by its place among the corners; false where it has no area or no place. */
  start(triangle: number): boolean {
    const { triangles } = this.#mesh;
    this.#corners.forEach((corner, i) => {
      corner.at = 3 * triangles[triangle + i];
    });
    if (!this.#layLattice()) return false;
    this.#placeCorners();
    this.#sortCorners();
    if (this.#colour) this.#layShades();
    this.found = 0;
    this.#row = this.#isCountable() ? Math.ceil(this.#corners[0].beta) - 1 : Infinity;
    this.#column = 0;
    this.#rowEnd = 0;
    return true;
  }

  /** Adds points of the triangle until there are no more or no more room; true where there are no more. */
  fill(): boolean {
    const high = this.#corners[2].beta;
    while (true) {
      while (this.#column < this.#rowEnd) {
        if (this.count === CHUNK_POINTS) return false;
        this.#fillRow();
      }
      // Ends on NaN too.
      if (!(++this.#row < high)) return true;
      this.#startRow();
    }
  }

  /** Adds the middle of the triangle; there is room. */
  addMiddle(): void {
    const [{ at: a }, { at: b }, { at: c }] = this.#corners;
    const { xyz, colour } = this.#mesh;
    const to = 3 * this.count++;
    for (let axis = 0; axis < 3; axis++) {
      this.#xyz[to + axis] = (xyz[a + axis] + xyz[b + axis] + xyz[c + axis]) / 3;
      if (!this.#colour || !colour) continue;
      this.#colour[to + axis] = (colour[a + axis] + colour[b + axis] + colour[c + axis]) / 3;
    }
  }

  #isCountable(): boolean {
    return this.#corners.every(({ alpha, beta }) => Math.max(Math.abs(alpha), Math.abs(beta)) < MOST_STEPS);
  }

  /** Steps in the triangle's plane, for either winding the same. */
  #layLattice(): boolean {
    const { xyz } = this.#mesh;
    const [{ at: a }, { at: b }, { at: c }] = this.#corners;
    const [ux, uy, uz] = [xyz[b] - xyz[a], xyz[b + 1] - xyz[a + 1], xyz[b + 2] - xyz[a + 2]];
    const [vx, vy, vz] = [xyz[c] - xyz[a], xyz[c + 1] - xyz[a + 1], xyz[c + 2] - xyz[a + 2]];
    let nx = uy * vz - uz * vy;
    let ny = uz * vx - ux * vz;
    let nz = ux * vy - uy * vx;
    const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    if (!(length > 0 && isPlace(xyz, a) && isPlace(xyz, b) && isPlace(xyz, c))) return false;
    const [sx, sy, sz] = [Math.abs(nx), Math.abs(ny), Math.abs(nz)];
    const isMostlyX = sx >= sy && sx >= sz;
    const main = isMostlyX ? nx : sy >= sz ? ny : nz;
    const scale = (main < 0 ? -1 : 1) / length;
    nx *= scale;
    ny *= scale;
    nz *= scale;
    // First axis: x, or y for a plane across x, turned into the plane; second axis: square to it.
    const [px, py] = isMostlyX ? [0, 1] : [1, 0];
    const along = isMostlyX ? ny : nx;
    const [ax, ay, az] = [px - along * nx, py - along * ny, -along * nz];
    const size = this.#step / Math.sqrt(ax * ax + ay * ay + az * az);
    const [bx, by, bz] = [ny * az - nz * ay, nz * ax - nx * az, nx * ay - ny * ax];
    this.#steps[0] = (COS * ax + SIN * bx) * size;
    this.#steps[1] = (COS * ay + SIN * by) * size;
    this.#steps[2] = (COS * az + SIN * bz) * size;
    this.#steps[3] = (COS * bx - SIN * ax) * size;
    this.#steps[4] = (COS * by - SIN * ay) * size;
    this.#steps[5] = (COS * bz - SIN * az) * size;
    return true;
  }

  #placeCorners(): void {
    const steps = this.#steps;
    const { xyz } = this.#mesh;
    const [ox, oy, oz] = this.#origin;
    const perStep = 1 / this.#step ** 2;
    for (const corner of this.#corners) {
      const x = xyz[corner.at] - ox;
      const y = xyz[corner.at + 1] - oy;
      const z = xyz[corner.at + 2] - oz;
      corner.alpha = (x * steps[0] + y * steps[1] + z * steps[2]) * perStep;
      corner.beta = (x * steps[3] + y * steps[4] + z * steps[5]) * perStep;
    }
  }

  #sortCorners(): void {
    const corners = this.#corners;
    if (isAbove(corners[0], corners[1])) [corners[0], corners[1]] = [corners[1], corners[0]];
    if (isAbove(corners[1], corners[2])) [corners[1], corners[2]] = [corners[2], corners[1]];
    if (isAbove(corners[0], corners[1])) [corners[0], corners[1]] = [corners[1], corners[0]];
  }

  /** Columns of a row: from its crossing with one side of the triangle up to, but without, that with the other. */
  #startRow(): void {
    const [low, mid, high] = this.#corners;
    const long = crossing(low, high, this.#row);
    const short = this.#row < mid.beta ? crossing(low, mid, this.#row) : crossing(mid, high, this.#row);
    this.#column = Math.ceil(Math.min(long, short));
    this.#rowEnd = Math.ceil(Math.max(long, short));
  }

  #fillRow(): void {
    const end = Math.min(this.#rowEnd, this.#column + this.free);
    for (let column = this.#column; column < end; column++) this.#addPoint(column, this.#row);
    this.found += end - this.#column;
    this.#column = end;
  }

  #addPoint(alpha: number, beta: number): void {
    const low = this.#corners[0];
    const { xyz } = this.#mesh;
    const steps = this.#steps;
    const a = alpha - low.alpha;
    const b = beta - low.beta;
    const at = 3 * this.count++;
    this.#xyz[at] = xyz[low.at] + a * steps[0] + b * steps[3];
    this.#xyz[at + 1] = xyz[low.at + 1] + a * steps[1] + b * steps[4];
    this.#xyz[at + 2] = xyz[low.at + 2] + a * steps[2] + b * steps[5];
    if (this.#colour) this.#shade(this.#colour, at, a, b);
  }

  /** Colour runs evenly between the corners. */
  #layShades(): void {
    const { colour } = this.#mesh;
    if (!colour) return;
    const [low, mid, high] = this.#corners;
    const [ma, mb] = [mid.alpha - low.alpha, mid.beta - low.beta];
    const [ha, hb] = [high.alpha - low.alpha, high.beta - low.beta];
    const span = ma * hb - mb * ha;
    for (let channel = 0; channel < 3; channel++) {
      const toMid = colour[mid.at + channel] - colour[low.at + channel];
      const toHigh = colour[high.at + channel] - colour[low.at + channel];
      // A sliver thinner than rounding has the colour of its lowest corner.
      this.#shades[channel] = span === 0 ? 0 : (toMid * hb - toHigh * mb) / span;
      this.#shades[3 + channel] = span === 0 ? 0 : (toHigh * ma - toMid * ha) / span;
    }
  }

  #shade(into: Uint8Array, at: number, a: number, b: number): void {
    const from = this.#mesh.colour;
    if (!from) return;
    const low = this.#corners[0].at;
    for (let channel = 0; channel < 3; channel++) {
      const value = from[low + channel] + a * this.#shades[channel] + b * this.#shades[3 + channel] + 0.5;
      into[at + channel] = Math.min(255, Math.max(0, value));
    }
  }
}

/** By β, and by α where β is equal, so that equal edges are crossed at equal places whatever triangle they are of. */
function isAbove(a: Corner, b: Corner): boolean {
  return a.beta > b.beta || (a.beta === b.beta && a.alpha > b.alpha);
}

function crossing(from: Corner, to: Corner, row: number): number {
  return from.alpha + ((row - from.beta) * (to.alpha - from.alpha)) / (to.beta - from.beta);
}

/** Lowest x, y and z there are: the lattice's 0, near the mesh for the sake of precision. */
function lowest(xyz: Float64Array): [number, number, number] {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  for (let i = 0; i < xyz.length; i++) {
    const axis = i % 3;
    if (xyz[i] < low[axis] && xyz[i] >= -FARTHEST) low[axis] = xyz[i];
  }
  return [low[0], low[1], low[2]];
}
