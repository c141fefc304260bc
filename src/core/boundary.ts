import { alphaShape } from './boundary/alpha-shape.ts';
import { closeGaps, findGaps, warnOfGaps } from './boundary/bridged-gaps.ts';
import { concavemanRing } from './boundary/concaveman-ring.ts';
import { openGift, reachOpeningLength } from './boundary/gift-opening.ts';
import type { StageContext } from './context.ts';
import { FloorPlanError } from './errors.ts';
import { convexHull } from './geometry/convex-hull.ts';
import { distinctPoints } from './geometry/point-order.ts';
import { orientation } from './geometry/predicates.ts';
import { boundsOf, signedArea } from './geometry/rings.ts';
import { meanSpacing } from './geometry/spacing.ts';
import type { Options } from './params.ts';
import type { Boundary, Polygon, Ring, Slice } from './types.ts';

/** Opening length `auto`, in mean spacings … */
const OPENING_SPACINGS = 8;
/**
 * … and at least this, m: shorter, the ring would follow the noise of a wall instead of the wall. On ten scanned
 * scenes 0.1, 0.2, 0.3, 0.5 and 1 m gave an IoU of .969, .967, .963, .957 and .950.
 */
const SHORTEST_OPENING = 0.1;
/** α `auto`, in mean spacings, and at least, m: below, walls hidden in part fall apart into pieces. */
const ALPHA_SPACINGS = 20;
const SHORTEST_ALPHA = 0.5;
/** Narrower gaps are not told of: a door frame, a cupboard's shadow. */
const NARROWEST_GAP = 0.2;
/** An outline with less than this share of its convex hull's area has fallen through a gap, or apart. */
const LEAST_FILL = 0.25;

/**
 * The primary boundary of a slice [Stojanovic19] §3: gift opening by default, the other methods beside it.
 *
 * @param slice x, y a point, m, plan frame; the order of the points does not matter
 * @returns simple rings, outer ones counter-clockwise, holes clockwise; one polygon but for the α-shape
 * @throws result/no-boundary when the slice is empty or α leaves no triangle; input/not-finite; input/degenerate when
 *   all points lie on one line
 */
export function findBoundary(slice: Slice, options: Options, context: StageContext): Boundary {
  checkFinite(slice.xy);
  const points = distinctPoints(slice.xy);
  checkSpread(points);
  const spacing = slice.spacing > 0 ? slice.spacing : meanSpacing(points);
  const plain = { method: options.boundary, openingLength: 0, gaps: [] };
  switch (options.boundary) {
    case 'gift-opening':
      return giftBoundary(points, spacing, options, context);
    case 'convex':
      return { ...plain, polygons: [asPolygon(convexHull(points))] };
    case 'concaveman':
      return { ...plain, polygons: [asPolygon(concavemanRing(points, options.concavity))] };
    case 'alpha-shape':
      return { ...plain, polygons: alphaPolygons(points, spacing, options, context) };
  }
}

function giftBoundary(
  points: Float64Array,
  spacing: number,
  options: Options,
  context: StageContext,
): Boundary {
  const automatic = Math.max(SHORTEST_OPENING, OPENING_SPACINGS * spacing);
  const openingLength = options.openingLength === 'auto' ? automatic : options.openingLength;
  const supportLength = Math.max(NARROWEST_GAP, automatic);
  // An edge over a gap ends at the last points beside it, up to a step away on either side.
  const bridgeLimit = options.bridgeGap > 0 ? options.bridgeGap + supportLength : 0;
  const rules = { openingLength, supportLength, bridgeLimit, spacing };
  warnOfLongOpening(points, openingLength, options, context);
  const opening = openGift(points, rules);
  const found = findGaps(opening, options.bridgeGap);
  reachOpeningLength(opening, rules);
  const { ring, gaps } = closeGaps(opening, found);
  warnOfGaps(gaps, context);
  const hint = `Raise the opening length, or bridgeGap, now ${options.bridgeGap} m.`;
  warnOfCollapse(opening.area / opening.hullArea, hint, context);
  return { method: 'gift-opening', polygons: [asPolygon(ring)], openingLength, gaps };
}

function warnOfLongOpening(
  points: Float64Array,
  openingLength: number,
  options: Options,
  context: StageContext,
): void {
  const { minX, minY, maxX, maxY } = boundsOf(points);
  const extent = Math.hypot(maxX - minX, maxY - minY);
  if (openingLength < extent) return;
  context.warn({
    code: 'boundary/not-opened',
    message: `The opening length, ${Number(openingLength.toPrecision(3))} m, is no shorter than the slice, ${extent.toFixed(2)} m across; the outline is its convex hull.`,
    hint:
      options.openingLength === 'auto'
        ? 'The points are too few, or too far apart, to tell more of the shape; check the unit.'
        : 'Lower the opening length, or let it be auto; check the unit.',
  });
}

function warnOfCollapse(share: number, hint: string, context: StageContext): void {
  if (share >= LEAST_FILL) return;
  const percent = share < 0.01 ? 'less than 1' : (100 * share).toFixed(0);
  context.warn({
    code: 'boundary/collapsed',
    message: `The outline holds only ${percent} % of the area of its convex hull; it may have fallen into the rooms, or apart.`,
    hint,
  });
}

function alphaPolygons(
  points: Float64Array,
  spacing: number,
  options: Options,
  context: StageContext,
): readonly Polygon[] {
  const automatic = Math.max(SHORTEST_ALPHA, ALPHA_SPACINGS * spacing);
  const alpha = options.alpha === 'auto' ? automatic : options.alpha;
  const polygons = alphaShape(points, alpha);
  if (polygons.length === 0) {
    throw new FloorPlanError(
      'result/no-boundary',
      `expected triangles of radius up to ${alpha} m, found none`,
      {
        hint: 'Raise alpha, or let it be auto.',
        detail: { alpha },
      },
    );
  }
  const area = polygons.reduce((sum, { outer }) => sum + signedArea(outer), 0);
  warnOfCollapse(area / signedArea(convexHull(points)), `Raise alpha, now ${alpha} m.`, context);
  return polygons;
}

function asPolygon(outer: Ring): Polygon {
  return { outer, holes: [] };
}

function checkFinite(xy: Float64Array): void {
  for (let i = 0; i < xy.length; i++) {
    if (Number.isFinite(xy[i])) continue;
    throw new FloorPlanError(
      'input/not-finite',
      `slice point ${i >> 1}: expected a finite coordinate, found ${xy[i]}`,
      {
        hint: 'Remove points without coordinates from the slice.',
        detail: { point: i >> 1 },
      },
    );
  }
}

function checkSpread(points: Float64Array): void {
  const n = points.length >> 1;
  if (n === 0) {
    throw new FloorPlanError('result/no-boundary', 'expected points in the slice, found none', {
      hint: 'Choose another level or a wider height band.',
    });
  }
  for (let i = 2; i < points.length - 2; i += 2) {
    const last = points.length - 2;
    if (orientation(points[0], points[1], points[last], points[last + 1], points[i], points[i + 1]) !== 0)
      return;
  }
  throw new FloorPlanError(
    'input/degenerate',
    `expected three points or more that are not on one line, found ${n} distinct points${n > 2 ? ' on one line' : ''}`,
    { hint: 'Choose another level, a wider height band, or check the up axis.', detail: { points: n } },
  );
}
