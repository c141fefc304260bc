import { FloorPlanError } from '../../core/errors.ts';
import type { PointChunk } from '../cloud-reader.ts';
import { triangulatePolygon } from './polygon.ts';

/** Most that is held of a mesh, in its vertices and triangles 0.8 GB each. */
const MOST_VERTICES = 1 << 25;
const MOST_TRIANGLES = 1 << 26;
const FIRST_ITEMS = 1 << 12;

/** Whether a mesh of so many vertices and triangles fits. */
export function canHoldMesh(vertices: number, triangles: number): boolean {
  return vertices <= MOST_VERTICES && triangles <= MOST_TRIANGLES;
}

/** Triangles, and vertices that are points by themselves. Source axes, units and coordinates. */
export interface Mesh {
  /** x, y, z a vertex. */
  readonly xyz: Float64Array;
  /** r, g, b a vertex, 0 to 255. */
  readonly colour?: Uint8Array;
  /** Three vertices a triangle, each within `xyz`. */
  readonly triangles: Uint32Array;
  /** Runs of vertices that are points: begin and end each. */
  readonly points: readonly (readonly [begin: number, end: number])[];
}

/** Collects a mesh in arrays that double. */
export class MeshBuilder {
  vertices = 0;
  #triangles = 0;
  #xyz = new Float64Array(3 * FIRST_ITEMS);
  #colour: Uint8Array | undefined;
  #corners = new Uint32Array(3 * FIRST_ITEMS);
  readonly #points: [begin: number, end: number][] = [];
  readonly #name: string;

  /** @param name of the file, for messages */
  constructor(name: string) {
    this.#name = name;
  }

  get triangles(): number {
    return this.#triangles;
  }

  /** @throws input/too-large */
  addVertex(x: number, y: number, z: number): void {
    const at = 3 * this.vertices;
    if (at === this.#xyz.length) this.#growVertices();
    this.#xyz[at] = x;
    this.#xyz[at + 1] = y;
    this.#xyz[at + 2] = z;
    this.vertices++;
  }

  /** Of the last vertex, 0 to 255; vertices without a colour are white. */
  paintVertex(red: number, green: number, blue: number): void {
    this.#colour ??= new Uint8Array(this.#xyz.length).fill(255);
    const at = 3 * (this.vertices - 1);
    this.#colour[at] = toByte(red);
    this.#colour[at + 1] = toByte(green);
    this.#colour[at + 2] = toByte(blue);
  }

  /** @param a,b,c vertices there are @throws input/too-large */
  addTriangle(a: number, b: number, c: number): void {
    const at = 3 * this.#triangles;
    if (at === this.#corners.length) this.#growTriangles();
    this.#corners[at] = a;
    this.#corners[at + 1] = b;
    this.#corners[at + 2] = c;
    this.#triangles++;
  }

  /** @param corners vertices there are, in order around; flat, concave or not @throws input/too-large */
  addPolygon(corners: readonly number[]): void {
    if (corners.length === 3) this.addTriangle(corners[0], corners[1], corners[2]);
    if (corners.length <= 3) return;
    const parts = triangulatePolygon(this.#xyz, corners);
    for (let i = 0; i < parts.length; i += 3) this.addTriangle(parts[i], parts[i + 1], parts[i + 2]);
  }

  /** Vertices that are points by themselves. */
  addPoints(begin: number, end: number): void {
    if (end > begin) this.#points.push([begin, end]);
  }

  /** Vertices from a reader of points. @throws input/too-large */
  addChunk({ count, xyz, colour }: PointChunk): void {
    for (let i = 0; i < 3 * count; i += 3) {
      this.addVertex(xyz[i], xyz[i + 1], xyz[i + 2]);
      if (colour) this.paintVertex(colour[i], colour[i + 1], colour[i + 2]);
    }
  }

  build(): Mesh {
    const length = 3 * this.vertices;
    return {
      xyz: this.#xyz.subarray(0, length),
      ...(this.#colour && { colour: this.#colour.subarray(0, length) }),
      triangles: this.#corners.subarray(0, 3 * this.#triangles),
      points: this.#points,
    };
  }

  #growVertices(): void {
    const grown = this.#grow(this.#xyz, 3 * MOST_VERTICES, (length) => new Float64Array(length));
    if (this.#colour) {
      const colour = new Uint8Array(grown.length).fill(255);
      colour.set(this.#colour);
      this.#colour = colour;
    }
    this.#xyz = grown;
  }

  #growTriangles(): void {
    this.#corners = this.#grow(this.#corners, 3 * MOST_TRIANGLES, (length) => new Uint32Array(length));
  }

  #grow<T extends Float64Array | Uint32Array>(from: T, most: number, make: (length: number) => T): T {
    if (from.length >= most) throw tooLarge(this.#name);
    try {
      const grown = make(Math.min(most, 2 * from.length));
      grown.set(from);
      return grown;
    } catch (cause) {
      throw tooLarge(this.#name, cause);
    }
  }
}

function toByte(value: number): number {
  return Math.min(255, Math.max(0, value + 0.5));
}

function tooLarge(name: string, cause?: unknown): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected a mesh of up to ${MOST_VERTICES} vertices and ${MOST_TRIANGLES} triangles, found more${cause ? ' than there is memory for' : ''}`,
    { hint: 'Simplify the mesh, or export it as a point cloud, which is read piece by piece.', cause },
  );
}
