import { ARCHIVES, READ_FORMATS } from '../../src/read/formats.ts';
import { GZIP_SEEDS, ZIP_SEEDS } from './archive-seeds.ts';
import { COPC_SEEDS, E57_SEEDS, LAS_SEEDS, LAZ_SEEDS } from './binary-seeds.ts';
import { GLB_SEEDS } from './model-seeds.ts';
import type { Seed } from './seed.ts';
import { CSV_SEEDS, OBJ_SEEDS, PCD_SEEDS, PLY_SEEDS, PTS_SEEDS, PTX_SEEDS } from './text-seeds.ts';

/** What is fuzzed: every format that is read, and what may be around it. */
export type FuzzFormat = keyof typeof READ_FORMATS | keyof typeof ARCHIVES;

/** Valid files of every format. */
export const SEEDS: Readonly<Record<FuzzFormat, readonly Seed[]>> = {
  ply: PLY_SEEDS,
  las: LAS_SEEDS,
  copc: COPC_SEEDS,
  laz: LAZ_SEEDS,
  e57: E57_SEEDS,
  ptx: PTX_SEEDS,
  pts: PTS_SEEDS,
  pcd: PCD_SEEDS,
  glb: GLB_SEEDS,
  obj: OBJ_SEEDS,
  csv: CSV_SEEDS,
  gzip: GZIP_SEEDS,
  zip: ZIP_SEEDS,
};

export const FUZZ_FORMATS = Object.keys({ ...READ_FORMATS, ...ARCHIVES }) as readonly FuzzFormat[];
