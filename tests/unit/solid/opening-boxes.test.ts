import { expect, test } from 'vitest';
import { areaOf, combine } from '../../../src/core/geometry/areas.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { type DoorSite, placeDoors } from '../../../src/core/place-doors.ts';
import { penReach, strokeContour } from '../../../src/core/plan-walls.ts';
import type { Opening, Polygon, Ring } from '../../../src/core/types.ts';
import { openingBoxes } from '../../../src/solid/opening-boxes.ts';
import { disc, planOf, rectangle, ring } from './plans.ts';

/** The walls along an outline, its doors and what each takes out of the walls. */
function cutsIn(outer: Ring, given: Parameters<typeof resolveOptions>[0]) {
  const options = resolveOptions(given);
  const polygon = { outer, holes: [] };
  const thickness = options.wallThickness;
  const walls = strokeContour(polygon, penReach(options));
  const frame = { planOrigin: [0, 0, 0], metresPerUnit: 1 } as unknown as DoorSite['frame'];
  const outlines = [{ polygon, confidence: 1 }];
  const openings = placeDoors({ outlines, gaps: [], frame, height: 2.5, options }, { warn: () => {} });
  const { storeys } = planOf({
    storeys: [{ walls: walls.map((outline) => ({ outline, thickness, confidence: 1 })), openings }],
  });
  return { walls, openings, boxes: openingBoxes(storeys[0]).map(({ base }) => base) };
}

const widthOf = ({ from, to }: Opening) => Math.hypot(to[0] - from[0], to[1] - from[1]);
const taken = (walls: readonly Polygon[], box: Polygon) => areaOf(combine('intersection', walls, [box]));

test.each([
  [30, 'outside', 0.1],
  [30, 'centre', 0.1],
  [30, 'centre', 0.3],
  [45, 'outside', 0.3],
  [60, 'centre', 0.3],
  [75, 'outside', 0.1],
  [90, 'centre', 0.3],
  [300, 'outside', 0.3],
] as const)(
  'at a corner of %i° a door takes no more than its own wall, %s, %f m thick',
  (angle, wallSide, wallThickness) => {
    const turn = Math.PI - (angle * Math.PI) / 180;
    const corner = [-4, 0, 0, 0, 2.5 * Math.cos(turn), 2.5 * Math.sin(turn)];
    const outer = ring(...corner, ...(angle < 180 ? [] : [3, 5]), -4, angle < 180 ? 4 : 5);
    for (const away of [0.05, 0.2, 0.46, 0.6, 0.8, 2]) {
      const { walls, openings, boxes } = cutsIn(outer, { wallSide, wallThickness, doors: `${-away},0,0.9` });
      expect(boxes).toHaveLength(openings.length);
      for (const box of boxes) {
        const own = widthOf(openings[0]) * wallThickness;
        expect(taken(walls, box) / own).toBeGreaterThan(0.99);
        expect(taken(walls, box) / own).toBeLessThan(1.01);
      }
    }
  },
);

test.each(['outside', 'centre'] as const)(
  'a door through a round wall goes right through, %s',
  (wallSide) => {
    const { walls, openings, boxes } = cutsIn(disc(0, 0, 2, 90), {
      wallSide,
      wallThickness: 0.1,
      doors: '2,0,0.9',
    });
    const [{ from, to }] = openings;
    // Off the ends, which are as slanted as the door.
    const inner = rectangle(1, from[1] + 0.01, 2, to[1] - from[1] - 0.02);
    const opening = combine('intersection', walls, [{ outer: inner, holes: [] }]);
    expect(areaOf(opening)).toBeGreaterThan(0.085);
    expect(areaOf(combine('difference', opening, boxes))).toBeLessThan(1e-6);
  },
);
