import type { Ring } from '../types.ts';

/** Places nearer to each other are one vertex, m: far below what a scan tells, far above what float64 rounds. */
const SAME_PLACE = 1e-5;

/** A straight stretch of the plane's subdivision. */
export interface Segment {
  readonly ax: number;
  readonly ay: number;
  readonly bx: number;
  readonly by: number;
  /** What it stands for, as its maker numbers it. */
  readonly line: number;
}

/**
 * The subdivision of the plane by segments: vertices, edges and the faces between them.
 *
 * Half edge 2e runs along edge e, 2e + 1 back; each has its face on its left.
 */
export interface Arrangement {
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** Vertex each half edge starts from. */
  readonly origin: Int32Array;
  /** Half edge that follows around the face. */
  readonly next: Int32Array;
  /** Face on the left of each half edge; −1 where a ring bounds the outside. */
  readonly face: Int32Array;
  /** Lines each edge lies on; several where segments overlap. */
  readonly lines: readonly (readonly number[])[];
  /** One half edge of each face's outer ring. */
  readonly faceEdge: Int32Array;
  /** Half edges, one a ring, of what lies within each face without touching it. */
  readonly holes: readonly (readonly number[])[];
  /** m², holes not taken off. */
  readonly areas: Float64Array;
}

/**
 * Cuts segments at each other and finds the faces between them; what bounds no face is left out.
 *
 * O(n²) comparisons of bounding boxes for n segments, O(k log k) for k crossings.
 */
export function arrange(segments: readonly Segment[]): Arrangement {
  const { places, chains } = cutSegments(segments);
  const { a, b, lines } = withoutDangling(uniqueEdges(segments, chains), places.count);
  return traceFaces(places, a, b, lines);
}

/** Numbers places, one number for places that are the same. */
class Places {
  count = 0;
  readonly xs: number[] = [];
  readonly ys: number[] = [];
  readonly #cells = new Map<string, number[]>();

  add(x: number, y: number): number {
    const [ix, iy] = [Math.floor(x / SAME_PLACE), Math.floor(y / SAME_PLACE)];
    for (let dx = -1; dx <= 1; dx++) {
      for (let dy = -1; dy <= 1; dy++) {
        for (const known of this.#cells.get(`${ix + dx} ${iy + dy}`) ?? []) {
          if (Math.hypot(this.xs[known] - x, this.ys[known] - y) < SAME_PLACE) return known;
        }
      }
    }
    const key = `${ix} ${iy}`;
    const cell = this.#cells.get(key);
    if (cell) cell.push(this.count);
    else this.#cells.set(key, [this.count]);
    this.xs.push(x);
    this.ys.push(y);
    return this.count++;
  }
}

interface Cut {
  readonly places: Places;
  /** Places along each segment, in order. */
  readonly chains: readonly (readonly number[])[];
}

function cutSegments(segments: readonly Segment[]): Cut {
  const cuts: number[][] = segments.map(() => [0, 1]);
  const order = segments.map((_, i) => i);
  const low = segments.map((s) => Math.min(s.ax, s.bx));
  const high = segments.map((s) => Math.max(s.ax, s.bx));
  order.sort((i, j) => low[i] - low[j] || i - j);
  for (let k = 0; k < order.length; k++) {
    const i = order[k];
    for (let m = k + 1; m < order.length && low[order[m]] <= high[i] + SAME_PLACE; m++) {
      crossing(segments[i], segments[order[m]], cuts[i], cuts[order[m]]);
    }
  }
  const places = new Places();
  const chains = segments.map((segment, i) => {
    const chain: number[] = [];
    for (const t of cuts[i].sort((p, q) => p - q)) {
      const place = places.add(
        segment.ax + t * (segment.bx - segment.ax),
        segment.ay + t * (segment.by - segment.ay),
      );
      if (chain[chain.length - 1] !== place) chain.push(place);
    }
    return chain;
  });
  return { places, chains };
}

