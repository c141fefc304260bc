import { existsSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { orient } from '../../../src/core/frame.ts';
import { chooseLevel } from '../../../src/core/level.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { removeOutliers } from '../../../src/core/outliers.ts';
import { blobSource } from '../../../src/read/bytes/blob-source.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { SCENES } from '../../scenes.ts';
import { listen } from './made-scan.ts';

const NAMES = ['home_utm', 'home_yup', 'home_mobile'];

interface Truth {
  readonly up: string;
  readonly floor: number;
  readonly height: number;
}

describe.skipIf(!existsSync(SCENES))(`scenes of ${SCENES} (skipped when absent)`, () => {
  test.each(NAMES)('%s: up, floor, height, strays', async (name) => {
    const truth: Truth = JSON.parse(readFileSync(`${SCENES}/${name}.gt.json`, 'utf8'));
    const source = blobSource(new Blob([readFileSync(`${SCENES}/${name}.ply`)]), `${name}.ply`);
    const options = resolveOptions({});
    const { context, warnings } = listen();
    const cloud = orient(await readScan(source, options), options, context);
    expect(warnings).toEqual([]);
    expect(cloud.frame.up).toBe(truth.up);
    expect(cloud.frame.unit).toBe('m');
    const floor = cloud.frame.planOrigin[2] + cloud.floor!;
    expect(Math.abs(floor - truth.floor)).toBeLessThan(0.005);
    expect(Math.abs(cloud.ceiling! - cloud.floor! - truth.height)).toBeLessThan(0.01);
    const kept = removeOutliers(cloud, options, context);
    for (const i of kept) {
      const height = cloud.positions[3 * i + 2] - cloud.floor!;
      expect(height > -0.2 && height < truth.height + 0.2).toBe(true);
    }
    const { levels, chosen } = chooseLevel(cloud, kept, options, context);
    expect(levels.every(({ points }) => points > 10_000)).toBe(true);
    expect(chosen).toBe(1);
  });
});
