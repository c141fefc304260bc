import { describe, expect, it } from 'vitest';
import { arrange } from '../../../../src/core/building/space/arrangement.ts';
import type { FoundRooms } from '../../../../src/core/building/space/found-rooms.ts';
import { withoutNecks } from '../../../../src/core/building/space/necks.ts';
import { traceRooms } from '../../../../src/core/building/space/trace-rooms.ts';

const [WIDTH, DEPTH] = [8, 4];
const [LEFT, RIGHT] = [4, 4.1];

/** Two rooms with a wall between them that ends `gap` (m) short of the wall it runs towards. */
function roomsBeside(gap: number): FoundRooms {
  const end = DEPTH - gap;
  const segment = (ax: number, ay: number, bx: number, by: number) => ({ ax, ay, bx, by, line: 0 });
  const arrangement = arrange([
    segment(0, 0, WIDTH, 0),
    segment(WIDTH, 0, WIDTH, DEPTH),
    segment(WIDTH, DEPTH, 0, DEPTH),
    segment(0, DEPTH, 0, 0),
    segment(LEFT, 0, LEFT, DEPTH),
    segment(RIGHT, 0, RIGHT, DEPTH),
    segment(LEFT, end, RIGHT, end),
  ]);
  const { x, y, origin, areas } = arrangement;
  const support = Float64Array.from({ length: origin.length / 2 }, (_, e) => {
    const [u, v] = [origin[2 * e], origin[2 * e + 1]];
    const [midX, midY] = [(x[u] + x[v]) / 2, (y[u] + y[v]) / 2];
    return midY >= end && midY < DEPTH && midX >= LEFT && midX <= RIGHT ? 0 : 1;
  });
  const wall = (RIGHT - LEFT) * end;
  const isRoom = Uint8Array.from(areas, (area) => (Math.abs(area - wall) < 1e-6 ? 0 : 1));
  return {
    faces: [],
    arrangement,
    support,
    space: { isRoom, seen: areas },
    curves: [],
    rooms: traceRooms(arrangement, isRoom, support, []),
  };
}

describe('rooms that a gap in a wall joins', () => {
  it('are two where nobody passes through it, and the gap is wall', () => {
    const found = roomsBeside(0.05);
    expect(found.rooms).toHaveLength(1);
    const parted = withoutNecks(found);
    const rooms = traceRooms(found.arrangement, parted!.space.isRoom, parted!.support, []);
    const areas = rooms.map(({ areaM2 }) => areaM2).sort();
    expect(areas[0]).toBeCloseTo((WIDTH - RIGHT) * DEPTH, 6);
    expect(areas[1]).toBeCloseTo(LEFT * DEPTH, 6);
  });

  it('are one where it is a passage', () => {
    expect(withoutNecks(roomsBeside(0.9))).toBeNull();
  });
});