/** Notes where two segments meet, as shares of their lengths. */
function crossing(s: Segment, t: Segment, ofS: number[], ofT: number[]): void {
  if (Math.max(s.ay, s.by) < Math.min(t.ay, t.by) - SAME_PLACE) return;
  if (Math.max(t.ay, t.by) < Math.min(s.ay, s.by) - SAME_PLACE) return;
  const [sx, sy, tx, ty] = [s.bx - s.ax, s.by - s.ay, t.bx - t.ax, t.by - t.ay];
  const [lengthS, lengthT] = [Math.hypot(sx, sy), Math.hypot(tx, ty)];
  const cross = sx * ty - sy * tx;
  const [dx, dy] = [t.ax - s.ax, t.ay - s.ay];
  if (Math.abs(cross) > 1e-9 * lengthS * lengthT) {
    const u = (dx * ty - dy * tx) / cross;
    const v = (dx * sy - dy * sx) / cross;
    const [slackS, slackT] = [SAME_PLACE / lengthS, SAME_PLACE / lengthT];
    if (u < -slackS || u > 1 + slackS || v < -slackT || v > 1 + slackT) return;
    ofS.push(Math.min(1, Math.max(0, u)));
    ofT.push(Math.min(1, Math.max(0, v)));
    return;
  }
  // Parallel: the ends of one that lie on the other.
  if (Math.abs(dx * sy - dy * sx) > SAME_PLACE * lengthS) return;
  for (const [px, py] of [
    [t.ax, t.ay],
    [t.bx, t.by],
  ]) {
    const u = ((px - s.ax) * sx + (py - s.ay) * sy) / lengthS ** 2;
    if (u > 0 && u < 1) ofS.push(u);
  }
  for (const [px, py] of [
    [s.ax, s.ay],
    [s.bx, s.by],
  ]) {
    const v = ((px - t.ax) * tx + (py - t.ay) * ty) / lengthT ** 2;
    if (v > 0 && v < 1) ofT.push(v);
  }
}

interface Edges {
  readonly a: number[];
  readonly b: number[];
  readonly lines: number[][];
}

function uniqueEdges(segments: readonly Segment[], chains: readonly (readonly number[])[]): Edges {
  const edges: Edges = { a: [], b: [], lines: [] };
  const numbers = new Map<string, number>();
  chains.forEach((chain, i) => {
    for (let k = 1; k < chain.length; k++) {
      const [a, b] = [Math.min(chain[k - 1], chain[k]), Math.max(chain[k - 1], chain[k])];
      const known = numbers.get(`${a} ${b}`);
      if (known !== undefined) {
        edges.lines[known].push(segments[i].line);
        continue;
      }
      numbers.set(`${a} ${b}`, edges.a.length);
      edges.a.push(a);
      edges.b.push(b);
      edges.lines.push([segments[i].line]);
    }
  });
  return edges;
}

/** Takes away edges that end in nothing, again and again. */
function withoutDangling({ a, b, lines }: Edges, places: number): Edges {
  const degree = new Int32Array(places);
  const at: number[][] = Array.from({ length: places }, () => []);
  a.forEach((from, e) => {
    for (const v of [from, b[e]]) {
      degree[v]++;
      at[v].push(e);
    }
  });
  const isGone = new Uint8Array(a.length);
  const open = [...degree.keys()].filter((v) => degree[v] === 1);
  for (let v = open.pop(); v !== undefined; v = open.pop()) {
    const e = at[v].find((edge) => isGone[edge] === 0);
    if (e === undefined) continue;
    isGone[e] = 1;
    for (const end of [a[e], b[e]]) if (--degree[end] === 1) open.push(end);
  }
  const stays = (_: unknown, e: number) => isGone[e] === 0;
  return { a: a.filter(stays), b: b.filter(stays), lines: lines.filter(stays) };
}

