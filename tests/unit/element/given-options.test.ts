import { expect, it } from 'vitest';
import { GivenOptions } from '../../../src/element/given-options.ts';

it('a whole slide is one step back', () => {
  const given = new GivenOptions();
  for (const wallThickness of [0.21, 0.25, 0.3]) given.change({ wallThickness }, false);
  given.change({ wallThickness: 0.3 }, true);
  given.change({ seed: 2 }, true);
  given.undo();
  expect(given.now).toEqual({ wallThickness: 0.3 });
  given.undo();
  expect(given.now).toEqual({});
  expect(given.canUndo).toBe(false);
  given.redo();
  given.redo();
  expect(given.now).toEqual({ wallThickness: 0.3, seed: 2 });
});

it('a preset takes the place of all but what was said of the scan, as one step', () => {
  const given = new GivenOptions();
  given.replace({ unit: 'cm', up: 'y', wallThickness: 0.4, boundary: 'convex' });
  given.takePreset('paper');
  expect(given.now).toEqual({ unit: 'cm', up: 'y', preset: 'paper' });
  given.undo();
  expect(given.now).toEqual({ unit: 'cm', up: 'y', wallThickness: 0.4, boundary: 'convex' });
});

it('a slide that ends where it began is no step', () => {
  const given = new GivenOptions();
  given.replace({ wallThickness: 0.2 });
  given.change({ wallThickness: 0.4 }, false);
  given.change({ wallThickness: 0.2 }, true);
  given.undo();
  expect(given.now).toEqual({});
});

it('resetting is a step, beginning from markup is none', () => {
  const given = new GivenOptions();
  given.begin('seed', { seed: 5 });
  given.begin('wallThickness', { wallThickness: 0.4 });
  given.begin('seed', {});
  expect(given.now).toEqual({ wallThickness: 0.4 });
  expect(given.canUndo).toBe(false);
  given.reset(['wallThickness']);
  expect(given.now).toEqual({});
  given.undo();
  expect(given.now).toEqual({ wallThickness: 0.4 });
});
