/** Places nearer to each other are one vertex, m: far below what a scan tells, far above what float64 rounds. */
const SAME_PLACE = 1e-5;

/** Stands for nothing. */
export const NO_LINE = -1;
/** Stands for a return that joins two faces of a wall, seen or not. */
export const RETURN_LINE = -2;

/** A straight stretch of the plane's subdivision. */
export interface Segment {
  readonly ax: number;
  readonly ay: number;
  readonly bx: number;
  readonly by: number;
  /** What it stands for, as its maker numbers it; {@link NO_LINE} for a stroke that only cuts, {@link RETURN_LINE} for a return. */
  readonly line: number;
}

/** Segments cut at each other. */
export interface CutSegments {
  /** Vertices, m. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly edges: Edges;
}

/** Edges between vertices, each once. */
export interface Edges {
  readonly a: readonly number[];
  readonly b: readonly number[];
  /** Lines each lies on; several where segments overlap. */
  readonly lines: readonly (readonly number[])[];
}

/** Cuts segments where they meet; edges that end in nothing are taken away. O(n²) comparisons of bounding boxes. */
export function cutSegments(segments: readonly Segment[]): CutSegments {
  const { places, chains } = chainsOf(segments);
  const edges = withoutDangling(uniqueEdges(segments, chains), places.count);
  return { x: Float64Array.from(places.xs), y: Float64Array.from(places.ys), edges };
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

function chainsOf(segments: readonly Segment[]): Cut {
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

function uniqueEdges(segments: readonly Segment[], chains: readonly (readonly number[])[]): Edges {
  const edges = { a: [] as number[], b: [] as number[], lines: [] as number[][] };
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
