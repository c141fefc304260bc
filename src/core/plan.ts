import type { StoreyPlan } from './building/plan-storey.ts';
import { raiseStorey } from './building/raise-storey.ts';
import { largestExtent, trimmedBounds } from './cloud-bounds.ts';
import type { StageContext } from './context.ts';
import { EXTENT } from './frame/judge-unit.ts';
import { areaOf } from './geometry/areas.ts';
import { perimeter } from './geometry/rings.ts';
import { storeyRange } from './level.ts';
import { nameRooms } from './name-rooms.ts';
import type { Options } from './params.ts';
import { doorOutlines, placeDoors } from './place-doors.ts';
import { fillsInside, penReach, strokeContour } from './plan-walls.ts';
import type {
  Boundary,
  FloorPlan,
  Gap,
  PointCloud,
  Polygon,
  RegularisedBoundary,
  SecondaryResult,
  SourceFacts,
  Storey,
  Wall,
} from './types.ts';

/** Outlines that enclose less together are no room, m²: half of the smallest lavatory. */
const LEAST_ROOM = 0.5;
/** Height of walls where the scan shows none, m: a usual storey. */
const ASSUMED_WALL_HEIGHT = 2.5;

/** What the stages before have made. */
export interface PlanParts {
  readonly source: SourceFacts;
  readonly cloud: PointCloud;
  /** Indices of the points that are no outliers. */
  readonly kept: Uint32Array;
  readonly boundary: Boundary;
  readonly regularised: RegularisedBoundary;
  readonly secondary: SecondaryResult;
  /** Storeys with rooms, lowest first; where there are none the plan is one of outlines. */
  readonly building: readonly StoreyPlan[];
  readonly options: Options;
}

/**
 * The floor plan: of the rooms found, else the regularised boundaries with walls drawn along the primary ones
 * ([Stojanovic19] §3).
 *
 * `warnings` is left empty for the caller, who knows those of the whole run.
 */
export function makePlan(parts: PlanParts, context: Pick<StageContext, 'warn' | 'placeInSource'>): FloorPlan {
  const { source, cloud, building, options } = parts;
  const storeys =
    building.length > 0
      ? building.map((storey, index) => storeyOfRooms(storey, index, parts, context))
      : [storeyOfOutlines(parts, context)];
  const plan: FloorPlan = { version: 1, source, frame: cloud.frame, options, storeys, warnings: [] };
  return { ...plan, storeys: nameRooms(plan, context.warn) };
}

/** A storey of rooms, with the doors a person asked for in the lowest. */
function storeyOfRooms(
  found: StoreyPlan,
  index: number,
  { cloud, options }: PlanParts,
  context: Pick<StageContext, 'warn' | 'placeInSource'>,
): Storey {
  const storey = raiseStorey(found, index, options);
  if (index > 0) return storey;
  const { gaps, height } = storey;
  const site = { outlines: doorOutlines(storey), gaps, frame: cloud.frame, height, options };
  return { ...storey, openings: [...storey.openings, ...placeDoors(site, context)] };
}

/** One storey, from the lowest floor to the highest ceiling. */
function storeyOfOutlines(parts: PlanParts, context: Pick<StageContext, 'warn' | 'placeInSource'>): Storey {
  const { cloud, boundary, regularised, secondary, options } = parts;
  const { floor, height } = storeyHeights(parts, context);
  const gaps = boundary.gaps;
  const outlines = regularised.polygons.map((polygon) => ({
    polygon,
    confidence: supportedShare(polygon, gaps),
  }));
  warnOfFilled(regularised.polygons, options, context);
  warnOfNoRoom(regularised.polygons, cloud, context);
  return {
    index: 0,
    floor,
    height,
    primary: regularised.polygons,
    secondary: secondary.boundaries,
    walls: outlines.flatMap(({ polygon, confidence }) => wallsAlong(polygon, confidence, options)),
    rooms: [],
    openings: placeDoors({ outlines, gaps, frame: cloud.frame, height, options }, context),
    gaps,
  };
}

/** Height of the floor above the frame's origin and of the walls above the floor, m. */
function storeyHeights(
  { cloud, kept, options }: PlanParts,
  context: Pick<StageContext, 'warn'>,
): { readonly floor: number; readonly height: number } {
  const { floor, ceiling } = storeyRange(cloud, kept);
  if (options.wallHeight !== 'auto') return { floor, height: options.wallHeight };
  const hint = 'Set the wall height if you know it.';
  if (cloud.isFlat || ceiling <= floor) {
    context.warn({
      code: 'plan/height-assumed',
      message: `The scan shows no height; walls are taken to be ${ASSUMED_WALL_HEIGHT} m high.`,
      hint,
    });
    return { floor, height: ASSUMED_WALL_HEIGHT };
  }
  if (cloud.floor === null || cloud.ceiling === null) {
    const missing = [cloud.floor === null ? 'floor' : '', cloud.ceiling === null ? 'ceiling' : ''];
    context.warn({
      code: 'plan/height-assumed',
      message: `No ${missing.filter(Boolean).join(' and no ')} was found; the wall height, ${(ceiling - floor).toFixed(2)} m, is taken from the ${cloud.floor === null ? 'lowest' : 'highest'} point.`,
      hint,
    });
  }
  return { floor, height: ceiling - floor };
}

/** Walls along one primary polygon: one around it and one around each courtyard. */
function wallsAlong(polygon: Polygon, confidence: number, options: Options): Wall[] {
  const thickness = options.wallThickness;
  return strokeContour(polygon, penReach(options)).map((outline) => ({ outline, thickness, confidence }));
}

/** Says where walls leave no room between them. */
function warnOfFilled(
  polygons: readonly Polygon[],
  options: Options,
  { warn }: Pick<StageContext, 'warn'>,
): void {
  const filled = polygons.filter((polygon) => fillsInside(polygon, penReach(options))).length;
  if (filled === 0) return;
  const what = polygons.length === 1 ? 'the outline' : `${filled} of ${polygons.length} outlines`;
  warn({
    code: 'plan/walls-fill-room',
    message: `Walls ${options.wallThickness} m thick fill ${what}: no room is left between them.`,
    hint: 'Make wallThickness smaller, or wallSide outside.',
  });
}

/** Says where the outlines enclose no room: a machine was scanned, the level has no walls, or the unit is wrong. */
function warnOfNoRoom(
  polygons: readonly Polygon[],
  { positions, reasons }: PointCloud,
  { warn }: Pick<StageContext, 'warn'>,
): void {
  const area = areaOf(polygons);
  if (area >= LEAST_ROOM) return;
  const extent = largestExtent(trimmedBounds(positions));
  const isTiny = extent < EXTENT.least;
  warn({
    code: 'plan/no-room',
    message: `No room was found: the outline encloses ${area.toPrecision(1)} m², in a scan whose longest side is ${extent.toPrecision(2)} m. ${reasons.unit}`,
    hint: isTiny
      ? 'That is tiny for a building: set the unit, or metresPerUnit from one length you know.'
      : 'If walls show in the scan, set another level, by its heights too; of an object without walls around it no plan can be made.',
  });
}

/** Share of an outline's length that is no bridged gap. */
function supportedShare({ outer, holes }: Polygon, gaps: readonly Gap[]): number {
  const length = [outer, ...holes].reduce((sum, ring) => sum + perimeter(ring), 0);
  const bridged = gaps.reduce((sum, { width }) => sum + width, 0);
  return Math.max(0, 1 - bridged / length);
}
