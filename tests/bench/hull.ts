import { signedArea } from '../../src/core/geometry/rings.ts';
import { intersectionOverUnion } from '../unit/core/boundary/measures.ts';
import { type HullMethod, type HullRun, hullMethods, runHull } from './hull-methods.ts';
import type { Figure } from './run.ts';
import { wallOutline, wallSliceFile } from './wall-slice.ts';

const SIZES = [1_800, 20_000, 200_000, 2_000_000, 10_000_000];
/** A method that needs longer is stopped, and spared larger sizes. */
const LIMIT_S = Number(process.env.HULL_LIMIT ?? 60);

const truth = Float64Array.from(wallOutline.flat());

/**
 * From the points of a noisy wall slice to its outline, ours beside its peers: ours with all that the chain does, sampling
 * and spacing included; theirs by the algorithm alone. Each in a process of its own, one after another.
 */
export async function benchHull(): Promise<readonly Figure[]> {
  const figures: Figure[] = [];
  const present = await presentMethods();
  const stopped = new Set<HullMethod>();
  for (const size of SIZES) {
    const path = await wallSliceFile(size);
    let edgeLength = 0;
    for (const method of present) {
      const result = stopped.has(method) ? null : await runHull(method, path, edgeLength, LIMIT_S * 1000);
      edgeLength = result?.openingLength || edgeLength;
      const name = `${method.name} ${size.toLocaleString('en-GB')}`;
      if (result === null) {
        stopped.add(method);
        figures.push({ name, value: LIMIT_S, unit: 's', isLeast: true });
      } else figures.push({ name, value: result.ms, unit: 'ms', note: wording(result) });
    }
  }
  return figures;
}

async function presentMethods(): Promise<readonly HullMethod[]> {
  const present: HullMethod[] = [];
  for (const method of hullMethods) {
    try {
      await method.prepare?.();
      present.push(method);
    } catch {
      console.log(`  ${method.name}: not on this machine (${method.remedy})`);
    }
  }
  return present;
}

function wording({ ring: values, peakMB, firstMs }: HullRun): string {
  const ring = Float64Array.from(values);
  const iou = intersectionOverUnion(ring, truth);
  const error = 100 * (Math.abs(signedArea(ring)) / signedArea(truth) - 1);
  const sign = error < 0 ? '−' : '+';
  return `IoU ${iou.toFixed(4)}, area ${sign}${Math.abs(error).toFixed(2)} %, peak ${peakMB.toFixed(0)} MB, first run ${firstMs.toFixed(0)} ms`;
}
