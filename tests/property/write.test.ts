import fc from 'fast-check';
import { expect, test } from 'vitest';
import type { Frame, Ring, Unit } from '../../src/core/types.ts';
import { writeGeoJson } from '../../src/write/data/geojson.ts';
import { parsePlanJson, writePlanJson } from '../../src/write/data/plan-json.ts';
import { decimal } from '../../src/write/decimals.ts';
import { writeSvg } from '../../src/write/drawing/svg.ts';
import { writeDxf } from '../../src/write/dxf/dxf.ts';
import { writeFiles } from '../../src/write/formats.ts';
import type { Product } from '../../src/write/plan-writer.ts';
import { drawSheets } from '../../src/write/sheet/draw-sheet.ts';
import { disc, planOf, wallAround } from '../unit/solid/plans.ts';
import { parseXml } from '../unit/write/drawing/strict-xml.ts';

const SEED = 2019;
const SOLID = { positions: new Float64Array(0), indices: new Uint32Array(0), groups: [] };

const UNITS: readonly (readonly [Unit, number])[] = [
  ['m', 1],
  ['cm', 0.01],
  ['mm', 0.001],
  ['ft', 0.3048],
  ['us-ft', 1200 / 3937],
  ['px', 0.01],
];

/** Frames anywhere on earth, in any unit: national grids reach some ten thousand kilometres. */
const frame = fc
  .tuple(
    fc.constantFrom(...UNITS),
    fc.double({ min: -1e7, max: 1e7, noNaN: true }),
    fc.double({ min: -1e7, max: 1e7, noNaN: true }),
  )
  .map(([[unit, metresPerUnit], x, y]): Partial<Frame> => {
    // Plus 0: JSON has no −0.
    const planOrigin = [x / metresPerUnit + 0, y / metresPerUnit + 0, 0] as const;
    return { unit, metresPerUnit, planOrigin, origin: planOrigin };
  });

const outline = fc
  .tuple(
    fc.double({ min: -50, max: 50, noNaN: true }),
    fc.double({ min: -50, max: 50, noNaN: true }),
    fc.double({ min: 0.5, max: 60, noNaN: true }),
    fc.integer({ min: 3, max: 40 }),
    fc.double({ min: 0, max: 6, noNaN: true }),
  )
  .map(([x, y, radius, sides, turn]): Ring => disc(x, y, radius, sides, turn).map((value) => value + 0));

function productOf(inner: Ring, facts: Partial<Frame>, name = 'scan'): Product {
  const plan = planOf({
    name,
    frame: facts,
    storeys: [
      {
        primary: [{ outer: inner, holes: [] }],
        walls: [{ outline: wallAround(inner, 0.2), thickness: 0.2, confidence: 1 }],
        rooms: [{ name, outline: { outer: inner, holes: [] }, height: 2.5, confidence: 1 }],
      },
    ],
  });
  const slice = { xy: inner, band: [1, 2], spacing: 0.02 } as const;
  const drawn = { name, plan, slice, options: plan.options };
  return { ...drawn, solid: SOLID, sheet: drawSheets(drawn) };
}

/** Largest distance in metres between a ring and positions in source coordinates. */
function deviation(inner: Ring, positions: readonly (readonly number[])[], { plan }: Product): number {
  const { planOrigin, metresPerUnit } = plan.frame;
  return Math.max(
    ...positions.map(([x, y], i) =>
      Math.hypot(
        (x - planOrigin[0]) * metresPerUnit - inner[2 * i],
        (y - planOrigin[1]) * metresPerUnit - inner[2 * i + 1],
      ),
    ),
  );
}

/** Rounding to 0.1 mm in both axes, and what float64 leaves of a coordinate ten thousand kilometres away. */
const TENTH = 1e-4 * Math.SQRT1_2 + 1e-7;

test('GeoJSON, slice and DXF give every vertex to a tenth of a millimetre, anywhere and in any unit', async () => {
  await fc.assert(
    fc.asyncProperty(outline, frame, async (inner, facts) => {
      const product = productOf(inner, facts);
      const count = inner.length / 2;
      const { features } = JSON.parse(writeGeoJson(product)) as {
        features: { geometry: { coordinates: number[][][] } }[];
      };
      const [ring] = features[0].geometry.coordinates;
      expect(ring).toHaveLength(count + 1);
      expect(deviation(inner, ring.slice(0, count), product)).toBeLessThan(TENTH);

      const rows = ((await writeFiles(product, 'slice'))[0].content as string).trim().split('\n').slice(1);
      expect(
        deviation(
          inner,
          rows.map((row) => row.split(',').map(Number)),
          product,
        ),
      ).toBeLessThan(TENTH);

      const polyline = writeDxf(product, 0).split('AcDbPolyline')[1].split('\n');
      const of = (code: string) =>
        polyline.flatMap((line, i) => (i % 2 === 1 && line.trim() === code ? [Number(polyline[i + 1])] : []));
      const [xs, ys] = [of('10'), of('20')];
      expect(xs).toHaveLength(count);
      expect(
        deviation(
          inner,
          xs.map((x, i) => [x, ys[i]]),
          product,
        ),
      ).toBeLessThan(TENTH);
    }),
    { seed: SEED, numRuns: 200 },
  );
});

test('plan.json read back is the plan, bit for bit', () => {
  fc.assert(
    fc.property(outline, frame, fc.string({ unit: 'grapheme' }), (inner, facts, name) => {
      const product = productOf(inner, facts, name);
      expect(parsePlanJson(writePlanJson(product))).toEqual(product.plan);
    }),
    { seed: SEED, numRuns: 200 },
  );
});

test('any name makes a well-formed drawing that says the name', () => {
  fc.assert(
    fc.property(fc.string({ unit: 'binary' }), (name) => {
      const root = parseXml(writeSvg(productOf(disc(0, 0, 4, 6), {}, name), 0));
      const [title] = root.all('title');
      // biome-ignore lint/suspicious/noControlCharactersInRegex: what XML cannot hold goes
      const allowed = name.replace(/[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ufffe\uffff]|\p{Surrogate}/gu, '');
      expect(title.text).toBe(name.trim() === '' ? 'Floor plan' : allowed);
    }),
    { seed: SEED, numRuns: 500 },
  );
});

test('any room name stays one pair of lines in a DXF', () => {
  fc.assert(
    fc.property(fc.string({ unit: 'binary', minLength: 1 }), (name) => {
      const lines = writeDxf(productOf(disc(0, 0, 4, 6), {}, name), 0).split('\n');
      lines.forEach((line, i) => {
        if (i % 2 === 0 && i + 1 < lines.length) expect(line).toMatch(/^ {0,2}\d{1,4}$/);
      });
      expect(lines.filter((line) => line === 'SECTION')).toHaveLength(6);
    }),
    { seed: SEED, numRuns: 300 },
  );
});

test('short decimals are the nearest ones', () => {
  fc.assert(
    fc.property(
      fc.double({ min: -1e9, max: 1e9, noNaN: true }),
      fc.integer({ min: 0, max: 8 }),
      (value, digits) => {
        const text = decimal(value, digits);
        expect(text).toMatch(/^-?\d+(\.\d*[1-9])?$/);
        expect(text).not.toBe('-0');
        expect(Math.abs(Number(text) - value)).toBeLessThanOrEqual(
          0.5 * 10 ** -digits + Math.abs(value) * 2e-16,
        );
      },
    ),
    { seed: SEED },
  );
});
