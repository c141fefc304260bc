import { inset, type Ring } from '../../fixtures/simulator/ring.ts';
import { PAPER_SLICES, type PaperSliceName, paperSlice } from '../../fixtures/simulator/slices.ts';
import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import type { Options } from '../../src/core/params.ts';
import type { StageResults } from '../../src/core/stage-results.ts';
import type { Frame, Polygon } from '../../src/core/types.ts';
import { blobSource } from '../../src/read/bytes/blob-source.ts';
import { Session } from '../../src/session/session.ts';
import { type Region, regionOf, unite } from '../accuracy/regions.ts';

/** What [Stojanovic19] §4 tells of each of its six sets; its points are not published. */
export interface PaperSet {
  readonly name: PaperSliceName;
  /** The paper's own name. */
  readonly label: string;
  readonly points: number;
  readonly what: string;
  readonly isRoom: boolean;
  /** Of the paper's mesh, where it tells. */
  readonly mesh?: { readonly vertices: number; readonly faces: number };
}

export const PAPER_SETS: readonly PaperSet[] = [
  {
    name: 'hallway-1',
    label: 'Hallway_1',
    points: 1799,
    what: 'corridor that turns through a curved wall',
    isRoom: false,
    mesh: { vertices: 137_106, faces: 45_702 },
  },
  {
    name: 'hallway-2',
    label: 'Hallway_2',
    points: 1630,
    what: 'straight corridors with square elements',
    isRoom: false,
    mesh: { vertices: 93_204, faces: 31_068 },
  },
  {
    name: 'room-1a',
    label: 'Room_1a',
    points: 628,
    what: 'room with a hollow square structure',
    isRoom: true,
    mesh: { vertices: 34_386, faces: 11_462 },
  },
  {
    name: 'room-1b',
    label: 'Room_1b',
    points: 605,
    what: 'room with a hollow square structure, turned',
    isRoom: true,
  },
  {
    name: 'room-2',
    label: 'Room_2',
    points: 492,
    what: 'room with a curved wall and a curved, hollow structure',
    isRoom: true,
    mesh: { vertices: 45_102, faces: 15_034 },
  },
  {
    name: 'room-3',
    label: 'Room_3',
    points: 238,
    what: 'small room with a small hollow structure',
    isRoom: true,
  },
];

export const HALLWAYS = PAPER_SETS.filter(({ isRoom }) => !isRoom);
export const ROOMS = PAPER_SETS.filter(({ isRoom }) => isRoom);

/** The paper's canvas pixels a metre. */
const PIXELS_PER_METRE = 100;

/** The true areas of a set, metres, origin of its file. */
export interface TrueRegions {
  readonly primary: Region;
  /** Outer and inner face of the hollow structure; none in a hallway. */
  readonly outerFace: Region | null;
  readonly innerFace: Region | null;
}

export function trueRegions(name: PaperSliceName): TrueRegions {
  const region = (ring: Ring) =>
    regionOf([ring.map(([x, y]) => [x / PIXELS_PER_METRE, y / PIXELS_PER_METRE])]);
  const [outerFace = null, innerFace = null] = structureFaces(name).map(region);
  return { primary: region(paperSlice(name).primary), outerFace, innerFace };
}

/** Outer and inner face of a room's hollow structure, px; none in a hallway. */
export function structureFaces(name: PaperSliceName): readonly Ring[] {
  const { structure } = PAPER_SLICES[name] as { structure?: { ring: Ring; thickness: number } };
  return structure ? [structure.ring, inset(structure.ring, structure.thickness)] : [];
}

/** A set as the file the paper's export gives: two columns, canvas pixels. */
function sliceFile(name: PaperSliceName): string {
  const { xy } = paperSlice(name);
  const rows = Array.from(
    { length: xy.length / 2 },
    (_, i) => `${xy[2 * i].toFixed(3)},${xy[2 * i + 1].toFixed(3)}`,
  );
  return `x,y\n${rows.join('\n')}\n`;
}

/** The whole chain on a set, through the door that app and command use; the paper's preset unless told otherwise. */
export async function runSet(
  { name, isRoom }: PaperSet,
  given: Partial<Options> = {},
): Promise<StageResults> {
  const session = new Session({ strokeTest: createStrokeTest() });
  const file = blobSource(new Blob([sliceFile(name)]), `${name}.csv`);
  await session.load(file, { preset: 'paper', secondaryCount: isRoom ? 1 : 0, ...given });
  return session.evidence as StageResults;
}

/** The areas inside the outer rings of polygons in the plan frame, united; metres, origin of the file. */
export function filledRegion(polygons: readonly Polygon[], frame: Frame): Region {
  const [east, north] = [0, 1].map((axis) => frame.planOrigin[axis] * frame.metresPerUnit);
  return unite(
    polygons.map(({ outer }) =>
      regionOf([
        Array.from({ length: outer.length / 2 }, (_, i) => [outer[2 * i] + east, outer[2 * i + 1] + north]),
      ]),
    ),
  );
}
