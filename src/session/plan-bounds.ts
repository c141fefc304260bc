import { boundsOfAll, ringsOf } from '../core/geometry/rings.ts';
import type { FloorPlan, Scan, Vec3 } from '../core/types.ts';

/** The box of a plan's walls and rooms from its lowest floor to its highest ceiling: metres, plan frame. */
export function planBox({ storeys }: Pick<FloorPlan, 'storeys'>): { readonly min: Vec3; readonly max: Vec3 } {
  const rings = storeys.flatMap(({ primary, walls, rooms }) =>
    ringsOf([...primary, ...[...walls, ...rooms].map(({ outline }) => outline)]),
  );
  const flat = rings.length > 0 ? boundsOfAll(rings) : { minX: 0, minY: 0, maxX: 0, maxY: 0 };
  return {
    min: [flat.minX, flat.minY, Math.min(...storeys.map(({ floor }) => floor))],
    max: [flat.maxX, flat.maxY, Math.max(...storeys.map(({ floor, height }) => floor + height))],
  };
}

/** The box of a plan along the source's axes, in its units and coordinates; of a turned one, the box around its corners. */
export function planBounds(plan: FloorPlan): Scan['bounds'] {
  const { origin, rotation, metresPerUnit } = plan.frame;
  const box = planBox(plan);
  // The inverse of a rotation is its transpose.
  const ends = [0, 1, 2].map((axis) => {
    const reach = [0, 1, 2].map((k) => [box.min[k], box.max[k]].map((at) => rotation[3 * k + axis] * at));
    const sum = (pick: (...values: number[]) => number) =>
      origin[axis] + reach.reduce((total, pair) => total + pick(...pair), 0) / metresPerUnit;
    return [sum(Math.min), sum(Math.max)] as const;
  });
  return {
    min: ends.map(([low]) => low) as unknown as Vec3,
    max: ends.map(([, high]) => high) as unknown as Vec3,
  };
}
