import fc from 'fast-check';
import { expect, it } from 'vitest';
import { seededRandom } from '../../../fixtures/simulator/random.ts';
import { FloorPlanError } from '../../../src/core/errors.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { READ_FORMAT_NAMES, READ_FORMATS } from '../../../src/read/formats.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { makeCase, runCase } from '../../fuzz/run-case.ts';
import { FUZZ_FORMATS, SEEDS } from '../../fuzz/seeds.ts';
import { bytesOf, memorySource } from '../../unit/read/memory-source.ts';

/** `npm run fuzz` has 100,000 of these cases. */
const CASES = 40;
/** Of a format's structural boundaries, evenly. */
const MOST_CUTS = 120;
const OPTIONS = resolveOptions({ pointBudget: 1_000, resolution: 0.2, unit: 'm' });

it.each(FUZZ_FORMATS)('answers spoilt %s files with a scan or a FloorPlanError', async (format) => {
  for (let number = 0; number < CASES; number++) {
    const fuzzCase = makeCase(SEEDS[format], seededRandom(1, `${format} ${number}`));
    await expect(runCase(fuzzCase), `case ${number}`).resolves.toMatchObject({ ms: expect.any(Number) });
  }
});

it.each(FUZZ_FORMATS)('%s files cut at every structural boundary', async (format) => {
  const cuts = SEEDS[format].flatMap(({ name, bytes, boundaries }) =>
    [...new Set(boundaries)].map((end) => ({ name, bytes: bytes.subarray(0, end) })),
  );
  const step = Math.max(1, cuts.length / MOST_CUTS);
  for (let i = 0; i < cuts.length; i += step) {
    const { name, bytes } = cuts[Math.floor(i)];
    await expectScanOrError(() => readScan(memorySource(bytes, name), OPTIONS));
  }
});

it.each(FUZZ_FORMATS)('%s files are whole before they are spoilt', async (format) => {
  for (const { name, bytes } of SEEDS[format]) {
    const { positions } = await readScan(memorySource(bytes, name), OPTIONS);
    expect(positions.length, name).toBeGreaterThanOrEqual(9);
  }
});

const anyBytes = fc.oneof(
  fc.uint8Array({ maxLength: 400 }),
  fc.string({ unit: fc.constantFrom(...'0123456789.,;-+e" \t\r\n#%/nainfxyz'), maxLength: 200 }).map(bytesOf),
);
const pieces = fc.array(fc.integer({ min: 1, max: 60 }), { minLength: 1, maxLength: 3 });

it('answers any bytes with a scan or a FloorPlanError', async () => {
  await fc.assert(
    fc.asyncProperty(
      anyBytes,
      fc.constantFrom('a.ply', 'a.csv', 'a.laz', 'a.obj', 'a'),
      async (bytes, name) => {
        await expectScanOrError(() => readScan(memorySource(bytes, name), OPTIONS));
      },
    ),
    { numRuns: 400 },
  );
});

it.each(READ_FORMAT_NAMES)('the %s reader alone throws nothing else, whatever the format', async (format) => {
  const ownOrOther = fc.oneof(
    anyBytes,
    fc
      .tuple(fc.constantFrom(format, ...FUZZ_FORMATS), fc.integer({ min: 0, max: 1e6 }))
      .map(([from, number]) => makeCase(SEEDS[from], seededRandom(2, `${from} ${number}`)).bytes),
  );
  await fc.assert(
    fc.asyncProperty(ownOrOther, pieces, async (bytes, split) => {
      READ_FORMATS[format].detect(bytes);
      await expectScanOrError(async () => {
        const cloud = await READ_FORMATS[format].open(memorySource(bytes, 'a', split));
        for await (const { count } of cloud.chunks(() => {}, 0.1, 1_000)) expect(count).toBeGreaterThan(0);
      });
    }),
    { numRuns: 150 },
  );
});

async function expectScanOrError(work: () => Promise<unknown>): Promise<void> {
  try {
    await work();
  } catch (error) {
    if (!(error instanceof FloorPlanError)) throw error;
    expect(error.code).toMatch(/^input\//);
    expect(error.message).not.toBe('');
    expect(error.hint).not.toBe('');
  }
}
