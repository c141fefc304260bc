import { expect, it } from 'vitest';
import { History } from '../../../src/element/history.ts';

it('goes back and forth; a new step drops what was ahead', () => {
  const history = new History<number>();
  history.leave(1);
  history.leave(2);
  expect(history.undo(3)).toBe(2);
  expect(history.undo(2)).toBe(1);
  expect(history.canUndo).toBe(false);
  expect(history.undo(1)).toBe(1);
  expect(history.redo(1)).toBe(2);
  history.leave(2);
  expect(history.canRedo).toBe(false);
  expect(history.redo(9)).toBe(9);
});
