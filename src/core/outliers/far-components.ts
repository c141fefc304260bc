import { joinTouchingCells } from '../touching-cells.ts';
import { indexCells } from './cell-index.ts';

/** A component with fewer than this share of the largest one's points is small. */
const SMALL_SHARE = 0.005;

/** Points and extent of a component of touching cells. */
interface Component {
  points: number;
  readonly min: Float64Array;
  readonly max: Float64Array;
}

/**
 * Flags the points of small components outside the bounding box of the largest: what was seen through a
 * window.
 *
 * Components are cells joined at faces, edges and corners. O(n).
 *
 * @param positions x, y, z a point; at least one
 * @param edge cell edge: components lie at least this far apart
 */
export function flagFarComponents(positions: Float32Array, edge: number): Uint8Array {
  const { table, sorted, source, start } = indexCells(positions, edge);
  const componentOf = joinTouchingCells(table);
  const components = measure(componentOf, sorted, start);
  const largest = components.reduce((a, b) => (b.points > a.points ? b : a));
  const isFar = new Uint8Array(source.length);
  for (let cell = 0; cell < table.count; cell++) {
    const component = components[componentOf[cell]];
    if (component.points >= SMALL_SHARE * largest.points || isInside(component, largest)) continue;
    for (let i = start[cell]; i < start[cell + 1]; i++) isFar[source[i]] = 1;
  }
  return isFar;
}

function measure(componentOf: Uint32Array, sorted: Float32Array, start: Uint32Array): Component[] {
  const components: Component[] = [];
  for (let cell = 0; cell < componentOf.length; cell++) {
    components[componentOf[cell]] ??= {
      points: 0,
      min: new Float64Array(3).fill(Infinity),
      max: new Float64Array(3).fill(-Infinity),
    };
    const component = components[componentOf[cell]];
    component.points += start[cell + 1] - start[cell];
    for (let i = 3 * start[cell]; i < 3 * start[cell + 1]; i++) {
      const axis = i % 3;
      component.min[axis] = Math.min(component.min[axis], sorted[i]);
      component.max[axis] = Math.max(component.max[axis], sorted[i]);
    }
  }
  return components;
}

/** Whether the middle of a component lies in the bounding box of another. */
function isInside(component: Component, { min, max }: Component): boolean {
  return [0, 1, 2].every((axis) => {
    const middle = (component.min[axis] + component.max[axis]) / 2;
    return middle >= min[axis] && middle <= max[axis];
  });
}
