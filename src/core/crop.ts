import { cloudBounds } from './cloud-bounds.ts';
import { type CropBox, formatCrop, parseCrop } from './crop-box.ts';
import { FloorPlanError } from './errors.ts';
import { checkSpread, FEWEST_POINTS } from './frame/check-spread.ts';
import { findHeightPlanes } from './frame/height-planes.ts';
import { FLOOR_COSINE, refinedPlanes } from './frame/refined-planes.ts';
import { surfacePatches } from './frame/surface-patches.ts';
import type { Options } from './params.ts';
import { planPlace, sayUnit } from './source-coordinates.ts';
import type { Frame, PointAttributes, PointCloud } from './types.ts';

const HINT = 'Draw the box over the scan; none takes it away.';

/**
 * The points of a cloud in the box that `crop` says, its faces included. Ours.
 *
 * What is left is a cloud of its own: floor and ceiling are found again, since a box around one storey has others. O(n).
 *
 * @throws input/too-few-points, input/degenerate where the box leaves no area
 */
export function cropCloud(cloud: PointCloud, options: Pick<Options, 'crop'>): PointCloud {
  const box = parseCrop(options.crop);
  if (box === null) return cloud;
  const kept = indicesWithin(cloud, box);
  if (kept.length < FEWEST_POINTS) throw tooFew(box, cloud.frame, kept.length);
  if (kept.length === cloud.positions.length / 3) return cloud;
  const positions = rowsOf(cloud.positions, kept, 3);
  checkSpread(positions, HINT);
  const { min, max } = cloudBounds(positions);
  const isFlat = min[2] === max[2];
  return {
    ...cloud,
    positions,
    attributes: attributesOf(cloud.attributes, kept),
    ...(isFlat ? { floor: null, ceiling: null } : planesOf(positions)),
    isFlat,
  };
}

/** Whether a point of the plan frame, m, lies in a box, its faces included. */
export function isWithin(frame: Frame, box: CropBox): (x: number, y: number, z: number) => boolean {
  const [minX, minY] = planPlace(frame, box.x0, box.y0);
  const [maxX, maxY] = planPlace(frame, box.x1, box.y1);
  const [minZ, maxZ] = (box.heights ?? [-Infinity, Infinity]).map(
    (height) => (height - frame.planOrigin[2]) * frame.metresPerUnit,
  );
  const isSquare = (x: number, y: number, z: number) =>
    x >= minX && x <= maxX && y >= minY && y <= maxY && z >= minZ && z <= maxZ;
  if (box.heading === 0) return isSquare;
  const [midX, midY] = [(minX + maxX) / 2, (minY + maxY) / 2];
  const heading = (box.heading * Math.PI) / 180;
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  return (x, y, z) => {
    const [dx, dy] = [x - midX, y - midY];
    return isSquare(midX + cos * dx + sin * dy, midY + cos * dy - sin * dx, z);
  };
}

/** Indices, rising. */
function indicesWithin({ positions, frame }: PointCloud, box: CropBox): Uint32Array {
  const isIn = isWithin(frame, box);
  const indices = new Uint32Array(positions.length / 3);
  let count = 0;
  for (let i = 0; i < positions.length; i += 3) {
    if (isIn(positions[i], positions[i + 1], positions[i + 2])) indices[count++] = i / 3;
  }
  return indices.slice(0, count);
}

function planesOf(positions: Float32Array): Pick<PointCloud, 'floor' | 'ceiling'> {
  const patches = surfacePatches(positions);
  const planes = findHeightPlanes(patches, [0, 0, 1], FLOOR_COSINE);
  return refinedPlanes(positions, planes, patches, { scale: 1, lift: 0 });
}

function attributesOf(attributes: PointAttributes, indices: Uint32Array): PointAttributes {
  const { colour, intensity, classification, station } = attributes;
  return {
    ...(colour && { colour: rowsOf(colour, indices, 3) }),
    ...(intensity && { intensity: rowsOf(intensity, indices, 1) }),
    ...(classification && { classification: rowsOf(classification, indices, 1) }),
    ...(station && { station: rowsOf(station, indices, 1) }),
  };
}

/** Rows of `width` entries each. */
function rowsOf<T extends Float32Array | Uint8Array | Uint16Array>(
  rows: T,
  indices: Uint32Array,
  width: 1 | 3,
): T {
  const chosen = new (rows.constructor as new (length: number) => T)(width * indices.length);
  for (let i = 0; i < indices.length; i++) {
    for (let k = 0; k < width; k++) chosen[width * i + k] = rows[width * indices[i] + k];
  }
  return chosen;
}

function tooFew(box: CropBox, frame: Frame, found: number): FloorPlanError {
  const unit = sayUnit(frame.unit);
  return new FloorPlanError(
    'input/too-few-points',
    `crop: expected at least ${FEWEST_POINTS} points in the box ${formatCrop(box)} ${unit}, found ${found}`,
    { hint: HINT, detail: { option: 'crop', points: found } },
  );
}
