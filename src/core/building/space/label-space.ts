import { polygonArea } from '../../geometry/rings.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import type { SeenSpace } from '../columns/seen-space.ts';
import type { Arrangement } from './arrangement.ts';
import { faceArea, ringFrom } from './arrangement.ts';
import { MinCut } from './max-flow.ts';

/** What a metre of boundary without any wall costs, in m² of space labelled against its evidence. */
const BOUNDARY_COST = 0.3;
/** What space counts where nothing was seen: far from a scanner, or behind furniture, it is room all the same. */
const UNSEEN_COST = 0.1;
/** … but what is not seen between places that are is solid: a wall. */
const SOLID_COST = 1;

/** For each face of an arrangement: is it room or not? */
export interface Space {
  readonly isRoom: Uint8Array;
  /** m² of each face whose ceiling or floor was seen. */
  readonly seen: Float64Array;
}

/**
 * Parts the faces of an arrangement into room and the rest by a minimum cut ([Boykov04]).
 *
 * A face tends to be room by the share of it under which a floor, and above all over which a ceiling, was seen: a lintel
 * keeps its doorway out. A boundary costs little where a wall stands and more where none does.
 *
 * Not taken: to call any box before a wall that reaches the ceiling a wardrobe, and room, by its shape (`withoutWardrobes` does where noise blurs): stretches told as
 * hidden are right more often (.54 → .63 of those there are in hard scenes), but chimneys and pilasters go (clean corners
 * at 5 cm .90 → .88, room areas .5 → .9 % off); to call solid what holds no point at all, too (hard corners at 5 cm .56 →
 * .46: far from a scanner that is room); to call solid a strip behind each face that stands (clean .908 → .910, but hard
 * .561 → .540: cupboards).
 *
 * @param support share of wall along each edge, 0 to 1
 */
export function labelSpace(
  arrangement: Arrangement,
  columns: HeightColumns,
  { isSeen, isBetween }: SeenSpace,
  support: Float64Array,
): Space {
  const owner = columnFaces(arrangement, columns);
  const seen = areasOf(arrangement, columns, owner, isSeen);
  const solid = areasOf(arrangement, columns, owner, isBetween);
  const { face, areas, x, y, origin } = arrangement;
  const cut = new MinCut(areas.length);
  const own = areas.map((_, f) => polygonArea(faceArea(arrangement, f)));
  for (let f = 0; f < areas.length; f++) {
    const inside = Math.min(own[f], seen[f]);
    const unseen = own[f] - inside;
    cut.addTerminals(f, inside, UNSEEN_COST * unseen + SOLID_COST * Math.min(unseen, solid[f]));
  }
  for (let e = 0; e < support.length; e++) {
    const [f, g] = [face[2 * e], face[2 * e + 1]];
    if (f === g) continue;
    const [u, v] = [origin[2 * e], origin[2 * e + 1]];
    const cost = BOUNDARY_COST * Math.hypot(x[u] - x[v], y[u] - y[v]) * (1 - support[e]);
    if (f < 0 || g < 0) cut.addTerminals(f < 0 ? g : f, 0, cost);
    else cut.addEdge(f, g, cost);
  }
  return { isRoom: cut.solve(), seen };
}

/** The face that the middle of each column lies in; −1 outside all. O(columns). */
export function columnFaces(arrangement: Arrangement, { count, table, size }: HeightColumns): Int32Array {
  const { areas, x, y, origin, next, faceEdge } = arrangement;
  const owner = new Int32Array(count).fill(-1);
  // The largest first, so that what lies within a face has the last word.
  const order = [...areas.keys()].sort((f, g) => areas[g] - areas[f]);
  for (const f of order) {
    const ring = ringFrom({ x, y, origin, next }, faceEdge[f]);
    forCellsIn(ring, size, (ix, iy) => {
      const c = table.find(ix, iy, 0);
      if (c >= 0) owner[c] = f;
    });
  }
  return owner;
}

/** m² of each face that the columns marked take up. */
function areasOf(
  { areas }: Arrangement,
  { size }: HeightColumns,
  owner: Int32Array,
  isMarked: Uint8Array,
): Float64Array {
  const marked = new Float64Array(areas.length);
  for (let c = 0; c < owner.length; c++) {
    if (owner[c] >= 0 && isMarked[c] === 1) marked[owner[c]] += size * size;
  }
  return marked;
}

/** Visits the cells of a square grid whose middles lie in a ring. */
function forCellsIn(ring: Float64Array, size: number, visit: (ix: number, iy: number) => void): void {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 1; i < ring.length; i += 2) {
    low = Math.min(low, ring[i]);
    high = Math.max(high, ring[i]);
  }
  const crossings: number[] = [];
  for (let iy = Math.floor(low / size); iy <= Math.floor(high / size); iy++) {
    const y = (iy + 0.5) * size;
    crossings.length = 0;
    for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      if (ring[i + 1] > y === ring[j + 1] > y) continue;
      crossings.push(ring[j] + ((y - ring[j + 1]) / (ring[i + 1] - ring[j + 1])) * (ring[i] - ring[j]));
    }
    crossings.sort((a, b) => a - b);
    for (let k = 0; k + 1 < crossings.length; k += 2) {
      const last = Math.ceil(crossings[k + 1] / size - 0.5);
      for (let ix = Math.ceil(crossings[k] / size - 0.5); ix < last; ix++) visit(ix, iy);
    }
  }
}
