import type { Vec3, Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud } from '../cloud-reader.ts';
import { readPtxPoints } from './ptx-points.ts';

/** Scans follow one another, so stations are found on the way. */
export async function openPtx(source: ByteSource): Promise<OpenCloud> {
  const stations: Vec3[] = [];
  const warnings: Warning[] = [];
  return {
    isSlice: false,
    stations,
    chunks: (progress) => readPtxPoints(source, { stations, warnings }, progress),
    warnings,
  };
}
