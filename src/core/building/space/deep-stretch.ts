import { OPEN_SHARE, type SeenSpace } from '../columns/seen-space.ts';
import { alongOf, behindOf, isParallel, pointOn } from '../faces/face.ts';
import { type FaceAmong, STEP, wallAt } from '../faces/face-support.ts';

/** Places beside a line are looked at so far off it, m: up to where a cupboard's front may be seen. */
const BESIDE = [0.05, 0.15, 0.25, 0.35];
/** A wall seen this near, m, over so much of a stretch, is what stands there. */
const NEAR = 0.35;
const OTHER_SHARE = 0.5;

/** A stretch of a face, from one place along it to another, m. */
export interface Stretch extends FaceAmong {
  readonly from: number;
  readonly to: number;
}

/**
 * Whether a stretch of a face lies deep in what is hidden, between cupboards that stand back to back: next to nothing was
 * seen along it and beside it, and no other wall near it. O(length · faces).
 *
 * Not taken: whatever other walls stand near (clean corners of a corridor .91 → .82: a wall runs on before a niche).
 */
export function isDeep({ faces, own, i, from, to }: Stretch, seen: SeenSpace): boolean {
  const face = faces[i];
  const near = faces.flatMap((other, j) =>
    j !== i && other.members.length > 0 && isParallel(face, other) ? [{ other, support: own[j] }] : [],
  );
  let [places, withWall, shown] = [0, 0, 0];
  for (let along = from + STEP; along < to; along += STEP) {
    const place = pointOn(face, along);
    places++;
    const standsNear = near.some(
      ({ other, support }) =>
        Math.abs(behindOf(face, other, 1, place)) <= NEAR && wallAt(support, alongOf(other, ...place)),
    );
    if (standsNear) withWall++;
    for (const off of BESIDE) {
      for (const across of [off, -off]) if (seen.at(...pointOn(face, along, across))) shown++;
    }
  }
  return shown <= OPEN_SHARE * 2 * BESIDE.length * places && withWall <= OTHER_SHARE * places;
}
