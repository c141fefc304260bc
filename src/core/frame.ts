import { cloudBounds, largestExtent, trimmedBounds } from './cloud-bounds.ts';
import type { StageContext } from './context.ts';
import { checkSpread } from './frame/check-spread.ts';
import { fitTilt, MOST_TILT } from './frame/fit-tilt.ts';
import { findGravity, type Gravity } from './frame/gravity.ts';
import { findHeightPlanes } from './frame/height-planes.ts';
import { type JudgedUnit, judgeSliceUnit, judgeUnitFrom, statedUnit } from './frame/judge-unit.ts';
import { FLOOR_COSINE, refinedPlanes } from './frame/refined-planes.ts';
import {
  axisVector,
  multiply,
  type Rotation,
  rotate,
  rotationToZ,
  uprightRotation,
} from './frame/rotation.ts';
import { type SurfacePatches, surfacePatches } from './frame/surface-patches.ts';
import type { Options } from './params.ts';
import type { Axis, Frame, PointCloud, Scan, Vec3 } from './types.ts';

/**
 * Trimmed bounds grown by this share hold a centroid's points: all of a clean cloud, no far stray of another.
 */
const CENTROID_MARGIN = 0.5;

/**
 * Turns a cloud upright and into metres: judges its unit, finds up, levels a tilt of up to 15°, finds floor
 * and ceiling.
 *
 * [Stojanovic19] §3 does this by hand. The plan frame is right-handed and seen from above; a scan that stands
 * level keeps its coordinates to the last bit. Levelling is the smallest rotation about the centroid of the
 * points. O(n).
 *
 * @param scan source axes and units
 * @throws input/too-few-points, input/degenerate
 */
export function orient(scan: Scan, options: Options, context: StageContext): PointCloud {
  checkSpread(scan.positions);
  if (scan.isSlice) return orientSlice(scan, options, context);
  const flatUp = findFlatAxis(scan, options);
  if (flatUp) return orientFlat(scan, flatUp, options, context);
  const patches = surfacePatches(scan.positions);
  context.progress(0.4);
  const gravity = findGravity(scan.positions, patches, options.up, scan.up);
  warnOfDoubt(gravity, context);
  const known = statedUnit(scan, options);
  const unit = known ?? judgeUnitFrom(gravity.planes.strong, largestExtent(trimmedBounds(scan.positions)));
  warnOfGuess(unit, context);
  const tilted = options.levelling ? findTilt(patches, gravity, context) : null;
  context.progress(0.6);
  return uprightCloud({ scan, patches, gravity, unit, tilted });
}

interface Upright {
  readonly scan: Scan;
  readonly patches: SurfacePatches;
  readonly gravity: Gravity;
  readonly unit: JudgedUnit;
  /** True up in plan axes; null for a level scan. */
  readonly tilted: Vec3 | null;
}

function uprightCloud({ scan, patches, gravity, unit, tilted }: Upright): PointCloud {
  const upright = uprightRotation(gravity.up);
  const rotation = tilted ? multiply(rotationToZ(tilted), upright) : upright;
  const origin = tilted ? centroidOf(scan) : scan.origin;
  const frame = makeFrame(scan, {
    up: gravity.up,
    unit,
    origin,
    rotation,
    tilt: tilted ? angleOf(tilted) : 0,
  });
  const up: Vec3 = [rotation[6], rotation[7], rotation[8]];
  const planes = findHeightPlanes(patches, up, FLOOR_COSINE);
  const lift = up.reduce((sum, u, k) => sum + u * (scan.origin[k] - origin[k]), 0);
  const positions = toPlan(scan, frame);
  return {
    frame,
    positions,
    attributes: scan.attributes,
    stations: stationsInPlan(scan, frame),
    ...refinedPlanes(positions, planes, patches, {
      scale: unit.metresPerUnit,
      lift: unit.metresPerUnit * lift,
    }),
    reasons: { unit: unit.reason, up: gravity.reason },
    isFlat: false,
  };
}

/** A ready slice lies in the plan frame already. */
function orientSlice(scan: Scan, options: Options, context: StageContext): PointCloud {
  const unit = statedUnit(scan, options) ?? judgeSliceUnit(scan, options);
  warnOfGuess(unit, context);
  const reason = 'A ready slice lies in the plan frame; z is up.';
  return levelCloud(scan, 'z', unit, reason);
}

function orientFlat(scan: Scan, up: Axis, options: Options, context: StageContext): PointCloud {
  context.warn({
    code: 'frame/flat-cloud',
    message: `All points have the same height along ${up}: the cloud is taken as a slice.`,
    hint: 'If it should have heights, export it again with all three coordinates.',
  });
  const known = statedUnit(scan, options);
  const unit = known ?? judgeUnitFrom([], largestExtent(trimmedBounds(scan.positions)));
  warnOfGuess(unit, context);
  return levelCloud(scan, up, unit, `${up} is up: all points have the same height along it.`);
}

