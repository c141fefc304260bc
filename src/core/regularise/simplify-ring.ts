import { signedArea } from '../geometry/rings.ts';
import { crossingRings } from '../geometry/simplicity.ts';
import type { RegularisationPass, Ring } from '../types.ts';
import { cutRing, cutVertices, joinLines } from './cut-ring.ts';
import { douglasPeucker } from './douglas-peucker.ts';
import { radialDistance } from './radial-distance.ts';
import { visvalingam } from './visvalingam.ts';

/** Times a tolerance is halved before a ring is left as it was. */
const HALVINGS = 6;

export interface Tolerances {
  /** Radial distance and Douglas-Peucker, m. */
  readonly epsilon: number;
  /** Visvalingam, m². */
  readonly areaEpsilon: number;
}

/**
 * Simplifies one ring by the passes named, in the order given; see {@link simplifyRings}.
 *
 * @param ring simple
 * @returns simple ring with the same sense of rotation and at least three vertices, all from the ring given
 */
export function simplifyRing(
  ring: Ring,
  { passes, ...tolerances }: Tolerances & { readonly passes: readonly RegularisationPass[] },
): Ring {
  let rings: readonly Ring[] = [ring];
  for (const pass of passes) rings = simplifyRings(rings, pass, tolerances);
  return rings[0];
}

/**
 * One pass over rings that stay apart: a ring the pass makes cross itself or another, turn over or vanish is done
 * again with half the tolerance, and after {@link HALVINGS} halvings is left as it was.
 *
 * @param rings simple, not crossing each other
 */
export function simplifyRings(
  rings: readonly Ring[],
  pass: RegularisationPass,
  tolerances: Tolerances,
): readonly Ring[] {
  const tries = rings.map(() => 0);
  const result = rings.map((ring) => applyPass(ring, pass, tolerances));
  for (;;) {
    const bad = crossingRings(result);
    rings.forEach((ring, r) => {
      if (hasTurned(ring, result[r])) bad.add(r);
    });
    const open = [...bad].filter((r) => tries[r] <= HALVINGS);
    if (open.length === 0) return bad.size === 0 ? result : rings;
    for (const r of open) {
      tries[r]++;
      result[r] = tries[r] > HALVINGS ? rings[r] : applyPass(rings[r], pass, shrunk(tolerances, tries[r]));
    }
  }
}

function shrunk({ epsilon, areaEpsilon }: Tolerances, halvings: number): Tolerances {
  return { epsilon: epsilon / 2 ** halvings, areaEpsilon: areaEpsilon / 4 ** halvings };
}

function applyPass(ring: Ring, pass: RegularisationPass, { epsilon, areaEpsilon }: Tolerances): Ring {
  if (pass === 'visvalingam') return visvalingam(ring, areaEpsilon);
  const passOf = pass === 'radial' ? radialDistance : douglasPeucker;
  const [there, back] = cutRing(ring, cutVertices(ring));
  return joinLines([passOf(there, epsilon), passOf(back, epsilon)]);
}

function hasTurned(before: Ring, after: Ring): boolean {
  return signedArea(before) > 0 !== signedArea(after) > 0;
}
