import { areaOf } from '../../core/geometry/areas.ts';
import { perimeter, pointInPolygon, ringsOf } from '../../core/geometry/rings.ts';
import { oncePer } from '../../core/once-per.ts';
import type { FloorPlan, Opening, Polygon, Room, Storey } from '../../core/types.ts';
import { footprint, unite } from '../../solid/sections.ts';

/** An opening is of the room that begins this far behind the wall's thickness from its axis, m: wherever the axis lies in it. */
const BEHIND = 0.05;

/** One room, as a schedule lists it. */
export interface RoomLine {
  /** From 1, through the building, lowest storey first. */
  readonly number: number;
  readonly storey: number;
  readonly name: string;
  /** Between the inner faces of its walls; with the columns and shafts that stand free in it. */
  readonly areaM2: number;
  /** Along its outline, and around what stands out of it. */
  readonly perimeterM: number;
  readonly heightM: number;
  /** Area times height. */
  readonly volumeM3: number;
  /** Openings that lead into it: one between two rooms counts in each. */
  readonly doors: number;
  readonly windows: number;
  readonly passages: number;
  readonly confidence: number;
}

/** Areas of a storey, or of the building; null where the plan does not tell. */
export interface AreaLine {
  readonly rooms: number;
  readonly netInternalM2: number | null;
  readonly grossInternalM2: number;
  readonly grossExternalM2: number;
  readonly volumeM3: number | null;
  /** Some outer face was seen by no point, so that the gross external area rests on a usual thickness. */
  readonly isPartlyInferred: boolean;
}

/** What each total means, in words for whoever reads the schedule. */
export const AREA_RULES = {
  netInternal:
    'Sum of the rooms: the area between the inner faces of their walls; columns and shafts that stand free in a room are counted with it.',
  grossInternal:
    'Area inside the inner faces of the outer walls: all rooms and the walls between them; courtyards left out.',
  grossExternal: 'Area inside the outer faces of the outer walls; courtyards left out.',
  partlyInferred: 'Where no point shows the outer face of a wall, its thickness is inferred.',
  approximate: 'Measured in a plan that was made of a point cloud: approximate.',
} as const;

/** The rooms of a plan, lowest storey first, in the plan's order. Linear in rooms times openings of a storey. */
export const roomLines = oncePer(({ storeys, options }: FloorPlan): readonly RoomLine[] => {
  const lines = storeys.flatMap((storey) => {
    const touched = storey.openings.map((opening) => ({
      type: opening.type,
      sides: sidesOf(opening, storey, options.wallThickness),
    }));
    return storey.rooms.map((room) => {
      const count = (type: Opening['type']) =>
        touched.filter(
          (opening) => opening.type === type && opening.sides.some((at) => isIn(at, room.outline)),
        ).length;
      return { ...measures(room), storey: storey.index, count };
    });
  });
  return lines.map(({ count, ...line }, i) => ({
    number: i + 1,
    ...line,
    doors: count('door'),
    windows: count('window'),
    passages: count('passage'),
  }));
});

/** The areas of each storey, by rules told in {@link AREA_RULES}. */
export function areaLines({ storeys }: FloorPlan): AreaLine[] {
  return storeys.map((storey) => {
    const { rooms, primary, walls } = storey;
    const lines = rooms.map(measures);
    const isKnown = rooms.length > 0;
    return {
      rooms: rooms.length,
      netInternalM2: isKnown ? sum(lines.map(({ areaM2 }) => areaM2)) : null,
      grossInternalM2: areaOf(unite(primary)),
      grossExternalM2: areaOf(footprint(storey)),
      volumeM3: isKnown ? sum(lines.map(({ volumeM3 }) => volumeM3)) : null,
      // Without rooms, walls are drawn with a pen of one thickness.
      isPartlyInferred: !isKnown || walls.some(({ isThicknessInferred }) => isThicknessInferred === true),
    };
  });
}

function measures({ name, outline, height, confidence }: Room) {
  const areaM2 = areaOf([outline]);
  const perimeterM = sum(ringsOf([outline]).map(perimeter));
  return { name, areaM2, perimeterM, heightM: height, volumeM3: areaM2 * height, confidence };
}

type Place = readonly [x: number, y: number];

/** A place on either side of an opening, behind the wall that it is in. */
function sidesOf({ from, to }: Opening, { walls }: Storey, usual: number): Place[] {
  const [x, y] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length === 0) return [];
  const wall = walls.find(({ outline }) => isIn([x, y], outline));
  const reach = ((wall?.thickness ?? usual) + BEHIND) / length;
  return [
    [x - dy * reach, y + dx * reach],
    [x + dy * reach, y - dx * reach],
  ];
}

const isIn = ([x, y]: Place, polygon: Polygon): boolean => pointInPolygon(x, y, polygon) >= 0;

export function sum(values: readonly number[]): number {
  return values.reduce((total, value) => total + value, 0);
}
