import type { SeenSpace } from '../columns/seen-space.ts';
import type { Face } from '../faces/face.ts';
import { type FaceSupport, TAKEN_SHARE, WALL_SHARE } from '../faces/face-support.ts';
import { standsFree } from './free-standing.ts';
import { withCorners } from './wall-corners.ts';
import { goesOnOver } from './wall-gaps.ts';
import { withPartners } from './wall-partners.ts';

/**
 * Support of faces with what no point shows but the building tells: a wall goes on behind furniture, over a passage, to the
 * corner with another, and where its other face was seen.
 */
export function takenSupport(
  faces: readonly Face[],
  supports: readonly FaceSupport[],
  seen: SeenSpace,
): FaceSupport[] {
  return withCorners(faces, goOn(faces, withPartners(faces, supports, seen), supports, seen), supports, seen);
}

/** Lets walls go on over gaps between two stretches of them, unless another wall passes by at both ends: a corridor. */
function goOn(
  faces: readonly Face[],
  supports: readonly FaceSupport[],
  own: readonly FaceSupport[],
  seen: SeenSpace,
): FaceSupport[] {
  return supports.map((support, i) => {
    const { from, step } = support;
    const shares = support.shares.map((share, k) => (own[i].shares[k] >= WALL_SHARE ? 1 : share));
    const stretches = stretchesOf(support).filter((stretch) => !standsFree({ faces, own, i }, stretch, seen));
    stretches.slice(1).forEach((stretch, s) => {
      const [begin, end] = [stretches[s].to, stretch.from];
      if (!goesOnOver({ faces, own, i, begin, end }, seen)) return;
      const [first, last] = [begin, end].map((along) => Math.round((along - from) / step));
      for (let m = first; m < last; m++) shares[m] = Math.max(shares[m], TAKEN_SHARE);
    });
    return { ...support, shares };
  });
}

/** Stretches of a face that stand in one, as places along it, m. */
function stretchesOf({ from, step, shares }: FaceSupport): { readonly from: number; readonly to: number }[] {
  const stretches: { from: number; to: number }[] = [];
  for (let k = 0; k < shares.length; k++) {
    if (shares[k] < WALL_SHARE) continue;
    const last = stretches.at(-1);
    const [begin, end] = [from + k * step, from + (k + 1) * step];
    if (last && begin - last.to < step / 2) last.to = end;
    else stretches.push({ from: begin, to: end });
  }
  return stretches;
}
