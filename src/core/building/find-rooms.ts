import type { PointCloud } from '../types.ts';
import { type Arrangement, arrange, type Segment } from './arrangement.ts';
import { chordsOf, tieOf } from './chords.ts';
import { type FaceSupport, supportAlong } from './face-support.ts';
import { findFaces } from './find-faces.ts';
import type { Face } from './fit-line.ts';
import type { HeightColumns } from './height-columns.ts';
import { labelSpace, type Space } from './label-space.ts';
import type { LocalCeiling } from './local-ceiling.ts';
import { missingBacks } from './missing-backs.ts';
import { type SeenSpace, seenSpace } from './seen-space.ts';
import { settleFaces } from './settle-faces.ts';
import { takenSupport, WALL_SHARE } from './taken-walls.ts';
import { type RoomFaces, traceRooms } from './trace-rooms.ts';

/** How far faces are drawn on past their ends to meet others, m: a wall hidden behind a cupboard or two. */
const REACH = 5;
/** Faces that stand as walls over less of what was seen of them are furniture or reveals. */
const LEAST_WALL_SHARE = 0.5;

/** A face, and how far it is drawn on past its ends. */
export type WallFace = Face & { readonly reach: number };

export interface FoundRooms {
  readonly faces: readonly WallFace[];
  readonly arrangement: Arrangement;
  readonly support: Float64Array;
  readonly space: Space;
  readonly rooms: readonly RoomFaces[];
}

/** The rooms of a storey. */
export function findRooms(cloud: PointCloud, columns: HeightColumns, ceiling: LocalCeiling): FoundRooms {
  const seen = seenSpace(columns);
  const walls = wallFaces(cloud, columns, ceiling);
  const first = subdivide(walls, columns, seen);
  const backs = missingBacks(first, columns);
  return backs.faces.length === 0 ? first : subdivide(joined(walls, backs), columns, seen);
}

/** Faces that stand as walls, with their support. */
export interface WallFaces {
  readonly faces: readonly WallFace[];
  readonly supports: readonly FaceSupport[];
}

function wallFaces(cloud: PointCloud, columns: HeightColumns, ceiling: LocalCeiling): WallFaces {
  const { straight, curved } = findFaces(cloud, columns);
  const stands = (group: readonly WallFace[]): WallFaces | null => {
    const supports = group.map((face) => supportAlong(cloud, columns, ceiling, face, face.reach));
    return standsAsWall(supports.flatMap(({ shares }) => [...shares])) ? { faces: group, supports } : null;
  };
  const lines = settleFaces(cloud, columns, straight).map((face) => [{ ...face, reach: REACH }]);
  const curves = chordsOf(columns, curved).map((chords) => chords.map((face) => ({ ...face, reach: 0 })));
  const none: WallFaces = { faces: [], supports: [] };
  return [...lines, ...curves].reduce((all, group) => joined(all, stands(group) ?? none), none);
}

function joined(a: WallFaces, b: WallFaces): WallFaces {
  return { faces: [...a.faces, ...b.faces], supports: [...a.supports, ...b.supports] };
}

function subdivide({ faces, supports }: WallFaces, columns: HeightColumns, seen: SeenSpace): FoundRooms {
  const segments = faces.map((face, line) => segmentOf(face, line));
  const ties = faces.flatMap((face, line) => (face.reach === 0 ? [{ ...tieOf(face), line }] : []));
  const arrangement = arrange([...segments, ...ties]);
  const support = edgeSupport(arrangement, faces, takenSupport(faces, supports, seen));
  const space = labelSpace(arrangement, columns, seen.isSeen, support);
  return { faces, arrangement, support, space, rooms: traceRooms(arrangement, space.isRoom, support) };
}

function segmentOf({ nx, ny, offset, from, to, reach }: WallFace, line: number): Segment {
  const [a, b] = [from - reach, to + reach];
  return {
    ax: nx * offset - ny * a,
    ay: ny * offset + nx * a,
    bx: nx * offset - ny * b,
    by: ny * offset + nx * b,
    line,
  };
}

interface Shares {
  readonly from: number;
  readonly step: number;
  readonly shares: Float64Array;
}

function edgeSupport(
  { x, y, origin, lines }: Arrangement,
  faces: readonly Face[],
  supports: readonly Shares[],
): Float64Array {
  return Float64Array.from(lines, (own, e) => {
    const [u, v] = [origin[2 * e], origin[2 * e + 1]];
    let best = 0;
    for (const line of own) {
      const { nx, ny } = faces[line];
      const { from, step, shares } = supports[line];
      const ends = [u, v].map((p) => (y[p] * nx - x[p] * ny - from) / step);
      const [low, high] = [Math.min(...ends), Math.max(...ends)];
      let [sum, count] = [0, 0];
      for (let k = Math.max(0, Math.floor(low)); k <= Math.min(shares.length - 1, Math.floor(high)); k++) {
        sum += shares[k];
        count++;
      }
      if (count > 0) best = Math.max(best, sum / count);
    }
    return best;
  });
}
/** Whether a face stands as a wall where it was seen. */
function standsAsWall(shares: readonly number[]): boolean {
  let [wall, any] = [0, 0];
  for (const share of shares) {
    if (share > 0) any++;
    if (share >= WALL_SHARE) wall++;
  }
  return wall > 0 && wall >= LEAST_WALL_SHARE * any;
}