/** A cloud without thickness: nothing to level, no floor, no ceiling. */
function levelCloud(scan: Scan, up: Axis, unit: JudgedUnit, reason: string): PointCloud {
  const frame = makeFrame(scan, { up, unit, origin: scan.origin, rotation: uprightRotation(up), tilt: 0 });
  return {
    frame,
    positions: toPlan(scan, frame),
    attributes: scan.attributes,
    stations: stationsInPlan(scan, frame),
    floor: null,
    ceiling: null,
    reasons: { unit: unit.reason, up: reason },
    isFlat: true,
  };
}

/** The axis along which all points are equal, of those the person allows. */
function findFlatAxis({ positions }: Scan, { up }: Options): Axis | null {
  const { min, max } = cloudBounds(positions);
  const allowed: readonly Axis[] = up === 'auto' ? ['z', 'y', 'x'] : [up];
  return allowed.find((axis) => axisVector(axis).every((u, k) => u === 0 || max[k] === min[k])) ?? null;
}

function findTilt(
  patches: SurfacePatches,
  { up, normal, planes }: Gravity,
  context: StageContext,
): Vec3 | null {
  const levels = [planes.floor, planes.ceiling].filter((plane) => plane !== null);
  const tilted = fitTilt(patches, uprightRotation(up), normal, levels);
  if (!tilted) return null;
  const angleDeg = (angleOf(tilted) * 180) / Math.PI;
  if (angleOf(tilted) > MOST_TILT) {
    context.warn({
      code: 'frame/tilt-too-large',
      message: `The floor is tilted by ${angleDeg.toFixed(1)}°; only tilts up to 15° are levelled.`,
      hint: 'Turn the scan upright before loading it.',
    });
    return null;
  }
  context.warn({
    code: 'frame/levelled',
    message: `The scan was tilted by ${angleDeg.toFixed(1)}° and has been levelled by its ${planes.floor ? 'floor' : 'ceiling'}.`,
    hint: 'Switch levelling off to keep its own axes.',
  });
  return tilted;
}

function warnOfDoubt({ up, reason, doubt }: Gravity, context: StageContext): void {
  if (!doubt) return;
  const opposite = up.startsWith('-') ? up.slice(1) : `-${up}`;
  const hints = {
    axis: 'If the plan shows a side view, set the up axis.',
    end: `If the plan is mirrored, the scan lies upside down: set the up axis to ${opposite}.`,
  };
  context.warn({ code: 'frame/up-guessed', message: reason, hint: hints[doubt] });
}

function warnOfGuess(unit: JudgedUnit, context: StageContext): void {
  if (!unit.isGuess) return;
  context.warn({
    code: 'frame/unit-guessed',
    message: unit.reason,
    hint: 'If sizes look wrong, set the unit, or metresPerUnit from one length you know.',
  });
}

interface FrameParts {
  readonly up: Axis;
  readonly unit: JudgedUnit;
  readonly origin: Vec3;
  readonly rotation: Rotation;
  readonly tilt: number;
}

function makeFrame({ crs }: Scan, { up, unit, origin, rotation, tilt }: FrameParts): Frame {
  return {
    origin,
    planOrigin: rotate(uprightRotation(up), origin),
    rotation,
    metresPerUnit: unit.metresPerUnit,
    unit: unit.unit,
    up,
    tilt,
    ...(crs === undefined ? {} : { crs }),
  };
}

function toPlan({ positions, origin }: Scan, frame: Frame): Float32Array {
  const r = frame.rotation.map((entry) => entry * frame.metresPerUnit);
  const [dx, dy, dz] = origin.map((o, k) => o - frame.origin[k]);
  const plan = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    const x = positions[i] + dx;
    const y = positions[i + 1] + dy;
    const z = positions[i + 2] + dz;
    plan[i] = r[0] * x + r[1] * y + r[2] * z;
    plan[i + 1] = r[3] * x + r[4] * y + r[5] * z;
    plan[i + 2] = r[6] * x + r[7] * y + r[8] * z;
  }
  return plan;
}

function stationsInPlan({ stations }: Scan, { origin, rotation, metresPerUnit: scale }: Frame): Vec3[] {
  return stations.map((station) => {
    const [x, y, z] = station.map((value, k) => scale * (value - origin[k]));
    return rotate(rotation, [x, y, z]);
  });
}

/** Mean of the points, source coordinates. */
function centroidOf({ positions, origin }: Scan): Vec3 {
  const { min, max } = trimmedBounds(positions);
  const low = min.map((value, k) => value - CENTROID_MARGIN * (max[k] - value));
  const high = max.map((value, k) => value + CENTROID_MARGIN * (value - min[k]));
  const sum = [0, 0, 0];
  let count = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
    if (x < low[0] || y < low[1] || z < low[2] || x > high[0] || y > high[1] || z > high[2]) continue;
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
    count++;
  }
  return [origin[0] + sum[0] / count, origin[1] + sum[1] / count, origin[2] + sum[2] / count];
}

/** Angle between a unit vector and (0, 0, 1). */
function angleOf([x, y, z]: Vec3): number {
  return Math.atan2(Math.hypot(x, y), z);
}
