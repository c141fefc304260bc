import { distance, distanceToSegment, interpolate, type XY } from '../../fixtures/simulator/ring.ts';
import type { StoreyFacts, Stretch } from './facts.ts';
import type { Measures } from './measures.ts';

/** m */
const STEP = 0.05;
/** The truth knows the ends of a hidden stretch to 10 cm, and a face may lie 5 cm off, m. */
const REACH = 0.15;
/** A shorter stretch is asked of no plan, m. */
const SHORTEST_ASKED = 0.3;

/**
 * Stretches of wall that no point supports, told by the plan against those no ray met, by length.
 *
 * Nothing where the truth does not know what was hidden.
 */
export function measureInferred(plan: StoreyFacts, truth: StoreyFacts): Measures {
  if (truth.hidden === null) return {};
  const asked = truth.hidden.filter(([a, b]) => distance(a, b) >= SHORTEST_ASKED - 1e-9);
  const told = plan.hidden ?? [];
  return {
    inferredM: lengthOf(told),
    inferredRightM: sharedLength(told, truth.hidden),
    hiddenM: lengthOf(asked),
    hiddenToldM: sharedLength(asked, told),
  };
}

const lengthOf = (stretches: readonly Stretch[]): number =>
  stretches.reduce((sum, [a, b]) => sum + distance(a, b), 0);

/** Length of the stretches that lies near the others, in steps. */
function sharedLength(stretches: readonly Stretch[], others: readonly Stretch[]): number {
  const isNear = ([x, y]: XY): boolean => others.some(([a, b]) => distanceToSegment(x, y, a, b) <= REACH);
  return stretches.reduce((sum, [a, b]) => {
    const length = distance(a, b);
    const count = Math.max(1, Math.round(length / STEP));
    const near = Array.from({ length: count }, (_, k) => interpolate(a, b, (k + 0.5) / count)).filter(isNear);
    return sum + (length * near.length) / count;
  }, 0);
}
