import { findBoundary } from './boundary.ts';
import { findBuilding } from './building/find-building.ts';
import { countOf } from './count-words.ts';
import { cropCloud } from './crop.ts';
import { orient } from './frame.ts';
import { vertexCount } from './geometry/rings.ts';
import { chooseLevel } from './level.ts';
import { removeOutliers } from './outliers.ts';
import type { Options } from './params.ts';
import type { PipelineRun } from './pipeline-run.ts';
import { makePlan } from './plan.ts';
import { regulariseBoundary } from './regularise.ts';
import { findSecondary } from './secondary.ts';
import { makeSlice } from './slice.ts';
import { sayCoordinates, sayScale, sayUnit } from './source-coordinates.ts';
import { OUTLINE_STAGES } from './stages.ts';
import type { FloorPlan, Scan } from './types.ts';
import { findWallPoints } from './wall-columns.ts';

/** Places told to a person, m: a centimetre finds any gap. */
const TOLD_PRECISION = 0.01;

/**
 * The paper's chain from a scan to its floor plan ([Stojanovic19] §3–3.1), every stage cached; `run.results` has what
 * each of them made.
 *
 * @throws option/…, input/degenerate, input/too-few-points, result/…, cancelled
 */
export async function planScan(scan: Scan, options: Options, run: PipelineRun): Promise<FloorPlan> {
  const { cloud, kept, slice } = await sliceScan(scan, options, run);
  const placeInSource = (x: number, y: number) =>
    `(${sayCoordinates(cloud.frame, [x, y], TOLD_PRECISION)}) ${sayUnit(cloud.frame.unit)}`;
  const boundary = await run.stage(
    'boundary',
    options,
    (context) => findBoundary(slice, options, { ...context, placeInSource }),
    ({ polygons }) => countOf(vertexCount(polygons), 'vertex', 'vertices'),
  );
  const regularised = await run.stage(
    'regularise',
    options,
    (context) => regulariseBoundary(boundary, slice, options, context),
    ({ polygons }) => countOf(vertexCount(polygons), 'vertex', 'vertices'),
  );
  const secondary = await run.stage(
    'secondary',
    options,
    (context) => findSecondary(slice, regularised, options, context),
    ({ boundaries }) =>
      options.secondaryCount === 'auto'
        ? `${boundaries.length} proposed`
        : countOf(boundaries.length, 'structure'),
  );
  const building = await run.stage(
    'rooms',
    options,
    (context) => findBuilding(cloud, kept, options, context),
    (storeys) =>
      countOf(
        storeys.reduce((sum, { rooms }) => sum + rooms.length, 0),
        'room',
      ),
  );
  if (building.length > 0) run.dropWarnings(OUTLINE_STAGES);
  return run.stage(
    'plan',
    options,
    (context) => {
      const parts = { source: scan.facts, cloud, kept, boundary, regularised, secondary, building, options };
      return { ...makePlan(parts, { ...context, placeInSource }), warnings: run.warnings };
    },
    ({ storeys }) => countOf(storeys.length, 'storey'),
  );
}

/** The stages up to the points that outlines are made from. */
async function sliceScan(scan: Scan, options: Options, run: PipelineRun) {
  const whole = await run.stage(
    'frame',
    options,
    (context) => orient(scan, options, context),
    ({ frame }) => `${frame.up} up, ${sayScale(frame.unit, frame.metresPerUnit)}`,
  );
  const cloud = await run.stage(
    'crop',
    options,
    () => cropCloud(whole, options),
    ({ positions }) => (options.crop === 'none' ? 'no box' : countOf(positions.length / 3, 'point')),
  );
  const total = cloud.positions.length / 3;
  const kept = await run.stage(
    'outliers',
    options,
    (context) => removeOutliers(cloud, options, context),
    (indices) => countOf(total - indices.length, 'outlier'),
  );
  const level = await run.stage(
    'level',
    options,
    (context) => chooseLevel(cloud, kept, options, context),
    // A ready slice has no heights.
    ({ band: [low, high] }) => (low < high ? `${low.toFixed(2)} to ${high.toFixed(2)} m` : 'as it came'),
  );
  const slice = await run.stage(
    'slice',
    options,
    (context) => {
      const walls = findWallPoints(cloud, kept, level, options, context);
      return makeSlice(cloud, walls.indices, walls.band, options);
    },
    ({ xy }) => countOf(xy.length / 2, 'point'),
  );
  return { cloud, kept, slice };
}
