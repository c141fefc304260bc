import { roomAt, roomOfFurniture, roomOfGap } from './find-room.ts';
import { parseRoomNames, type RoomName } from './room-names.ts';
import { planPlace } from './source-coordinates.ts';
import type { FloorPlan, Storey, Warning } from './types.ts';

/** A name that was given is in no room of the plan. */
const NO_SUCH_ROOM = 'plan/no-such-room';

/**
 * Calls the rooms as the parameter `roomNames` says, and with them what stands in them and what of their outlines was not seen.
 * Of several names for one room the last counts. Warning: `plan/no-such-room`. Names × rooms.
 *
 * @param plan its storeys lowest first
 * @throws option/invalid
 */
export function nameRooms(
  { storeys, frame, options }: Pick<FloorPlan, 'storeys' | 'frame' | 'options'>,
  warn: (warning: Warning) => void,
): readonly Storey[] {
  const names = parseRoomNames(options.roomNames);
  if (names.length === 0) return storeys;
  if (storeys.every(({ rooms }) => rooms.length === 0)) {
    warn(hasNoRooms(names));
    return storeys;
  }
  const byRoom = storeys.map(() => new Map<number, string>());
  for (const given of names) {
    const index = roomAt(storeys[given.storey]?.rooms ?? [], planPlace(frame, given.x, given.y));
    if (index >= 0) byRoom[given.storey].set(index, given.name);
    else warn(isInNoRoom(given, storeys.length));
  }
  return storeys.map((storey, i) => renamed(storey, byRoom[i]));
}

function renamed(storey: Storey, names: ReadonlyMap<number, string>): Storey {
  const { rooms, gaps, furniture } = storey;
  return {
    ...storey,
    rooms: rooms.map((room, i) => ({ ...room, name: names.get(i) ?? room.name })),
    gaps: gaps.map((gap) => {
      const room = names.get(roomOfGap(rooms, gap));
      return room === undefined ? gap : { ...gap, room };
    }),
    ...(furniture && {
      furniture: furniture.map((thing) => ({
        ...thing,
        room: names.get(roomOfFurniture(rooms, thing)) ?? thing.room,
      })),
    }),
  };
}

function isInNoRoom({ x, y, storey, name }: RoomName, storeys: number): Warning {
  const where = storeys > 1 || storey > 0 ? ` of storey ${storey}` : '';
  const found = storey < storeys ? `lies in no room${where}` : `is in storey ${storey}, which the plan lacks`;
  return {
    code: NO_SUCH_ROOM,
    message: `No room is called "${name}": the place ${x}, ${y} ${found}.`,
    hint: 'Give a place inside the room in source coordinates, as in plan.geojson; storey 0 is the lowest.',
  };
}

function hasNoRooms({ length }: readonly RoomName[]): Warning {
  return {
    code: NO_SUCH_ROOM,
    message: `${length === 1 ? 'The name given is' : `The ${length} names given are`} of no use: the plan is one of outlines and has no rooms.`,
    hint: 'Set planMethod to rooms, where the scan shows any.',
  };
}
