import { signedArea } from '../../src/core/geometry/rings.ts';
import { intersectionOverUnion } from '../unit/core/boundary/measures.ts';
import { type HullMethod, type HullRun, hullMethods, runHull } from './hull-methods.ts';
import type { Figure } from './table.ts';
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
    const of = size.toLocaleString('en-GB');
    let edgeLength = 0;
    for (const method of present) {
      const result = stopped.has(method) ? null : await runHull(method, path, edgeLength, LIMIT_S * 1000);
      edgeLength = result?.openingLength || edgeLength;
      if (result === null) stopped.add(method);
      figures.push(...figuresOf(method, of, result));
    }
  }
  return figures;
}

/** Of a method that was stopped only the time is known, and that it is longer. */
function figuresOf({ name, note }: HullMethod, of: string, result: HullRun | null): Figure[] {
  const best = 'ms, best of its runs';
  if (result === null) return [{ name, of, value: 1000 * LIMIT_S, unit: best, isLeast: true }];
  const ring = Float64Array.from(result.ring);
  const area = Math.abs(signedArea(ring)) / signedArea(truth);
  return [
    { name, of, value: result.ms, unit: best },
    ...(result.cpuMs === undefined
      ? []
      : [{ name, of, value: result.cpuMs, unit: 'ms of the processor, least' }]),
    { name, of, value: result.firstMs, unit: 'ms, first run of a process' },
    {
      name,
      of,
      value: intersectionOverUnion(ring, truth),
      unit: 'IoU with the true outline',
      ...(note ? { note } : {}),
    },
    { name, of, value: 100 * (area - 1), unit: 'error of the area, %' },
    { name, of, value: result.peakMB, unit: 'peak memory of the process, MB' },
  ];
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
