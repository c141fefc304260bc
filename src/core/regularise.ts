import { pointInRing } from './geometry/rings.ts';
import type { Options } from './params.ts';
import { simplifyRings, type Tolerances } from './regularise/simplify-ring.ts';
import type { Boundary, Polygon, RegularisationPass, RegularisedBoundary, Ring, Slice } from './types.ts';

/** ε `auto`, in mean spacings [Stojanovic19] §5 … */
const EPSILON_SPACINGS = 4;
/** … and at least this, m: on ten scanned scenes 24 mm kept twice the vertices and no more of the truth. */
const LEAST_EPSILON = 0.05;

/**
 * Regularises a boundary by the three passes of [Stojanovic19] §3, those that are switched on, in the paper's order:
 * radial distance, Douglas-Peucker, Visvalingam.
 *
 * Rings are cut at two canonical vertices, so none is privileged. No pass lets rings cross; see {@link simplifyRings}.
 *
 * @param slice its spacing scales the automatic tolerances
 */
export function regulariseBoundary(boundary: Boundary, slice: Slice, options: Options): RegularisedBoundary {
  const tolerances = tolerancesFor(slice, options);
  const passes: { name: RegularisationPass; polygons: readonly Polygon[] }[] = [];
  let { polygons } = boundary;
  for (const name of passesOf(options)) {
    polygons = regularisePolygons(polygons, name, tolerances);
    passes.push({ name, polygons });
  }
  return { passes, polygons };
}

/** The passes that are switched on, in the paper's order. */
export function passesOf(options: Options): RegularisationPass[] {
  const passes: RegularisationPass[] = [];
  if (options.radialPass) passes.push('radial');
  if (options.douglasPeuckerPass) passes.push('douglas-peucker');
  if (options.visvalingamPass) passes.push('visvalingam');
  return passes;
}

/** Tolerances in metres and m², `auto` worked out. */
export function tolerancesFor(slice: Slice, options: Options): Tolerances {
  const automatic = Math.max(LEAST_EPSILON, EPSILON_SPACINGS * slice.spacing);
  const epsilon = options.epsilon === 'auto' ? automatic : options.epsilon;
  const areaEpsilon = options.visvalingamEpsilon === 'auto' ? epsilon ** 2 : options.visvalingamEpsilon;
  return { epsilon, areaEpsilon };
}

function regularisePolygons(
  polygons: readonly Polygon[],
  pass: RegularisationPass,
  tolerances: Tolerances,
): readonly Polygon[] {
  const rings: Ring[] = polygons.flatMap(({ outer, holes }) => [outer, ...holes]);
  const simplified = simplifyRings(rings, pass, tolerances);
  let at = 0;
  const result = polygons.map(({ holes }) => ({
    outer: simplified[at++],
    holes: holes.map(() => simplified[at++]),
  }));
  return result.every(holdsItsHoles) ? result : polygons;
}

/** A small hole beside an outer ring may end up outside it without a crossing. */
function holdsItsHoles({ outer, holes }: Polygon): boolean {
  return holes.every((hole) => {
    for (let i = 0; i < hole.length; i += 2) {
      const place = pointInRing(hole[i], hole[i + 1], outer);
      if (place !== 0) return place > 0;
    }
    return true;
  });
}
