import { contains, distanceToRing, type XY } from '../../fixtures/simulator/ring.ts';
import type { StoreyFacts, WallFacts } from './facts.ts';
import type { Measures } from './measures.ts';
import { quantile } from './outlines.ts';
import { type TrueWall, trueWalls } from './true-walls.ts';

/** A found wall stands for a true one whose axis it covers, or passes this near, m. */
const REACH = 0.15;
const MM = 1000;

/**
 * Thickness of the walls whose two faces were both seen, against the plan's; walls the plan calls inferred are left out
 * and counted. Outer walls, whose far face no station sees, are judged apart where the plan claims to know them.
 */
export function measureWalls(plan: StoreyFacts, truth: StoreyFacts): Measures {
  const walls = trueWalls(truth);
  const pairs = walls.map((wall) => ({ wall, found: standsFor(wall, plan.walls) }));
  const isKnown = (found: WallFacts | null): found is WallFacts => found !== null && !found.isInferred;
  const errors = (isAsked: (wall: TrueWall) => boolean): number[] =>
    pairs.flatMap(({ wall, found }) =>
      isAsked(wall) && isKnown(found) ? [Math.abs(found.thickness - wall.thickness) * MM] : [],
    );
  const inner = errors(({ isSeen }) => isSeen);
  const outer = errors(({ isOuter }) => isOuter);
  const asked = walls.filter(({ isSeen }) => isSeen).length;
  return {
    ...(inner.length > 0 ? { wallThicknessErrorMm: quantile(inner, 0.5) } : {}),
    ...(asked > 0 ? { wallsMeasured: inner.length / asked } : {}),
    ...(outer.length > 0 ? { outerThicknessErrorMm: quantile(outer, 0.5) } : {}),
    wallsInferred: plan.walls.filter(({ isInferred }) => isInferred).length,
  };
}

/** The found wall on most of the true one's axis. */
function standsFor({ axis }: TrueWall, walls: readonly WallFacts[]): WallFacts | null {
  const votes = new Map<WallFacts, number>();
  for (const point of axis) {
    const wall = wallAt(point, walls);
    if (wall !== null) votes.set(wall, (votes.get(wall) ?? 0) + 1);
  }
  const [best] = [...votes].sort(([, a], [, b]) => b - a);
  return best && best[1] >= axis.length / 2 ? best[0] : null;
}

function wallAt([x, y]: XY, walls: readonly WallFacts[]): WallFacts | null {
  let best: WallFacts | null = null;
  let nearest = REACH;
  for (const wall of walls) {
    const isInside = wall.outline.reduce((inside, ring) => (contains(ring, x, y) ? !inside : inside), false);
    const away = isInside ? 0 : Math.min(...wall.outline.map((ring) => distanceToRing(ring, x, y)));
    if (away < nearest) [best, nearest] = [wall, away];
  }
  return best;
}
