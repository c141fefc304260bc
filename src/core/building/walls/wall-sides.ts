import { edgesBetween } from '../../geometry/ring-arcs.ts';
import { ringsOf } from '../../geometry/rings.ts';
import type { Polygon, RingArc } from '../../types.ts';

/** A stretch of an outline along which one wall stands: an edge, or the chords of a curve. */
export interface WallSide {
  /** Number of its first edge, counted through all rings, outer ring first, polygon by polygon; the others follow in its ring. */
  readonly edges: readonly number[];
  readonly arc?: RingArc;
}

/** The sides of outlines, by their first edges. A whole circle has two. */
export function sidesOf(outlines: readonly Polygon[]): WallSide[] {
  let first = 0;
  return outlines.flatMap((outline) =>
    ringsOf([outline]).flatMap((ring, k) => {
      const n = ring.length / 2;
      const arcs = (outline.arcs ?? []).filter((arc) => arc.ring === k);
      const sides = sidesOfRing(n, arcs).map(
        (side): WallSide => ({ ...side, edges: side.edges.map((edge) => first + edge) }),
      );
      first += n;
      return sides;
    }),
  );
}

function sidesOfRing(n: number, arcs: readonly RingArc[]): WallSide[] {
  const curved = arcs.flatMap((arc): WallSide[] => {
    const count = edgesBetween(arc.from, arc.to, n);
    const edges = Array.from({ length: count }, (_, k) => (arc.from + k) % n);
    if (count < n) return [{ edges, arc }];
    return [
      { edges: edges.slice(0, n >> 1), arc },
      { edges: edges.slice(n >> 1), arc },
    ];
  });
  const taken = new Set(curved.flatMap(({ edges }) => edges));
  const straight = Array.from({ length: n }, (_, edge): WallSide => ({ edges: [edge] })).filter(
    ({ edges }) => !taken.has(edges[0]),
  );
  return [...curved, ...straight].sort((a, b) => a.edges[0] - b.edges[0]);
}
