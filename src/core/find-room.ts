import { nearestFoot } from './geometry/ring-foot.ts';
import { pointInPolygon, ringsOf } from './geometry/rings.ts';
import type { Furniture, Gap, Polygon, Room, Vec2 } from './types.ts';

/** Index of the room that a place lies in, plan metres; −1 where it lies in none. */
export function roomAt(rooms: readonly Pick<Room, 'outline'>[], [x, y]: Vec2): number {
  return rooms.findIndex(({ outline }) => pointInPolygon(x, y, outline) >= 0);
}

/** Index of the room whose outline a gap is of; −1 where it is of none. */
export function roomOfGap(rooms: readonly Room[], { room, from, to }: Gap): number {
  return room === undefined ? -1 : roomCalled(rooms, room, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
}

/** Index of the room that a thing stands in; −1 where none is called as it says. */
export function roomOfFurniture(rooms: readonly Room[], { room, outline }: Furniture): number {
  const [x, y] = outline.outer;
  return roomCalled(rooms, room, [x, y]);
}

/** Of rooms called alike the one nearest to a place. */
function roomCalled(rooms: readonly Room[], name: string, place: Vec2): number {
  const called = rooms.flatMap((room, index) => (room.name === name ? [index] : []));
  if (called.length < 2) return called[0] ?? -1;
  const distances = called.map((index) => distanceTo(rooms[index].outline, place));
  return called[distances.indexOf(Math.min(...distances))];
}

function distanceTo(polygon: Polygon, [x, y]: Vec2): number {
  if (pointInPolygon(x, y, polygon) >= 0) return 0;
  return Math.min(...ringsOf([polygon]).map((ring) => nearestFoot(ring, x, y, 0).distance));
}
