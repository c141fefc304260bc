import { describe, expect, it } from 'vitest';
import { NumberScanner, parseNumber } from '../../../src/read/text/scan-number.ts';
import { bytesOf } from './memory-source.ts';

function scan(text: string, hasComma = true) {
  const scanner = new NumberScanner();
  const value = scanner.scan(bytesOf(`${text}\n`), 0, hasComma);
  return { value, position: scanner.position };
}

describe('NumberScanner', () => {
  it.each([
    '0',
    '-0',
    '+7',
    '007.50',
    '1.',
    '.5',
    '1e22',
    '1e23',
    '123456789012345.6',
    '9007199254740993',
    '0.1',
    '-3.4028234663852886e+38',
    '4.9406564584124654e-324',
    '1.7976931348623157e308',
    '1e400',
    '0e999999999',
    '1e-400',
    '0.000000000000000000000000000001',
    '5421234.123456789',
  ])('reads %s as Number() does', (text) => {
    expect(scan(text)).toEqual({ value: Number(text), position: text.length });
  });

  it('takes a comma for a point where told', () => {
    expect(scan('1,25')).toEqual({ value: 1.25, position: 4 });
    expect(scan('1,2345678901234567890')).toEqual({ value: Number('1.2345678901234567890'), position: 21 });
    expect(scan('1,25', false)).toEqual({ value: 1, position: 1 });
  });

  it.each(['', '-', 'x', '.', 'e5', '-.e1'])('finds no number in %j', (text) => {
    expect(scan(text).value).toBeUndefined();
  });

  it('stops before an e without digits', () => {
    expect(scan('2em')).toEqual({ value: 2, position: 1 });
  });
});

describe('parseNumber', () => {
  it('drops quotes and blanks', () => {
    expect(parseNumber(' " 1.5 " ', false)).toBe(1.5);
    expect(parseNumber("'2,5'", true)).toBe(2.5);
    expect(parseNumber('"2,5"', false)).toBe(2.5);
  });

  it('tells what is not finite from what is no number', () => {
    for (const text of ['nan', '-NaN', 'NAN(0x7)', '+inf', 'Infinity', '-1.#IND', 'none', 'n/a', '']) {
      expect(parseNumber(text, false)).toBeNaN();
    }
    for (const text of ['1,5', 'abc', '1 2', '0x10', 'nano', '1.2.3']) {
      expect(parseNumber(text, false)).toBeUndefined();
    }
  });
});
