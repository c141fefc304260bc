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

it('rooms named by hand are those of the scan they were named in', () => {
  const given = new GivenOptions();
  given.enter('home.ply');
  given.change({ roomNames: '1,1=Hall', unit: 'cm' }, true);
  given.takePreset('building');
  expect(given.of('home.ply')).toEqual({ roomNames: '1,1=Hall', unit: 'cm', preset: 'building' });
  expect(given.of('shop.ply')).toEqual({ unit: 'cm', preset: 'building' });
  given.enter('home.ply');
  expect(given.now.roomNames).toBe('1,1=Hall');
  given.enter('shop.ply');
  expect(given.now).toEqual({ unit: 'cm', preset: 'building' });
});

it('names that a page gives are for whatever scan comes', () => {
  const given = new GivenOptions();
  given.enter('home.ply');
  given.replace({ roomNames: '1,1=Hall' });
  given.enter('shop.ply');
  expect(given.now).toEqual({ roomNames: '1,1=Hall' });
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
