import { combine } from '../core/geometry/areas.ts';
import { ringsOf } from '../core/geometry/rings.ts';
import type { Polygon } from '../core/types.ts';
import { capTriangles, extrude, ON_EDGE } from './extrude.ts';
import type { Part } from './part.ts';
import { PINCH_ROUNDS, pinchesOf } from './pinches.ts';
import { carve } from './sections.ts';
import { shareVertices } from './share-vertices.ts';
import { closeTJunctions } from './t-junctions.ts';
import { openEdges, type TriangleMesh } from './triangle-mesh.ts';
import { splitShells } from './weld.ts';

/** Heights closer than this are one, m: rounding alone tells them apart. */
const LEAST_LAYER = 1e-6;

/** One section from a height to the next. */
interface Layer {
  readonly section: readonly Polygon[];
  readonly low: number;
  readonly high: number;
}

/**
 * A part with openings, cut height by height: every layer is its section raised, and where the section changes, at
 * sills and heads, a level face closes what lies bare. Piers and lintels are one shell without faces inside.
 *
 * All layers are cut from one section, and an edge takes up the vertices of other layers that lie on it, so walls of
 * different layers meet vertex by vertex. Where two openings meet corner to corner, no single shell is a two-manifold:
 * then every layer is a shell of its own.
 *
 * @returns one closed shell for each piece that hangs together
 */
export function layeredShells(part: Part): TriangleMesh[] {
  const layers = layersOf(part);
  const mesh = new LayeredMesh();
  const sides = new SideRuns(mesh);
  layers.forEach(({ section, low, high }, k) => {
    const below = k === 0 ? [] : layers[k - 1].section;
    mesh.addCaps(combine('difference', section, below), low, 'down');
    mesh.addCaps(combine('difference', below, section), low, 'up');
    sides.take(section, low, high);
  });
  mesh.addCaps(layers.at(-1)!.section, part.high, 'up');
  sides.end();
  const joined = closeTJunctions(mesh.toMesh(), ON_EDGE);
  if (openEdges(joined.indices).length === 0) return splitShells(joined);
  return layers.flatMap(({ section, low, high }) => section.map((polygon) => extrude(polygon, low, high)));
}

/** Lowest first. Where one layer touches itself, all are parted: so they stay alike. */
function layersOf({ base, changes, openings, low, high }: Part): Layer[] {
  const heights = [low];
  for (const z of openings.flatMap((box) => [box.low, box.high]).sort((a, b) => a - b)) {
    if (z > heights.at(-1)! + LEAST_LAYER && z < high - LEAST_LAYER) heights.push(z);
  }
  heights.push(high);
  // Structures that were added stand in an opening's way.
  const added = changes.flatMap(({ outline, operation }) => (operation === 'add' ? [outline] : []));
  const cuts = heights.slice(1).map((top, k) => {
    const middle = (heights[k] + top) / 2;
    const open = openings.filter((box) => box.low < middle && middle < box.high);
    return combine(
      'difference',
      open.map((box) => box.base),
      added,
    );
  });
  let whole = carve(base, changes);
  let sections = sectionsOf(whole, cuts);
  for (let round = 0; round < PINCH_ROUNDS; round++) {
    const pinches = sections.flatMap((section) => pinchesOf(section));
    if (pinches.length === 0) break;
    whole = combine('difference', whole, pinches);
    sections = sectionsOf(whole, cuts);
  }
  return sections.map((section, k) => ({ section, low: heights[k], high: heights[k + 1] }));
}

const sectionsOf = (whole: readonly Polygon[], cuts: readonly (readonly Polygon[])[]): Polygon[][] =>
  shareVertices(cuts.map((cut) => combine('difference', whole, cut)));

/** Triangles over vertices found by place. */
class LayeredMesh {
  readonly #positions: number[] = [];
  readonly #indices: number[] = [];
  readonly #numbers = new Map<string, number>();

  vertex(x: number, y: number, z: number): number {
    const key = `${x} ${y} ${z}`;
    const known = this.#numbers.get(key);
    if (known !== undefined) return known;
    const number = this.#numbers.size;
    this.#numbers.set(key, number);
    this.#positions.push(x, y, z);
    return number;
  }

  triangle(a: number, b: number, c: number): void {
    this.#indices.push(a, b, c);
  }

  addCaps(polygons: readonly Polygon[], z: number, facing: 'up' | 'down'): void {
    for (const polygon of polygons) {
      const { xy, triangles } = capTriangles(polygon);
      const at = (i: number) => this.vertex(xy[2 * i], xy[2 * i + 1], z);
      for (let i = 0; i < triangles.length; i += 3) {
        const [a, b, c] = [at(triangles[i]), at(triangles[i + 1]), at(triangles[i + 2])];
        if (facing === 'up') this.triangle(a, b, c);
        else this.triangle(c, b, a);
      }
    }
  }

  toMesh(): TriangleMesh {
    return { positions: Float64Array.from(this.#positions), indices: Uint32Array.from(this.#indices) };
  }
}

interface Run {
  readonly ends: readonly [ax: number, ay: number, bx: number, by: number];
  readonly low: number;
  readonly high: number;
}

/** Upright faces: one for an edge through all the layers it goes on in. */
class SideRuns {
  readonly #mesh: LayeredMesh;
  #open = new Map<string, Run>();

  constructor(mesh: LayeredMesh) {
    this.#mesh = mesh;
  }

  /** The next layer up. */
  take(section: readonly Polygon[], low: number, high: number): void {
    const next = new Map<string, Run>();
    for (const ring of ringsOf(section)) {
      for (let i = 0; i < ring.length; i += 2) {
        const j = (i + 2) % ring.length;
        const ends = [ring[i], ring[i + 1], ring[j], ring[j + 1]] as const;
        const key = ends.join(' ');
        next.set(key, { ends, low: this.#open.get(key)?.low ?? low, high });
        this.#open.delete(key);
      }
    }
    this.end();
    this.#open = next;
  }

  /** Raises the faces that go no higher. */
  end(): void {
    for (const { ends, low, high } of this.#open.values()) {
      const [ax, ay, bx, by] = ends;
      const [a, b] = [this.#mesh.vertex(ax, ay, low), this.#mesh.vertex(bx, by, low)];
      const [aTop, bTop] = [this.#mesh.vertex(ax, ay, high), this.#mesh.vertex(bx, by, high)];
      this.#mesh.triangle(a, b, bTop);
      this.#mesh.triangle(a, bTop, aTop);
    }
    this.#open.clear();
  }
}
