import type { Path64, PolyPath64 } from 'clipper2-ts';
import type { Polygon, Ring } from '../types.ts';

/** A ring of a clipper2 result in metres, turned as asked; null for what rounding left over. */
type ToRing = (path: Path64, turn: 'counter-clockwise' | 'clockwise') => Ring | null;

/** The areas of a clipper2 tree, which alternates outer rings and holes; islands within holes become polygons of their own. */
export function polygonsOf(node: PolyPath64, toRing: ToRing, into: Polygon[] = []): Polygon[] {
  for (let i = 0; i < node.count; i++) {
    const outerNode = node.child(i);
    const outer = toRing(outerNode.poly ?? [], 'counter-clockwise');
    const holes: Ring[] = [];
    for (let j = 0; j < outerNode.count; j++) {
      const hole = toRing(outerNode.child(j).poly ?? [], 'clockwise');
      if (hole !== null) holes.push(hole);
      polygonsOf(outerNode.child(j), toRing, into);
    }
    if (outer !== null) into.push({ outer, holes });
  }
  return into;
}
