import { ringsOf } from '../core/geometry/rings.ts';
import type { Polygon } from '../core/types.ts';
import { capTriangles } from './extrude.ts';
import type { TriangleMesh } from './triangle-mesh.ts';

/** An upright face over an edge, from one height to another. */
interface Side {
  /** 1 where the material lies to the left of the edge, seen from its lesser end; −1 where to the right. */
  readonly turn: 1 | -1;
  readonly low: number;
  readonly high: number;
}

interface Edge {
  readonly ends: readonly [ax: number, ay: number, bx: number, by: number];
  readonly sides: Side[];
}

/** Level and upright faces over vertices found by place. Upright ones that lie against each other are none. */
export class LayeredMesh {
  readonly #positions: number[] = [];
  readonly #indices: number[] = [];
  readonly #numbers = new Map<string, number>();
  readonly #edges = new Map<string, Edge>();

  /** Faces that close areas at a height. */
  addCaps(areas: readonly Polygon[], z: number, facing: 'up' | 'down'): void {
    for (const area of areas) {
      const { xy, triangles } = capTriangles(area);
      const at = (i: number) => this.#vertex(xy[2 * i], xy[2 * i + 1], z);
      for (let i = 0; i < triangles.length; i += 3) {
        const [a, b, c] = [at(triangles[i]), at(triangles[i + 1]), at(triangles[i + 2])];
        if (facing === 'up') this.#indices.push(a, b, c);
        else this.#indices.push(c, b, a);
      }
    }
  }

  /** What stands around areas between two heights. */
  addSides(areas: readonly Polygon[], low: number, high: number): void {
    for (const ring of ringsOf(areas)) {
      for (let i = 0; i < ring.length; i += 2) {
        const j = (i + 2) % ring.length;
        const [ax, ay, bx, by] = [ring[i], ring[i + 1], ring[j], ring[j + 1]];
        const isForward = ax < bx || (ax === bx && ay < by);
        const ends = isForward ? ([ax, ay, bx, by] as const) : ([bx, by, ax, ay] as const);
        this.#edgeAt(ends).sides.push({ turn: isForward ? 1 : -1, low, high });
      }
    }
  }

  toMesh(): TriangleMesh {
    for (const edge of this.#edges.values()) this.#raise(edge);
    this.#edges.clear();
    return { positions: Float64Array.from(this.#positions), indices: Uint32Array.from(this.#indices) };
  }

  #vertex(x: number, y: number, z: number): number {
    const key = `${x} ${y} ${z}`;
    const known = this.#numbers.get(key);
    if (known !== undefined) return known;
    const number = this.#numbers.size;
    this.#numbers.set(key, number);
    this.#positions.push(x, y, z);
    return number;
  }

  #edgeAt(ends: Edge['ends']): Edge {
    const key = ends.join(' ');
    const known = this.#edges.get(key) ?? { ends, sides: [] };
    this.#edges.set(key, known);
    return known;
  }

  /** One face for all that goes on without a change. */
  #raise({ ends: [ax, ay, bx, by], sides }: Edge): void {
    const heights = [...new Set(sides.flatMap(({ low, high }) => [low, high]))].sort((a, b) => a - b);
    const turns = heights.map((z) => {
      let turn = 0;
      for (const side of sides) if (side.low <= z && z < side.high) turn += side.turn;
      return turn;
    });
    let from = 0;
    for (let k = 1; k < heights.length; k++) {
      if (turns[k] === turns[from]) continue;
      const quad = (x0: number, y0: number, x1: number, y1: number) => {
        const [a, b] = [this.#vertex(x0, y0, heights[from]), this.#vertex(x1, y1, heights[from])];
        const [aTop, bTop] = [this.#vertex(x0, y0, heights[k]), this.#vertex(x1, y1, heights[k])];
        this.#indices.push(a, b, bTop, a, bTop, aTop);
      };
      for (let n = 0; n < turns[from]; n++) quad(ax, ay, bx, by);
      for (let n = 0; n > turns[from]; n--) quad(bx, by, ax, ay);
      from = k;
    }
  }
}
