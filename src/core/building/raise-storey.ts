import type { Options } from '../params.ts';
import { medianOf } from '../robust-scale.ts';
import type { Opening, Storey, Wall } from '../types.ts';
import { placeOpening } from './openings/find-openings.ts';
import { joinedOpenings } from './openings/joined-openings.ts';
import type { StoreyPlan } from './plan-storey.ts';
import { outerWalls } from './walls/outer-walls.ts';
import { sidesOf } from './walls/wall-sides.ts';

/** Reveals shallower than this are a window frame's, m. */
const LEAST_REVEAL = 0.1;

/**
 * A found storey with walls around it: as thick as their reveals are deep, others as the storey's other reveals tell, or as
 * the parameter `wallThickness` says.
 */
export function raiseStorey(
  found: StoreyPlan,
  index: number,
  { wallThickness, wallHeight }: Options,
): Storey {
  const { floor, ceiling, primary, rooms, innerWalls, innerOpenings, secondary, unseen, furniture } = found;
  const shell = outerShell(found, wallThickness);
  return {
    index,
    floor,
    height: wallHeight === 'auto' ? ceiling - floor : wallHeight,
    primary,
    secondary,
    walls: [...innerWalls, ...shell.walls],
    rooms,
    openings: [...innerOpenings, ...shell.openings],
    gaps: unseen,
    ...(furniture && { furniture }),
  };
}

function outerShell(
  { primary, outer }: StoreyPlan,
  usualOuter: number,
): { walls: Wall[]; openings: Opening[] } {
  const sides = sidesOf(primary);
  const reveals = sides.map(({ edges }) =>
    Float64Array.from(
      edges.flatMap((edge) =>
        outer[edge].found.map(({ reveal }) => reveal).filter((reveal) => reveal > LEAST_REVEAL),
      ),
    ),
  );
  const all = Float64Array.from(reveals.flatMap((own) => [...own]));
  const usual = all.length > 0 ? medianOf(all) : usualOuter;
  const thicknesses = reveals.map((own) => (own.length > 0 ? medianOf(own) : usual));
  const walls = outerWalls(primary, thicknesses).map(({ side, ...wall }): Wall => {
    const isKnown = reveals[side].length > 0;
    return { ...wall, confidence: 1, ...(!isKnown && { isThicknessInferred: true }) };
  });
  const placed = sides.flatMap(({ edges }, i) =>
    edges.flatMap((edge) =>
      outer[edge].found.map((hole) => placeOpening(hole, outer[edge].stretch, thicknesses[i] / 2)),
    ),
  );
  const openings = joinedOpenings(placed);
  return { walls, openings };
}
