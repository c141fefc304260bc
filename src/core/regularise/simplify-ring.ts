import { isCounterClockwise, reverseRing, signedArea } from '../geometry/rings.ts';
import type { RegularisationPass, Ring } from '../types.ts';
import { cutRing, cutVertices, joinLines } from './cut-ring.ts';
import { douglasPeucker } from './douglas-peucker.ts';
import { placesIn } from './places-in.ts';
import { radialDistanceInRing } from './radial-distance.ts';
import { settleRings } from './settle-rings.ts';
import { visvalingam } from './visvalingam.ts';

/** The passes that only drop vertices. */
export type SimplifyingPass = Exclude<RegularisationPass, 'noise' | 'corners'>;

export interface Tolerances {
  /** Radial distance and Douglas-Peucker, m. */
  readonly epsilon: number;
  /** Visvalingam, m². */
  readonly areaEpsilon: number;
}

export interface SimplifiedRings {
  readonly rings: readonly Ring[];
  /** Rings smaller than the tolerance: a pass alone would have left nothing of them that encloses an area. */
  readonly vanished: number;
}

/**
 * Simplifies one ring by the passes named, in the order given; see {@link simplifyRings}.
 *
 * @param ring simple
 * @returns simple ring with the same sense of rotation and at least three vertices, all from the ring given
 */
export function simplifyRing(
  ring: Ring,
  { passes, ...tolerances }: Tolerances & { readonly passes: readonly SimplifyingPass[] },
): Ring {
  let rings: readonly Ring[] = [ring];
  for (const pass of passes) rings = simplifyRings(rings, pass, tolerances).rings;
  return rings[0];
}

/**
 * One pass over rings that stay apart, each in or out of the other as before. Where it makes an edge cross another, or a
 * ring turn over or vanish, the vertex dropped farthest from that edge comes back, until all is well: the tolerance
 * shrinks there and nowhere else.
 *
 * The vertices that stay do not depend on the vertex a ring starts with, nor on the way it turns.
 *
 * @param rings simple, not crossing each other; no vertex twice in a ring
 */
export function simplifyRings(
  rings: readonly Ring[],
  pass: SimplifyingPass,
  tolerances: Tolerances,
): SimplifiedRings {
  // All walked one way round, so that ties fall the same way.
  const isTurned = rings.map((ring) => !isCounterClockwise(ring));
  const walked = rings.map((ring, r) => (isTurned[r] ? reverseRing(ring) : ring));
  const wanted = walked.map((ring) => applyPass(ring, pass, tolerances));
  const drafts = walked.map((ring, r) => ({ kept: placesIn(ring, wanted[r]).sort((a, b) => a - b) }));
  const settled = settleRings(walked, drafts);
  return {
    rings: settled.map((ring, r) => (isTurned[r] ? reverseRing(ring) : ring)),
    vanished: wanted.filter((ring) => hasVanished(ring, pass, tolerances)).length,
  };
}

function applyPass(ring: Ring, pass: SimplifyingPass, { epsilon, areaEpsilon }: Tolerances): Ring {
  if (pass === 'visvalingam') return visvalingam(ring, areaEpsilon);
  const passOf = pass === 'radial' ? radialDistanceInRing : douglasPeucker;
  const [there, back] = cutRing(ring, cutVertices(ring));
  return joinLines([passOf(there, epsilon), passOf(back, epsilon)]);
}

/** Visvalingam stops at three vertices of its own accord. */
function hasVanished(wanted: Ring, pass: SimplifyingPass, { areaEpsilon }: Tolerances): boolean {
  if (wanted.length < 6) return true;
  return pass === 'visvalingam' && wanted.length === 6 && Math.abs(signedArea(wanted)) < areaEpsilon;
}
