import { roomAt } from '../../core/find-room.ts';
import { automaticName, formatRoomNames, parseRoomNames, type RoomName } from '../../core/room-names.ts';
import { planPlace, sourceCoordinates } from '../../core/source-coordinates.ts';
import type { FloorPlan, Frame, Room, Vec2 } from '../../core/types.ts';
import { labelPoint } from '../../write/sheet/label-point.ts';

/** A place is written to the centimetre: rooms are larger. m */
const WRITTEN = 0.01;

/** What the names are said of. */
export interface NamedStorey {
  readonly plan: FloorPlan;
  /** Index of the storey shown. */
  readonly storey: number;
  /** The parameter `roomNames`; it may be ahead of the plan while a run is under way. */
  readonly text: string;
  /** A plan without its scan keeps the names it came with where nothing else is said. */
  readonly isSaved: boolean;
}

/** The rooms of the storey shown as the parameter `roomNames` calls them, and what another name makes of the parameter. */
export class PlanRoomNames {
  readonly rooms: readonly Room[];
  readonly #frame: Frame;
  readonly #storey: number;
  readonly #isSaved: boolean;
  readonly #names: readonly RoomName[];

  constructor({ plan, storey, text, isSaved }: NamedStorey) {
    this.rooms = plan.storeys[storey].rooms;
    this.#frame = plan.frame;
    this.#storey = storey;
    this.#isSaved = isSaved;
    this.#names = parseRoomNames(text);
  }

  /** Index of the room at a place, plan metres; −1 where there is none. */
  at(place: Vec2): number {
    return roomAt(this.rooms, place);
  }

  nameOf(index: number): string {
    const given = this.#given(index).at(-1);
    return given?.name ?? (this.#isSaved ? this.rooms[index].name : automaticName(index));
  }

  /** The parameter with a room called otherwise; without a name it is called as before anyone named it. */
  with(index: number, name: string): string {
    const given = this.#given(index);
    const others = this.#names.filter((entry) => !given.includes(entry));
    const isAutomatic = name === '' || name === automaticName(index);
    // What a saved plan calls its room by itself is not known any more, so that a number takes a name's place.
    if (isAutomatic && !this.#isSaved) return formatRoomNames(others);
    const [x, y] = given.length > 0 ? [given[0].x, given[0].y] : this.placeOf(index);
    const called = isAutomatic ? automaticName(index) : name;
    return formatRoomNames([...others, { x, y, storey: this.#storey, name: called }]);
  }

  /** Where a room has most space: source units and coordinates. */
  placeOf(index: number): Vec2 {
    const [x, y] = labelPoint(this.rooms[index].outline);
    const to = sourceCoordinates(this.#frame, WRITTEN);
    return [Number(to.x(x).toFixed(to.digits)), Number(to.y(y).toFixed(to.digits))];
  }

  /** What the parameter says of a room; the last counts. */
  #given(index: number): readonly RoomName[] {
    return this.#names.filter(
      ({ x, y, storey }) => storey === this.#storey && this.at(planPlace(this.#frame, x, y)) === index,
    );
  }
}