function traceFaces({ xs, ys }: Places, a: number[], b: number[], lines: number[][]): Arrangement {
  const x = Float64Array.from(xs);
  const y = Float64Array.from(ys);
  const origin = new Int32Array(2 * a.length);
  for (let e = 0; e < a.length; e++) [origin[2 * e], origin[2 * e + 1]] = [a[e], b[e]];
  const next = nextAround(origin, x, y);
  const face = new Int32Array(origin.length).fill(-1);
  const faceEdge: number[] = [];
  const areas: number[] = [];
  const outsides: number[] = [];
  const isSeen = new Uint8Array(origin.length);
  for (let h = 0; h < origin.length; h++) {
    if (isSeen[h]) continue;
    let area = 0;
    let g = h;
    do {
      isSeen[g] = 1;
      const [u, v] = [origin[g], origin[g ^ 1]];
      area += (x[u] - x[origin[h]]) * (y[v] - y[origin[h]]) - (x[v] - x[origin[h]]) * (y[u] - y[origin[h]]);
      g = next[g];
    } while (g !== h);
    if (area <= 0) {
      outsides.push(h);
      continue;
    }
    do {
      face[g] = faceEdge.length;
      g = next[g];
    } while (g !== h);
    faceEdge.push(h);
    areas.push(area / 2);
  }
  const traced = {
    x,
    y,
    origin,
    next,
    face,
    lines,
    faceEdge: Int32Array.from(faceEdge),
    areas: Float64Array.from(areas),
  };
  return { ...traced, holes: nestOutsides(traced, outsides) };
}

/** The next half edge around a face: at its end, the first clockwise from where it came. */
function nextAround(origin: Int32Array, x: Float64Array, y: Float64Array): Int32Array {
  const out: number[][] = Array.from({ length: x.length }, () => []);
  const angle = new Float64Array(origin.length);
  for (let h = 0; h < origin.length; h++) {
    out[origin[h]].push(h);
    angle[h] = Math.atan2(y[origin[h ^ 1]] - y[origin[h]], x[origin[h ^ 1]] - x[origin[h]]);
  }
  const next = new Int32Array(origin.length);
  for (const around of out) {
    around.sort((g, h) => angle[g] - angle[h]);
    around.forEach((h, k) => {
      next[h ^ 1] = around[(k + around.length - 1) % around.length];
    });
  }
  return next;
}

type Traced = Omit<Arrangement, 'holes'>;

/** Which face each separate part of the arrangement lies in. */
function nestOutsides(traced: Traced, outsides: readonly number[]): number[][] {
  const holes: number[][] = Array.from(traced.faceEdge, () => []);
  if (outsides.length < 2) return holes;
  for (const h of outsides) {
    const own = new Set<number>();
    let g = h;
    do {
      own.add(traced.origin[g]);
      g = traced.next[g];
    } while (g !== h);
    const [px, py] = [traced.x[traced.origin[h]], traced.y[traced.origin[h]]];
    let best = -1;
    for (let f = 0; f < traced.faceEdge.length; f++) {
      if (best >= 0 && traced.areas[f] >= traced.areas[best]) continue;
      if (own.has(traced.origin[traced.faceEdge[f]])) continue;
      if (isInFace(traced, f, px, py)) best = f;
    }
    if (best < 0) continue;
    holes[best].push(h);
    g = h;
    do {
      traced.face[g] = best;
      g = traced.next[g];
    } while (g !== h);
  }
  return holes;
}

function isInFace({ x, y, origin, next, faceEdge }: Traced, f: number, px: number, py: number): boolean {
  let isInside = false;
  let h = faceEdge[f];
  do {
    const [u, v] = [origin[h], origin[h ^ 1]];
    if (u < 0) break;
    if (y[u] > py !== y[v] > py && px < x[u] + ((py - y[u]) / (y[v] - y[u])) * (x[v] - x[u]))
      isInside = !isInside;
    h = next[h];
  } while (h !== faceEdge[f]);
  return isInside;
}

/** The ring that half edge `h` is part of. */
export function ringFrom(
  { x, y, origin, next }: Pick<Arrangement, 'x' | 'y' | 'origin' | 'next'>,
  h: number,
): Ring {
  const ring: number[] = [];
  let g = h;
  do {
    ring.push(x[origin[g]], y[origin[g]]);
    g = next[g];
  } while (g !== h);
  return Float64Array.from(ring);
}
