import { openEdges, type TriangleMesh } from './triangle-mesh.ts';

/** A vertex on the way along an open edge: its number and its place from 0 (edge start) to 1 (edge end). */
interface Stop {
  readonly vertex: number;
  readonly at: number;
}

/**
 * Closes T-junctions: a triangle whose edge runs past a vertex of its neighbours is split at that vertex.
 *
 * earcut drops vertices on straight runs and BSP trees cut one side of an edge only; both leave edges without a
 * partner though no gap is to be seen. Every split adds one triangle, so nothing is lost and nothing gets thin.
 *
 * @param tolerance how far from an edge a vertex may lie and still count as on it, metres
 * @returns the same vertices with more triangles; the mesh itself when nothing was open. Open edges × vertices on
 * open edges near them in x.
 */
export function closeTJunctions(mesh: TriangleMesh, tolerance: number): TriangleMesh {
  const open = openEdges(mesh.indices);
  if (open.length === 0) return mesh;
  const stops = new Map<string, readonly number[]>();
  const { positions } = mesh;
  const byX = [...new Set(open)].sort((a, b) => positions[3 * a] - positions[3 * b] || a - b);
  const openKeys = new Set<string>();
  for (let i = 0; i < open.length; i += 2) openKeys.add(`${open[i]} ${open[i + 1]}`);
  for (let i = 0; i < open.length; i += 2) {
    const [from, to] = [open[i], open[i + 1]];
    const onEdge = stopsOn(positions, { from, to, byX, tolerance });
    if (onEdge.length > 0)
      stops.set(`${from} ${to}`, oneEachPlace(onEdge, from, openKeys, tolerance / length(mesh, from, to)));
  }
  if (stops.size === 0) return mesh;
  const indices: number[] = [];
  for (let i = 0; i < mesh.indices.length; i += 3) {
    splitTriangle([mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]], stops, indices);
  }
  return { positions, indices: Uint32Array.from(indices) };
}

const length = ({ positions: p }: TriangleMesh, a: number, b: number): number =>
  Math.hypot(p[3 * b] - p[3 * a], p[3 * b + 1] - p[3 * a + 1], p[3 * b + 2] - p[3 * a + 2]);

function stopsOn(
  p: Float64Array,
  edge: { from: number; to: number; byX: readonly number[]; tolerance: number },
): Stop[] {
  const [a, b] = [3 * edge.from, 3 * edge.to];
  const [dx, dy, dz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
  const edgeLength = Math.hypot(dx, dy, dz);
  const stops: Stop[] = [];
  const end = Math.max(p[a], p[b]) + edge.tolerance;
  for (let k = firstFrom(p, edge.byX, Math.min(p[a], p[b]) - edge.tolerance); k < edge.byX.length; k++) {
    const vertex = edge.byX[k];
    if (p[3 * vertex] > end) break;
    const [x, y, z] = [p[3 * vertex] - p[a], p[3 * vertex + 1] - p[a + 1], p[3 * vertex + 2] - p[a + 2]];
    const along = (x * dx + y * dy + z * dz) / edgeLength;
    if (along <= edge.tolerance || along >= edgeLength - edge.tolerance) continue;
    const share = along / edgeLength;
    const away = Math.hypot(x - share * dx, y - share * dy, z - share * dz);
    if (away <= edge.tolerance) stops.push({ vertex, at: share });
  }
  return stops.sort((s, t) => s.at - t.at || s.vertex - t.vertex);
}

/** The first of the vertices sorted by x that is not before x. */
function firstFrom(p: Float64Array, byX: readonly number[], x: number): number {
  let [low, high] = [0, byX.length];
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (p[3 * byX[middle]] < x) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Where several vertices share a place (rings that touch), takes the one that the open edges lead to. */
function oneEachPlace(stops: readonly Stop[], from: number, openKeys: Set<string>, same: number): number[] {
  const chosen: number[] = [];
  let previous = from;
  for (let i = 0; i < stops.length; ) {
    let end = i + 1;
    while (end < stops.length && stops[end].at - stops[i].at <= same) end++;
    const here = stops.slice(i, end).map(({ vertex }) => vertex);
    previous = here.find((vertex) => openKeys.has(`${vertex} ${previous}`)) ?? here[0];
    chosen.push(previous);
    i = end;
  }
  return chosen;
}

/** Cuts a triangle at a stop on one of its edges and goes on with the two parts. */
function splitTriangle(
  triangle: readonly [number, number, number],
  stops: ReadonlyMap<string, readonly number[]>,
  into: number[],
): void {
  for (let turn = 0; turn < 3; turn++) {
    const [from, to, apex] = [triangle[turn], triangle[(turn + 1) % 3], triangle[(turn + 2) % 3]];
    const onEdge = stops.get(`${from} ${to}`);
    if (onEdge === undefined) continue;
    // Fan from the apex; the fan's two outer edges may hold stops of their own.
    const chain = [from, ...onEdge, to];
    for (let i = 0; i + 1 < chain.length; i++) splitTriangle([chain[i], chain[i + 1], apex], stops, into);
    return;
  }
  into.push(...triangle);
}
