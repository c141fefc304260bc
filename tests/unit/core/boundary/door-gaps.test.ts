/** The safeguard: a gap in a wall is bridged at every opening length; a recess as wide is followed. */
import { describe, expect, it } from 'vitest';
import { findBoundary } from '../../../../src/core/boundary.ts';
import { meanSpacing } from '../../../../src/core/geometry/spacing.ts';
import { expectValidPolygons } from '../../../invariants.ts';
import {
  areaLostToGap,
  GAP_WIDTHS,
  type GapCase,
  gapCases,
  OPENING_LENGTHS,
  widthAcross,
  widthNamed,
} from '../../../reproduction/door-gaps.ts';
import { RECESSES, ROOMS } from '../../../reproduction/room-cases.ts';
import { areaError, intersectionOverUnion, ringOf } from './measures.ts';
import { asSlice, closed, listeningContext, optionsWith, type Path, scanWalls } from './wall-slices.ts';

const RECTANGLE = ROOMS.rectangle;
/**
 * A gap is told of when its ends lie farther apart than steps along a wall do, 8 spacings or 0.2 m, and noise. Nearer
 * ends, as of a gap of 0.3 m around a corner, are a step like any other: the points do not tell it.
 */
function isTold(gapCase: GapCase): boolean {
  const { slice, noise } = gapCase;
  return widthAcross(gapCase) > Math.max(0.2, 8 * slice.spacing) + 3 * noise;
}

