import { describe, expect, it } from 'vitest';
import { uprightRotation } from '../../../src/core/frame/rotation.ts';
import { orient } from '../../../src/core/frame.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import type { GivenValues } from '../../../src/core/params.ts';
import { planPlace } from '../../../src/core/source-coordinates.ts';
import type { Axis } from '../../../src/core/types.ts';
import { GivenOptions } from '../../../src/element/given-options.ts';
import { PlaceKeeper } from '../../../src/element/place-keeper.ts';
import { listen, makeScan, roomPoints, tiltMatrix, transform, transpose } from '../core/made-scan.ts';

const CROP = '1,2,4,3,0.5,2';
const DOORS = 'gaps;3,2,0.9;5,0.5,1.2,2.1';
const NAMES = '1,2=Hall;3,4,1=A;; b';
const PLACED: GivenValues = { crop: CROP, doors: DOORS, roomNames: NAMES };

function keeperOf(up: Axis, { metresPerUnit = 1, isFixed = false, storeys = 1 } = {}): PlaceKeeper {
  const keeper = new PlaceKeeper();
  keeper.learn({ frame: { up, metresPerUnit }, isFixed, storeys }, {});
  return keeper;
}

describe('another unit', () => {
  it('leaves the places and lets the doors grow with the plan', () => {
    const keeper = keeperOf('z');
    const carried = keeper.carry(PLACED, { ...PLACED, metresPerUnit: 2 });
    expect(carried).toEqual({ ...PLACED, metresPerUnit: 2, doors: 'gaps;3,2,1.8;5,0.5,2.4,4.2' });
    expect(keeper.notices).toEqual([]);
  });

  it('leaves a size that would be no door', () => {
    const carried = keeperOf('z').carry(PLACED, { ...PLACED, unit: 'mm' });
    expect(carried.doors).toBe(DOORS);
  });

  it('that is the one found changes nothing', () => {
    expect(keeperOf('z').carry(PLACED, { ...PLACED, unit: 'm', up: 'z' })).toEqual({
      ...PLACED,
      unit: 'm',
      up: 'z',
    });
  });

  it('is taken from the beginning of a slide, and undone with it', () => {
    const keeper = keeperOf('z');
    const given = new GivenOptions((before, next) => keeper.carry(before, next));
    given.change({ doors: '3,2,0.9' }, true);
    for (const metresPerUnit of [1.1, 1.3337, 1.7]) given.change({ metresPerUnit }, false);
    given.change({ metresPerUnit: 2 }, true);
    expect(given.now.doors).toBe('3,2,1.8');
    given.undo();
    expect(given.now).toEqual({ doors: '3,2,0.9' });
  });
});

describe('another axis up', () => {
  it('mirrors the places of a scan turned over, and back', () => {
    const keeper = keeperOf('z', { storeys: 3 });
    const over = keeper.carry(PLACED, { ...PLACED, up: '-z' });
    expect(over).toEqual({
      ...{ up: '-z', crop: '1,-3,4,-2,-2,-0.5', doors: 'gaps;3,-2,0.9;5,-0.5,1.2,2.1' },
      roomNames: '1,-2,2=Hall;3,-4,1=A;; b',
    });
    expect(keeper.carry(over, { ...over, up: 'auto' })).toEqual({ ...PLACED, up: 'auto' });
    expect(keeper.notices).toEqual([]);
  });

  it('mirrors the heading of a box', () => {
    const carried = keeperOf('z').carry({ crop: '1,2,4,3@10' }, { crop: '1,2,4,3@10', up: '-z' });
    expect(carried.crop).toBe('1,-3,4,-2@-10');
  });

  it('drops them, says so, and undo brings them back', () => {
    const keeper = keeperOf('z');
    const given = new GivenOptions((before, next) => keeper.carry(before, next));
    given.change(PLACED, true);
    given.change({ up: 'y' }, true);
    expect(given.now).toEqual({ up: 'y', crop: 'none', doors: 'gaps', roomNames: 'none' });
    expect(keeper.notices.map(({ code }) => code)).toEqual([
      'frame/crop-dropped',
      'frame/doors-dropped',
      'frame/room-names-dropped',
    ]);
    expect(keeper.notices[0].message).toContain('with z up, and now y is');
    given.undo();
    expect(given.now).toEqual(PLACED);
  });

  it('drops them where the automatic axis is not known', () => {
    const keeper = new PlaceKeeper();
    keeper.learn({ frame: { up: 'y', metresPerUnit: 1 }, isFixed: false, storeys: 1 }, { up: 'y' });
    const given = new GivenOptions((before, next) => keeper.carry(before, next));
    given.replace({ ...PLACED, up: 'y' });
    given.reset(['up']);
    expect(given.now).toEqual({ crop: 'none', doors: 'gaps', roomNames: 'none' });
  });

  it('leaves what is fixed, as a ready slice, which has no other', () => {
    const carried = keeperOf('z', { isFixed: true }).carry(PLACED, { ...PLACED, up: 'y' });
    expect(carried).toEqual({ ...PLACED, up: 'y' });
  });

  it('leaves what the change itself places', () => {
    const next = { up: '-z', crop: '0,0,1,1', doors: 'none', roomNames: '7,7=Bath' } as const;
    expect(keeperOf('z').carry(PLACED, next)).toEqual(next);
  });

  it.each(['z', 'y', 'x'] as const)('mirrors by the very frames of a tilted scan: %s', (up) => {
    const room = transform(roomPoints(), tiltMatrix((4 * Math.PI) / 180, 0.7));
    const scan = makeScan(transform(room, transpose(uprightRotation(up))), { origin: [10, 20, 30] });
    const frameOf = (given: GivenValues) => orient(scan, resolveOptions(given), listen().context).frame;
    const [frame, turned] = [frameOf({ up }), frameOf({ up: `-${up}` })];
    const keeper = new PlaceKeeper();
    const { doors } = keeper.carry({ up, doors: '12,-25,0.9' }, { up: `-${up}`, doors: '12,-25,0.9' });
    const [x, y] = doors!.split(',').map(Number);
    const [before, after] = [planPlace(frame, 12, -25), planPlace(turned, x, y)];
    expect(Math.abs(after[0] - before[0])).toBeLessThan(0.01);
    expect(Math.abs(after[1] + before[1])).toBeLessThan(0.01);
  });
});
