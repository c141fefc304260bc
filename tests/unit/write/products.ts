import type { Slice } from '../../../src/core/types.ts';
import { makeSolid } from '../../../src/solid/make-solid.ts';
import type { Product } from '../../../src/write/plan-writer.ts';
import { drawSheets } from '../../../src/write/sheet/draw-sheet.ts';
import { type PlanFacts, planOf, rectangle, ring, secondary, wallAround } from '../solid/plans.ts';

/** Products made by hand, for the tests of writers. */

export async function productOf(facts: PlanFacts = {}, name = 'room'): Promise<Product> {
  const plan = planOf(facts);
  const solid = await makeSolid(plan, plan.options);
  const xy = plan.storeys.flatMap(({ primary }) => [...primary[0].outer]);
  const slice: Slice = { xy: Float64Array.from(xy), band: [1, 2], spacing: 0.02 };
  const drawn = { name, plan, slice, options: plan.options };
  return { ...drawn, solid, sheet: drawSheets(drawn) };
}

/** An L-shaped home of 12 m × 9 m with a column, a shaft and one gap in its wall. */
export function home(): PlanFacts {
  const inner = ring(0.2, 0.2, 11.8, 0.2, 11.8, 5.2, 6.8, 5.2, 6.8, 8.8, 0.2, 8.8);
  return {
    name: 'home_l.ply',
    storeys: [
      {
        primary: [{ outer: inner, holes: [] }],
        walls: [{ outline: wallAround(inner, 0.2), thickness: 0.2, confidence: 0.93 }],
        secondary: [
          secondary(rectangle(4.6, 2.6, 0.45, 0.45), 'add'),
          secondary(rectangle(0.2, 6.6, 1.6, 2.2), 'subtract'),
          secondary(rectangle(8.6, 1.4, 1.2, 0.8), 'independent'),
        ],
        gaps: [{ from: [8.9, 5.2], to: [10.1, 5.2], width: 1.2 }],
      },
    ],
  };
}
