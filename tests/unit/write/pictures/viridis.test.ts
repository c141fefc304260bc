import { expect, it } from 'vitest';
import { viridis } from '../../../../src/write/pictures/viridis.ts';

it('runs from dark purple to yellow, ever lighter, and stays within its ends', () => {
  expect(viridis(0)).toEqual([0x44, 0x01, 0x54]);
  expect(viridis(1)).toEqual([0xfd, 0xe7, 0x25]);
  expect(viridis(-3)).toEqual(viridis(0));
  expect(viridis(3)).toEqual(viridis(1));
  let before = 0;
  for (let i = 0; i <= 20; i++) {
    const [r, g, b] = viridis(i / 20);
    const lightness = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    expect(lightness).toBeGreaterThan(before);
    before = lightness;
  }
});
