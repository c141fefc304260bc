import { CellTable } from '../cell-table.ts';
import { largestExtent, trimmedBounds } from '../cloud-bounds.ts';
import { medianOf } from '../robust-scale.ts';
import type { Vec3 } from '../types.ts';
import { FEWEST_POINTS, type FittedCells, fitCells, type SampledPoints } from './fit-cells.ts';

/**
 * More points than this are sampled by stride: the scan is sorted by lattice cell, so a stride thins evenly.
 */
const POINTS_LOOKED_AT = 1_000_000;
/** Enough for a covariance to show a plane under noise. */
const POINTS_A_PATCH = 32;
/** Cells a cloud's longest side is cut into: first look, fewest and most. */
const FIRST_DIVISION = 32;
const DIVISION = { fewest: 10, most: 256 };
/** A cell that is no plane is looked at in halves along each axis … */
const OCTANTS = 8;
/** … for two layers: so many of its octants are planes at least, half of them in each … */
const FEWEST_IN_LAYERS = 4;
/** … whose normals differ by no more than this. */
const SAME_WAY = Math.cos((20 * Math.PI) / 180);

/**
 * A cloud seen as small surfaces of equal size, whatever the density of points: one a voxel, or two where a voxel holds
 * both faces of a slab.
 */
export interface SurfacePatches {
  readonly count: number;
  /** Edge of the voxels, source units; a patch stands for size² of surface. */
  readonly size: number;
  /** x, y, z a patch. */
  readonly centroids: Float64Array;
  /** Unit normal of unknown sign; zero where the voxel holds no plane. */
  readonly normals: Float64Array;
  /** Median thickness of the planar patches, one standard deviation: the scan's noise, source units. */
  readonly noise: number;
  /** Every stride-th point was looked at. */
  readonly stride: number;
}

/**
 * Fits a plane to the points of every voxel.
 *
 * Patches count by area, so a densely scanned wall weighs no more than a sparse one, and keep their normals,
 * so floors are told from walls even when the whole scan is tilted. Stray points fall into voxels of few
 * points and drop out. A slab or a thin wall seen from both sides makes two patches in one voxel. O(n), at most a million
 * points are looked at.
 *
 * @param positions x, y, z a point, source units; not all equal
 */
export function surfacePatches(positions: Float32Array): SurfacePatches {
  const points = positions.length / 3;
  const stride = Math.ceil(points / POINTS_LOOKED_AT);
  const sampled = Math.ceil(points / stride);
  const bounds = trimmedBounds(positions);
  const extent = largestExtent(bounds) || 1;
  const first = new CellTable(sampled / POINTS_A_PATCH);
  const at = { positions, stride, sampled, origin: bounds.min };
  numberCells(at, extent / FIRST_DIVISION, first);
  const ideal = (extent / FIRST_DIVISION) * Math.sqrt((POINTS_A_PATCH * first.count) / sampled);
  const size = Math.min(extent / DIVISION.fewest, Math.max(extent / DIVISION.most, ideal));
  const table = new CellTable(sampled / POINTS_A_PATCH);
  const cellOf = numberCells(at, size, table);
  return { ...fitPatches(at, size, cellOf, table.count), stride };
}

type FittedPatches = Omit<SurfacePatches, 'stride'>;

function numberCells({ positions, stride, sampled, origin }: SampledPoints, size: number, table: CellTable) {
  const cellOf = new Int32Array(sampled);
  const [x0, y0, z0] = origin;
  for (let i = 0; i < sampled; i++) {
    const p = 3 * i * stride;
    cellOf[i] = table.add(
      Math.floor((positions[p] - x0) / size),
      Math.floor((positions[p + 1] - y0) / size),
      Math.floor((positions[p + 2] - z0) / size),
    );
  }
  return cellOf;
}

function fitPatches(at: SampledPoints, size: number, cellOf: Int32Array, cells: number): FittedPatches {
  const whole = fitCells(at, cellOf, cells);
  const unclear = numberUnclear(whole);
  const octants = fitCells(
    at,
    octantsOf(at, size, cellOf, unclear),
    OCTANTS * unclear.filter((number) => number >= 0).length,
  );
  const [centroids, normals, thicknesses]: number[][] = [[], [], []];
  const add = ({ centroid, normal }: Patch) => {
    centroids.push(...centroid);
    normals.push(...normal);
  };
  for (let cell = 0; cell < cells; cell++) {
    if (whole.counts[cell] < FEWEST_POINTS) continue;
    if (unclear[cell] < 0) thicknesses.push(whole.thickness[cell]);
    const layers = unclear[cell] < 0 ? [] : layersIn(octants, OCTANTS * unclear[cell]);
    for (const patch of layers.length > 0 ? layers : [patchOf(whole, cell)]) add(patch);
  }
  return {
    count: centroids.length / 3,
    size,
    centroids: Float64Array.from(centroids),
    normals: Float64Array.from(normals),
    noise: thicknesses.length > 0 ? medianOf(Float64Array.from(thicknesses)) : 0,
  };
}

interface Patch {
  readonly centroid: Vec3;
  /** Zero for what is no plane. */
  readonly normal: Vec3;
}

/** Numbers the cells that are no plane; −1 for the others. */
function numberUnclear({ isPlane }: FittedCells): Int32Array {
  let count = 0;
  return Int32Array.from(isPlane, (plane) => (plane === 1 ? -1 : count++));
}

/** The octant of each point in an unclear cell; −1 for the others. */
function octantsOf(at: SampledPoints, size: number, cellOf: Int32Array, unclear: Int32Array): Int32Array {
  const { positions, stride, origin } = at;
  const half = 2 / size;
  return cellOf.map((cell, i) => {
    if (unclear[cell] < 0) return -1;
    const p = 3 * i * stride;
    let octant = OCTANTS * unclear[cell];
    for (let k = 0; k < 3; k++) octant += (Math.floor((positions[p + k] - origin[k]) * half) & 1) << k;
    return octant;
  });
}

/**
 * The two faces of a slab or a thin wall in one cell: octants that are planes and face the same way, in two layers. None
 * where they are no such pair, so that edges and clutter stay no planes.
 */
function layersIn(octants: FittedCells, first: number): Patch[] {
  const planes: number[] = [];
  for (let k = first; k < first + OCTANTS; k++) if (octants.isPlane[k] === 1) planes.push(k);
  if (planes.length < FEWEST_IN_LAYERS) return [];
  const { normal } = patchOf(octants, planes[0]);
  const across = (k: number) => dot(patchOf(octants, k).centroid, normal);
  if (planes.some((k) => Math.abs(dot(patchOf(octants, k).normal, normal)) < SAME_WAY)) return [];
  const [low, high] = [Math.min(...planes.map(across)), Math.max(...planes.map(across))];
  const isLow = (k: number) => across(k) < (low + high) / 2;
  const layers = [planes.filter(isLow), planes.filter((k) => !isLow(k))];
  if (layers.some((layer) => layer.length < FEWEST_IN_LAYERS / 2)) return [];
  return layers.map((layer) => ({
    normal,
    centroid: meanOf(layer.map((k) => patchOf(octants, k).centroid)),
  }));
}

function patchOf({ centroids, normals }: FittedCells, cell: number): Patch {
  const at = (values: Float64Array): Vec3 => [values[3 * cell], values[3 * cell + 1], values[3 * cell + 2]];
  return { centroid: at(centroids), normal: at(normals) };
}

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function meanOf(places: readonly Vec3[]): Vec3 {
  const mean = (k: number) => places.reduce((sum, place) => sum + place[k], 0) / places.length;
  return [mean(0), mean(1), mean(2)];
}
