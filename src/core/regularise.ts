import type { StageContext } from './context.ts';
import { ringsOf } from './geometry/rings.ts';
import type { Options } from './params.ts';
import { restoreCorners } from './regularise/restore-corners.ts';
import { type SimplifyingPass, simplifyRings, type Tolerances } from './regularise/simplify-ring.ts';
import { takeOffNoise } from './regularise/take-off-noise.ts';
import type { Boundary, Polygon, RegularisationPass, RegularisedBoundary, Ring, Slice } from './types.ts';

/** ε `auto`, in mean spacings [Stojanovic19] §5 … */
const EPSILON_SPACINGS = 4;
/** … and at least this, m: on ten scanned scenes 24 mm kept twice the vertices and no more of the truth. */
const LEAST_EPSILON = 0.05;

/**
 * Regularises a boundary by the passes that are switched on: ours that takes off the noise, the three of [Stojanovic19] §3
 * in the paper's order (radial distance, Douglas-Peucker, Visvalingam), then ours that restores corners.
 *
 * Rings are closed lines: no vertex is privileged. No pass lets rings cross; see {@link takeOffNoise},
 * {@link simplifyRings} and {@link restoreCorners}. A ring smaller than a tolerance keeps as few vertices as are valid, with a warning.
 *
 * @param slice its spacing scales the automatic tolerances, its points carry the walls and corners
 */
export function regulariseBoundary(
  boundary: Boundary,
  slice: Slice,
  options: Options,
  context: Pick<StageContext, 'warn'>,
): RegularisedBoundary {
  const tolerances = tolerancesFor(slice, options);
  const hulls = ringsOf(boundary.polygons);
  const passes: { name: RegularisationPass; polygons: readonly Polygon[] }[] = [];
  const from = options.noisePass ? takeOffNoise(hulls, slice) : hulls;
  if (options.noisePass) passes.push({ name: 'noise', polygons: asPolygons(from, boundary.polygons) });
  let rings = from;
  let vanished = 0;
  for (const name of passesOf(options)) {
    const simplified = simplifyRings(rings, name, tolerances);
    rings = simplified.rings;
    vanished = Math.max(vanished, simplified.vanished);
    passes.push({ name, polygons: asPolygons(rings, boundary.polygons) });
  }
  if (options.cornerPass) {
    rings = restoreCorners(rings, hulls, slice, { from });
    passes.push({ name: 'corners', polygons: asPolygons(rings, boundary.polygons) });
  }
  warnOfVanished(vanished, tolerances, context);
  return { passes, polygons: passes.at(-1)?.polygons ?? boundary.polygons };
}

/** The passes of the paper that are switched on, in its order. */
export function passesOf(options: Options): SimplifyingPass[] {
  const passes: SimplifyingPass[] = [];
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

/** The inverse of {@link ringsOf}, with as many holes each as `model` has. */
function asPolygons(rings: readonly Ring[], model: readonly Polygon[]): readonly Polygon[] {
  let at = 0;
  return model.map(({ holes }) => ({ outer: rings[at++], holes: holes.map(() => rings[at++]) }));
}

const CM2_PER_M2 = 10_000;

function warnOfVanished(
  rings: number,
  { epsilon, areaEpsilon }: Tolerances,
  { warn }: Pick<StageContext, 'warn'>,
): void {
  if (rings === 0) return;
  const round = (value: number) => Number(value.toPrecision(3));
  warn({
    code: 'regularise/epsilon-too-large',
    message: `${rings === 1 ? 'One ring' : `${rings} rings`} of the outline ${rings === 1 ? 'is' : 'are'} smaller than the tolerance (${round(epsilon)} m, ${round(areaEpsilon * CM2_PER_M2)} cm²) and kept only the vertices a ring needs.`,
    hint: 'Lower epsilon and visvalingamEpsilon, or let them be auto.',
  });
}
