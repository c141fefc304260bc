import { expect, test } from 'vitest';
import { PAPER_SLICES, type PaperSliceName, paperSlice } from '../../../fixtures/simulator/slices.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { areaOf, combine } from '../../../src/core/geometry/areas.ts';
import type { Options } from '../../../src/core/params.ts';
import type { Storey } from '../../../src/core/types.ts';
import { blobSource } from '../../../src/read/bytes/blob-source.ts';
import type { RunResult } from '../../../src/session/result.ts';
import { Session } from '../../../src/session/session.ts';
import { checkSolid } from '../../../src/solid/check-solid.ts';
import { carve, footprint, wallSection } from '../../../src/solid/sections.ts';

/** Most triangles a set may take, floor included; the paper's own: 45,702 and 15,034. */
const MOST: Partial<Record<PaperSliceName, number>> = { 'hallway-1': 800, 'room-2': 600 };

async function run(name: PaperSliceName, csg: Options['csg']): Promise<RunResult> {
  const { xy, secondary } = paperSlice(name);
  const rows = Array.from({ length: xy.length / 2 }, (_, i) => `${xy[2 * i]},${xy[2 * i + 1]}`);
  const source = blobSource(new Blob([`x,y\n${rows.join('\n')}\n`]), `${name}.csv`);
  const session = new Session({ strokeTest: createStrokeTest() });
  return session.load(source, { preset: 'paper', csg, secondaryCount: secondary.length });
}

/** Areas × heights of walls, floor and structures that stand alone. */
function volumeOf(storey: Storey, { slabThickness }: Options): number {
  const { secondary, height } = storey;
  const alone = secondary.filter(({ operation }) => operation === 'independent');
  const pillars = alone.flatMap(({ outline }) => combine('union', [outline]));
  const floor = carve(footprint(storey), secondary);
  return (areaOf(wallSection(storey)) + areaOf(pillars)) * height + areaOf(floor) * slabThickness;
}

test.each(Object.keys(PAPER_SLICES) as PaperSliceName[])(
  '%s: few triangles, the right volume',
  async (name) => {
    const { plan, options, solid } = await run(name, 'slabs');
    const check = checkSolid(solid);
    expect(check.watertight).toBe(true);
    expect(Math.abs(check.volume / volumeOf(plan.storeys[0], options) - 1)).toBeLessThan(1e-9);
    expect(solid.indices.length / 3).toBeLessThanOrEqual(MOST[name] ?? Infinity);

    const bsp = checkSolid((await run(name, 'bsp')).solid);
    expect(bsp.watertight).toBe(true);
    expect(Math.abs(bsp.volume / check.volume - 1)).toBeLessThan(1e-6);
  },
);
