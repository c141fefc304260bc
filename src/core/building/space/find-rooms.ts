import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import type { LocalCeiling } from '../columns/local-ceiling.ts';
import { type SeenSpace, seenSpace } from '../columns/seen-space.ts';
import { chordsOf, tieOf } from '../faces/chords.ts';
import { alongOf, endsOf, type Face, type FaceSite } from '../faces/face.ts';
import { type FaceSupport, supportAlong, TAKEN_SHARE, WALL_SHARE } from '../faces/face-support.ts';
import { findFaces } from '../faces/find-faces.ts';
import { settleFaces } from '../faces/settle-faces.ts';
import { type Arrangement, arrange } from './arrangement.ts';
import { endedAtWalls, withCurves } from './curved-walls.ts';
import { RETURN_LINE, type Segment } from './cut-segments.ts';
import type { FoundRooms, WallFace, WallFaces } from './found-rooms.ts';
import { glassFronts } from './glass-fronts.ts';
import { labelSpace } from './label-space.ts';
import { missingBacks } from './missing-backs.ts';
import { withoutNecks } from './necks.ts';
import { takenSupport } from './taken-walls.ts';
import { traceRooms } from './trace-rooms.ts';
import { type EndSite, wallEnds } from './wall-ends.ts';
import { withoutWardrobes } from './wardrobes.ts';

/** How far faces are drawn on past their ends to meet others, m: a wall hidden behind a cupboard or two. */
const REACH = 5;
/** Faces that stand as walls over less of what was seen of them are furniture or reveals … */
const LEAST_WALL_SHARE = 0.5;
/** … but what ends below the ceiling does not count where the rest is so long in one, m: cupboards in line with a wall. */
const LEAST_WALL = 0.6;

/** Rooms that hold less than this share of the floor or ceiling seen are no plan of it. */
const LEAST_HELD = 0.5;

/** The rooms of a storey; none where walls and space seen do not agree. */
export function findRooms(cloud: PointCloud, columns: HeightColumns, ceiling: LocalCeiling): FoundRooms {
  const seen = seenSpace(columns);
  const standing = wallFaces({ cloud, columns, ceiling });
  const site: EndSite = { cloud, columns, seen };
  const bare = subdivide(standing, site);
  const fronts = glassFronts(bare, standing, columns, seen);
  const walls = joined(standing, fronts);
  const first = fronts.faces.length === 0 ? bare : subdivide(walls, site);
  const bared = withoutWardrobes(walls, first, seen);
  const second = bared === walls ? first : subdivide(bared, site);
  const backs = missingBacks(second, bared, site);
  const found = backs.faces.length === 0 ? second : subdivide(joined(bared, backs), site);
  return holdWhatWasSeen(found, columns, seen) ? found : { ...found, rooms: [] };
}

/** Whether the rooms are a plan of what was scanned, not chance shapes between stray walls. */
function holdWhatWasSeen(
  { rooms, space }: FoundRooms,
  { size }: HeightColumns,
  { isSeen }: SeenSpace,
): boolean {
  let [all, held] = [0, 0];
  for (const seen of isSeen) all += seen * size * size;
  for (const { faces } of rooms) for (const f of faces) held += space.seen[f];
  return held >= LEAST_HELD * all;
}

function wallFaces(site: FaceSite): WallFaces {
  const { cloud, columns } = site;
  const { straight, curved } = findFaces(site);
  const stands = (group: readonly WallFace[]): WallFaces | null => {
    const supports = group.map((face) => supportAlong(site, face, face.reach));
    return standsAsWall(supports) ? { faces: group, supports } : null;
  };
  const lines = settleFaces(cloud, columns, straight).map((face) => [{ ...face, reach: REACH }]);
  const none: WallFaces = { faces: [], supports: [] };
  const walls = lines.reduce((all, group) => joined(all, stands(group) ?? none), none);
  const curves = chordsOf(columns, curved).map((chords) => chords.map((face) => ({ ...face, reach: 0 })));
  const ended = curves.map((chords) => (chords[0]?.arc ? endedAtWalls(chords, walls) : chords));
  return ended.reduce((all, group) => joined(all, stands(group) ?? none), walls);
}

/** Whether a face stands as a wall where it was seen. */
function standsAsWall(supports: readonly FaceSupport[]): boolean {
  let [wall, any, seen, run, longest] = [0, 0, 0, 0, 0];
  for (const { shares, isSeen, step } of supports) {
    for (const [k, share] of shares.entries()) {
      seen += isSeen[k];
      if (share > 0) any++;
      if (share >= WALL_SHARE) wall++;
      run = share >= WALL_SHARE ? run + step : 0;
      longest = Math.max(longest, run);
    }
  }
  if (wall === 0 || wall < LEAST_WALL_SHARE * any) return false;
  return longest >= LEAST_WALL || wall >= LEAST_WALL_SHARE * seen;
}

function joined(a: WallFaces, b: WallFaces): WallFaces {
  return { faces: [...a.faces, ...b.faces], supports: [...a.supports, ...b.supports] };
}

function subdivide({ faces, supports }: WallFaces, site: EndSite): FoundRooms {
  const { columns, seen } = site;
  const segments = faces.map((face, line) => segmentOf(face, line));
  const ties = faces.flatMap((face, line) => (face.reach === 0 ? [{ ...tieOf(face), line }] : []));
  const taken = takenSupport(faces, supports, seen);
  const ends = wallEnds({ faces, supports }, taken, site);
  const arrangement = arrange([...segments, ...ties, ...ends]);
  const support = edgeSupport(arrangement, faces, withCurves(faces, taken, seen));
  const space = labelSpace(arrangement, columns, seen, support);
  const curves = [...new Set(faces.flatMap(({ arc }) => arc ?? []))];
  const rooms = traceRooms(arrangement, space.isRoom, support, curves);
  const found = { faces, arrangement, support, space, curves, rooms };
  const parted = withoutNecks(found);
  if (parted === null) return found;
  return { ...found, ...parted, rooms: traceRooms(arrangement, parted.space.isRoom, parted.support, curves) };
}

function segmentOf(face: WallFace, line: number): Segment {
  const [[ax, ay], [bx, by]] = endsOf(face, face.reach);
  return { ax, ay, bx, by, line };
}

/**
 * Share of wall along each edge: the mean of the best of the faces it lies on.
 *
 * Not taken: bits by how much of them the edge covers (clean rooms 1 → .994, corners at 5 cm .908 → .895: pieces of a few
 * centimetres turn from wall to opening).
 */
function edgeSupport(
  { x, y, origin, lines }: Arrangement,
  faces: readonly Face[],
  supports: readonly FaceSupport[],
): Float64Array {
  return Float64Array.from(lines, (own, e) => {
    const [u, v] = [origin[2 * e], origin[2 * e + 1]];
    let best = 0;
    for (const line of own) {
      if (line === RETURN_LINE) best = Math.max(best, TAKEN_SHARE);
      if (line < 0) continue;
      const { from, step, shares } = supports[line];
      const ends = [u, v].map((p) => (alongOf(faces[line], x[p], y[p]) - from) / step);
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