describe('a gap in a wall', () => {
  for (const width of GAP_WIDTHS) {
    it(`costs at most 2 % of the area at every opening length, and is named: ${width} m`, () => {
      let told = 0;
      for (const gapCase of gapCases(width, 11)) {
        const { room, place, noise, perMetre, slice } = gapCase;
        for (const openingLength of OPENING_LENGTHS) {
          const context = listeningContext();
          const { polygons, gaps } = findBoundary(slice, optionsWith({ openingLength }), context);
          const where = `${room}, ${place}, noise ${noise}, ${perMetre} points per metre, opening length ${openingLength}`;
          expect(areaLostToGap(polygons[0].outer, gapCase, openingLength), where).toBeLessThan(0.02);
          expectValidPolygons(polygons);
          if (!isTold(gapCase)) continue;
          told++;
          const warning = context.warnings.find(({ code }) => code === 'boundary/gap-bridged');
          expect(warning?.message, where).toMatch(/\d\.\d\d m wide at \(-?\d/);
          expect(widthNamed(gapCase, gaps), where).toBeGreaterThan(0.8 * widthAcross(gapCase));
        }
      }
      expect(told).toBeGreaterThan(0);
    });
  }

  it('is named with its place and width', () => {
    const gaps = [{ wall: 0, from: 3, to: 4 }];
    const xy = scanWalls({ walls: [closed(RECTANGLE)], perMetre: 100, noise: 0.005, seed: 1, gaps });
    const { gaps: found } = findBoundary(asSlice(xy), optionsWith(), listeningContext());
    expect(found.length).toBe(1);
    expect(found[0].width).toBeCloseTo(1, 1);
    expect(found[0].from[0]).toBeCloseTo(3, 1);
    expect(found[0].to[0]).toBeCloseTo(4, 1);
    expect(found[0].from[1]).toBeCloseTo(0, 1);
  });

  it('is named where the walls beside it are scanned every few millimetres', () => {
    for (let seed = 1; seed <= 6; seed++) {
      for (const perMetre of [100, 200, 400]) {
        const gaps = [{ wall: 0, from: 17.7, to: 20.7 }];
        const xy = scanWalls({ walls: [closed(ROOMS.ell)], perMetre, noise: 0, seed, gaps });
        const { gaps: found } = findBoundary(asSlice(xy), optionsWith(), listeningContext());
        const missing = found.reduce((sum, { width }) => sum + width, 0);
        expect(missing, `seed ${seed}, ${perMetre} points per metre`).toBeGreaterThan(2.6);
      }
    }
  });

  it('makes no corner of a wall that is bent at its end', () => {
    const room = ROOMS.octagon;
    const side = Math.hypot(room[1][0] - room[0][0], room[1][1] - room[0][1]);
    for (const seed of [1, 2, 3]) {
      const gaps = [{ wall: 0, from: side + 0.2, to: 2 * side - 0.2 }];
      const xy = scanWalls({ walls: [closed(room)], perMetre: 60, noise: 0, seed, gaps });
      const { polygons } = findBoundary(asSlice(xy), optionsWith(), listeningContext());
      expect(areaError(polygons[0].outer, ringOf(room)), `seed ${seed}`).toBeLessThan(0.002);
    }
  });

  it('loses the room without the safeguard, and says so', () => {
    const gaps = [{ wall: 0, from: 3, to: 3.6 }];
    const xy = scanWalls({ walls: [closed(RECTANGLE)], perMetre: 100, noise: 0.005, seed: 1, gaps });
    const context = listeningContext();
    const options = optionsWith({ openingLength: 0.5, bridgeGap: 0 });
    const { polygons } = findBoundary(asSlice(xy), options, context);
    expect(areaError(polygons[0].outer, ringOf(RECTANGLE))).toBeGreaterThan(0.9);
    expect(context.warnings.map(({ code }) => code)).toEqual(['boundary/collapsed']);
  });

  it('around a corner gets the corner back', () => {
    const gaps = [{ wall: 0, from: 8.5, to: 11.5 }];
    const xy = scanWalls({ walls: [closed(RECTANGLE)], perMetre: 100, noise: 0.006, seed: 2, gaps });
    const { polygons, gaps: found } = findBoundary(asSlice(xy), optionsWith(), listeningContext());
    expect(found.length).toBe(2);
    expect(intersectionOverUnion(polygons[0].outer, ringOf(RECTANGLE))).toBeGreaterThan(0.99);
  });

  it.each([0, 20])(
    'is bridged in a flat of four rooms with two-faced partitions and doors, %i stray points',
    (count) => {
      const face = 0.12;
      const rooms: Path[] = [
        closed([
          [0, 0],
          [4, 0],
          [4, 4],
          [0, 4],
        ]),
        closed([
          [4 + face, 0],
          [10, 0],
          [10, 4],
          [4 + face, 4],
        ]),
        closed([
          [0, 4 + face],
          [6, 4 + face],
          [6, 8],
          [0, 8],
        ]),
        closed([
          [6 + face, 4 + face],
          [10, 4 + face],
          [10, 8],
          [6 + face, 8],
        ]),
      ];
      const doors = [
        { wall: 0, from: 5, to: 5.9 },
        { wall: 0, from: 9, to: 9.9 },
        { wall: 2, from: 2.1, to: 3 },
        { wall: 1, from: 11, to: 11.9 },
      ];
      for (const width of WIDTHS) {
        for (const at of [0, 0.6, 1.6, 3.2, 5]) {
          const gaps = [
            ...doors,
            { wall: 0, from: at, to: at + width },
            { wall: 1, from: at - 4 - face, to: at + width - 4 - face },
          ];
          const strays = { count, box: [0, 0, 10, 8] as const };
          const xy = scanWalls({ walls: rooms, perMetre: 100, noise: 0.006, seed: 5, gaps, strays });
          for (const openingLength of [0.05, 0.1, 0.25, 0.5]) {
            const context = listeningContext();
            const { polygons } = findBoundary(asSlice(xy), optionsWith({ openingLength }), context);
            const where = `width ${width}, at ${at}, opening length ${openingLength}`;
            expect(
              areaError(polygons[0].outer, Float64Array.of(0, 0, 10, 0, 10, 8, 0, 8)),
              where,
            ).toBeLessThan(0.02);
            expect(context.warnings.map(({ code }) => code)).toContain('boundary/gap-bridged');
            expectValidPolygons(polygons);
          }
        }
      }
    },
  );
});

/** Mouths of recesses. */
const WIDTHS = [0.3, 0.6, 1, 2, 3];

describe('a recess with scanned sides', () => {
  for (const name of ['in a wall', 'slanting', 'at a corner']) {
    const make = RECESSES[name];
    it(`is followed, IoU at least 0.98: ${name}`, () => {
      for (const width of WIDTHS) {
        for (const depth of [0.3, 0.6, 1.2, 3]) {
          // Narrower and deeper than this it is the hollow of a wall.
          if (depth > 4 * width) continue;
          const room = make(width, depth);
          for (const noise of [0, 0.006]) {
            const scan = {
              walls: [closed(room)],
              perMetre: 100,
              noise,
              seed: Math.round(10 * width + depth),
            };
            for (const openingLength of [0.1, 'auto', 0.2] as const) {
              const { polygons } = findBoundary(
                asSlice(scanWalls(scan)),
                optionsWith({ openingLength }),
                listeningContext(),
              );
              const where = `width ${width}, depth ${depth}, noise ${noise}, opening length ${openingLength}`;
              expect(intersectionOverUnion(polygons[0].outer, ringOf(room)), where).toBeGreaterThan(0.98);
              expectValidPolygons(polygons);
            }
          }
        }
      }
    });
  }

  it('is followed with a window in its back wall, which is bridged', () => {
    const room = RECESSES['in a wall'](3, 2);
    const partition: Path = [
      [3.5, 2],
      [3.5, 6],
    ];
    const back = 5 - 1.5 + 2;
    const gaps = [{ wall: 0, from: back + 0.9, to: back + 2.1 }];
    const xy = scanWalls({ walls: [closed(room), partition], perMetre: 100, noise: 0.006, seed: 9, gaps });
    const { polygons, gaps: found } = findBoundary(asSlice(xy), optionsWith(), listeningContext());
    expect(intersectionOverUnion(polygons[0].outer, ringOf(room))).toBeGreaterThan(0.98);
    expect(found.map(({ width }) => width.toFixed(1))).toEqual(['1.2']);
  });
});

describe('the hollow between the faces of a partition', () => {
  it('is not entered and is no gap', () => {
    const left: Path = closed([
      [0, 0],
      [4, 0],
      [4, 4],
      [0, 4],
    ]);
    const right: Path = closed([
      [4.15, 0],
      [9, 0],
      [9, 4],
      [4.15, 4],
    ]);
    const xy = scanWalls({ walls: [left, right], perMetre: 300, noise: 0.003, seed: 4 });
    expect(meanSpacing(xy)).toBeLessThan(0.01);
    for (const openingLength of [0.05, 0.1, 'auto'] as const) {
      const { polygons, gaps } = findBoundary(
        asSlice(xy),
        optionsWith({ openingLength }),
        listeningContext(),
      );
      expect(areaError(polygons[0].outer, Float64Array.of(0, 0, 9, 0, 9, 4, 0, 4))).toBeLessThan(0.005);
      expect(gaps).toEqual([]);
    }
  });
});
