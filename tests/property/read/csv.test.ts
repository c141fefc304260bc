import fc from 'fast-check';
import { expect, it } from 'vitest';
import { NumberScanner, parseNumber } from '../../../src/read/text/scan-number.ts';
import { bytesOf, memorySource, readAll } from '../../unit/read/memory-source.ts';

const digits = (maxLength: number) => fc.string({ unit: fc.constantFrom(...'0123456789'), maxLength });

/** Every way to spell a decimal number. */
const spelling = fc
  .tuple(
    fc.constantFrom('', '-', '+'),
    digits(20),
    fc.option(digits(20)),
    fc.option(fc.tuple(fc.constantFrom('e', 'E'), fc.integer({ min: -330, max: 330 }))),
  )
  .filter(([, whole, decimals]) => whole !== '' || (decimals ?? '') !== '')
  .map(([sign, whole, decimals, exponent]) => {
    const fraction = decimals === null ? '' : `.${decimals}`;
    return `${sign}${whole}${fraction}${exponent ? exponent.join('') : ''}`;
  });

it('reads every spelling of a number as Number() does', () => {
  const scanner = new NumberScanner();
  fc.assert(
    fc.property(spelling, (text) => {
      expect(scanner.scan(bytesOf(`${text},`), 0, false)).toBe(Number(text));
      expect(scanner.position).toBe(text.length);
      expect(parseNumber(text, false)).toBe(Number(text));
    }),
    { numRuns: 2_000 },
  );
});

it('reads back every double that was printed', () => {
  const scanner = new NumberScanner();
  fc.assert(
    fc.property(fc.double({ noNaN: true, noDefaultInfinity: true }), (value) => {
      expect(scanner.scan(bytesOf(`${Object.is(value, -0) ? '-0' : value}\n`), 0, false)).toBe(value);
    }),
    { numRuns: 2_000 },
  );
});

const table = fc.record({
  rows: fc.array(
    fc.tuple(...Array.from({ length: 3 }, () => fc.double({ noNaN: true, noDefaultInfinity: true }))),
    {
      minLength: 1,
      maxLength: 30,
    },
  ),
  style: fc.constantFrom(
    { separator: ',', comma: false },
    { separator: ' , ', comma: false },
    { separator: ';', comma: false },
    { separator: ';', comma: true },
    { separator: '\t', comma: true },
    { separator: '  ', comma: false },
    { separator: ' \t', comma: true },
  ),
  lineEnd: fc.constantFrom('\n', '\r\n', '\r', '\n\n'),
  hasLastEnd: fc.boolean(),
  header: fc.boolean(),
  pieces: fc.array(fc.integer({ min: 1, max: 50 }), { minLength: 1, maxLength: 4 }),
});

it('reads back any table, however it is split', async () => {
  await fc.assert(
    fc.asyncProperty(
      table,
      async ({ rows, style: { separator, comma }, lineEnd, hasLastEnd, header, pieces }) => {
        const spell = (value: number) => (comma ? String(value).replace('.', ',') : String(value));
        const lines = rows.map((row) => row.map(spell).join(separator));
        if (header) lines.unshift(['x', 'y', 'z'].join(separator));
        const text = lines.join(lineEnd) + (hasLastEnd ? lineEnd : '');
        const { xyz, isSlice } = await readAll(memorySource(text, 'a.csv', pieces));
        expect(isSlice).toBe(false);
        expect(xyz).toEqual(rows.map((row) => row.map((value) => value + 0)));
      },
    ),
  );
});
