import { expect, it } from 'vitest';
import { cutText } from '../../../src/core/cut-text.ts';

it('text is cut where it is longer, between characters', () => {
  expect(cutText('floor', 5)).toBe('floor');
  expect(cutText('floors', 5)).toBe('floo…');
  expect(cutText('😀😀😀', 3)).toBe('😀😀😀');
  expect(cutText('😀😀😀😀', 3)).toBe('😀😀…');
});
