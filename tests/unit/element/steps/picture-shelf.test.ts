import { expect, it } from 'vitest';
import { PictureShelf } from '../../../../src/element/steps/picture-shelf.ts';

it('fetches a picture once a run, and again after it failed', async () => {
  const asked: string[] = [];
  const shelf = new PictureShelf(({ name, of, round }) => {
    asked.push([name, 'of', of, ...(round ? ['round', round] : [])].join(' '));
    return asked.length === 1 ? Promise.reject(new Error('cancelled')) : Promise.resolve(name);
  });
  const [first, second] = [{}, {}];
  expect(shelf.turnTo(first, 'plan')).toBe(true);
  await expect(shelf.get('hull')).rejects.toThrow('cancelled');
  expect(await shelf.get('hull')).toBe('hull');
  expect(await shelf.get('hull')).toBe('hull');
  expect(shelf.turnTo(first, 'plan')).toBe(false);
  expect(asked).toEqual(['hull of plan', 'hull of plan']);
  expect(shelf.turnTo(second, 'failed')).toBe(true);
  await shelf.get('hull');
  expect(asked.at(-1)).toBe('hull of failed');
  await shelf.get('hull', 1);
  await shelf.get('hull', 1);
  expect(asked.slice(-2)).toEqual(['hull of failed', 'hull of failed round 1']);
});
