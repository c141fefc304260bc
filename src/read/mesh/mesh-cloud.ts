import { countOf } from '../../core/count-words.ts';
import { FloorPlanError } from '../../core/errors.ts';
import type { Axis, Unit, Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud, PointChunk, ReadProgress } from '../cloud-reader.ts';
import type { Mesh } from './mesh.ts';
import { finestStep, type MeshSize, measureMesh, sampleMesh } from './sample-mesh.ts';

/** Points on a mesh whose unit is not known yet: enough to see floors and ceilings. */
const ROUGH_POINTS = 200_000;
/**
 * Points and rows of a sampling, half a minute of work: at cells of 8 mm 3,800 m² of surface with all their samples,
 * 15,000 m² with one a cell.
 */
const MOST_SAMPLES = 2.5e8;
/** Samples a point kept, at most: where the budget coarsens the cells, finer samples would all be thinned away again. */
const SAMPLES_PER_POINT = 64;
/** Samples farther apart than so many cells are of no building in its right unit: a coarse whole shows that as well. */
const LOST_SPACINGS = 4;
const COARSE_SAMPLES = 2e7;
/** Of a rough whole, whose rows outnumber its points by far where triangles are slivers: those of 10 M triangles fit. */
const ROUGH_SAMPLES = 5e6;
/** Samples a cell's edge: a surface that crosses a cell leaves a point in it. */
const SAMPLES_PER_SPACING = 2;
/** After so many chunks other work gets a turn, such as a request to cancel. */
const CHUNKS_A_TURN = 64;

/** How a mesh comes about. */
export interface MeshSource {
  readonly source: ByteSource;
  readonly unit?: Unit;
  /** By the format's own rule. */
  readonly up?: Axis;
  readonly warnings?: Warning[];
  /** Reads the whole mesh. @throws FloorPlanError input/… */
  load(progress: ReadProgress): Promise<Mesh>;
}

/** A mesh as a cloud of points sampled on its triangles; read once, sampled as often as asked. */
export function meshCloud({ source, unit, up, warnings = [], load }: MeshSource): OpenCloud {
  let loading: Promise<LoadedMesh> | undefined;
  return {
    isSlice: false,
    isAdaptive: true,
    ...(unit && { unit }),
    ...(up && { up }),
    warnings,
    async *chunks(progress, spacing, budget = Infinity) {
      const isFirst = loading === undefined;
      loading ??= load(progress).then((mesh) => loaded(source.name, mesh));
      yield* samplesOf(await loading, { source, warnings, progress, isFirst, spacing, budget });
    },
  };
}

interface LoadedMesh {
  readonly mesh: Mesh;
  readonly size: MeshSize;
}

interface Sampling {
  readonly source: ByteSource;
  readonly warnings: Warning[];
  readonly progress: ReadProgress;
  /** Whether the bytes were read for it. */
  readonly isFirst: boolean;
  /** 0: a rough whole. */
  readonly spacing: number;
  /** Points kept at most. */
  readonly budget: number;
}

async function* samplesOf({ mesh, size }: LoadedMesh, sampling: Sampling): AsyncGenerator<PointChunk> {
  const { source, progress, isFirst, spacing } = sampling;
  const step = stepOf(size, sampling);
  if (spacing > 0) sampling.warnings.splice(0, Infinity, ...warningsOf(sampling, size, step));
  let chunks = 0;
  let points = 0;
  for (const chunk of sampleMesh(mesh, { step, isEveryTriangleSeen: spacing > 0 })) {
    points += chunk.count;
    const share = isFirst ? 1 : Math.min(1, (points * step ** 2) / size.area);
    if (source.size !== undefined) progress(share * source.size);
    yield chunk;
    if (++chunks % CHUNKS_A_TURN === 0) await source.slice(0, 1);
  }
}

function stepOf(size: MeshSize, { spacing, budget }: Sampling): number {
  if (spacing === 0) return Math.max(Math.sqrt(size.area / ROUGH_POINTS), finestStep(size, ROUGH_SAMPLES));
  const isLost = finestStep(size, MOST_SAMPLES) > LOST_SPACINGS * spacing;
  const most = Math.min(isLost ? COARSE_SAMPLES : MOST_SAMPLES, SAMPLES_PER_POINT * budget);
  return Math.max(spacing / SAMPLES_PER_SPACING, finestStep(size, most));
}

function warningsOf({ warnings, spacing }: Sampling, size: MeshSize, step: number): Warning[] {
  const { misplaced } = size;
  const own = warnings.filter(({ code }) => !code.startsWith('read/mesh-'));
  if (misplaced > 0) {
    own.push({
      code: 'read/mesh-triangles-dropped',
      message: `${countOf(misplaced, 'triangle')} left out: a corner has no place.`,
      hint: 'If a wall is missing in the plan, export the model again.',
    });
  }
  if (finestStep(size, MOST_SAMPLES) > spacing) {
    own.push({
      code: 'read/mesh-coarsened',
      message: `The mesh is so large that it was sampled every ${step.toPrecision(2)} source units.`,
      hint: 'Check the unit, or cut away what is not the building.',
    });
  }
  return own;
}

/** @throws input/empty, input/degenerate */
function loaded(name: string, mesh: Mesh): LoadedMesh {
  const size = measureMesh(mesh);
  if (mesh.points.length > 0 || size.area > 0) return { mesh, size };
  const count = mesh.triangles.length / 3;
  if (count === 0) {
    throw new FloorPlanError('input/empty', `${name}: expected triangles or points, found none`, {
      hint: 'Export the model again, with its geometry.',
    });
  }
  throw new FloorPlanError(
    'input/degenerate',
    `${name}: expected triangles with an area, found ${count} without`,
    {
      hint: 'Export the model again; its vertices may have been flattened or lost.',
      detail: { triangles: count },
    },
  );
}
