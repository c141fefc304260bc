import { boundsOf, pointInRing } from '../geometry/rings.ts';
import type { Ring, Slice } from '../types.ts';
import { groupPoints, pointsOf } from './point-groups.ts';
import { distanceToRing } from './structure.ts';
import type { WallFaces } from './wall-faces.ts';

/** Cells are this many mean spacings wide: points one to two cells apart hang together. */
const CELL_SPACINGS = 4;
/** Clear of the walls, faces of one structure may stand this many times further apart. */
const STRUCTURE_CELLS = 3;
/** Cells this many times finer tell a structure from the stray points that tie it to a wall. */
const FINER_CELLS = 2;
/** What comes nearer to a wall than so many spacings may hang together with it. */
const TOUCH_SPACINGS = 3;
/** Smaller clumps are stray points. */
const FEWEST_IN_CLUMP = 4;

/** Points off the walls that hang together. */
export interface OffWallGroup {
  /** Numbers of its points in the slice. */
  readonly members: Uint32Array;
  /** Whether it stands clear of the walls, touches one, or was cut from what does. */
  readonly place: 'clear' | 'touching' | 'cut';
}

/** Groups of the points that the walls' faces do not explain; of those clear of the walls, parts are joined. O(n). */
export function groupOffWalls({ xy, spacing }: Slice, faces: WallFaces): OffWallGroup[] {
  const all = Uint32Array.from({ length: xy.length / 2 }, (_, i) => i);
  const off = all.filter((i) => faces.heightAt(xy[2 * i], xy[2 * i + 1]) > faces.reach);
  const cell = CELL_SPACINGS * spacing;
  const groups: OffWallGroup[] = [];
  const clear: number[] = [];
  for (const members of partition(xy, off, cell)) {
    if (members.length < FEWEST_IN_CLUMP) continue;
    if (touches(members, xy, spacing, faces)) groups.push({ members, place: 'touching' });
    else for (const i of members) clear.push(i);
  }
  for (const members of partition(xy, Uint32Array.from(clear), STRUCTURE_CELLS * cell)) {
    groups.push({ members, place: 'clear' });
  }
  return groups;
}

/** What hangs together more closely within a group that touches a wall. */
export function cutGroup(
  { members }: OffWallGroup,
  { xy, spacing }: Slice,
  faces: WallFaces,
): OffWallGroup[] {
  return partition(xy, members, (CELL_SPACINGS / FINER_CELLS) * spacing).map((part) => ({
    members: part,
    place: touches(part, xy, spacing, faces) ? 'touching' : 'cut',
  }));
}

/**
 * The points of a structure beside a wall, with those near its outline that may be of either: half as far from the
 * wall's face as its points reach there are hardly any of the wall's.
 */
export function withSharedPoints(
  members: Uint32Array,
  outline: Ring,
  { xy }: Slice,
  faces: WallFaces,
): Uint32Array {
  const isMember = new Uint8Array(xy.length / 2);
  for (const i of members) isMember[i] = 1;
  const { minX, minY, maxX, maxY } = boundsOf(outline);
  const { reach } = faces;
  return Uint32Array.from(isMember.keys()).filter((i) => {
    if (isMember[i] === 1) return true;
    const [x, y] = [xy[2 * i], xy[2 * i + 1]];
    if (x < minX - reach || x > maxX + reach || y < minY - reach || y > maxY + reach) return false;
    const height = faces.heightAt(x, y);
    if (height <= reach / 2 || height > reach) return false;
    return pointInRing(x, y, outline) > 0 || distanceToRing(x, y, outline) <= reach;
  });
}

function touches(members: Uint32Array, xy: Float64Array, spacing: number, faces: WallFaces): boolean {
  const touch = faces.reach + TOUCH_SPACINGS * spacing;
  return members.some((i) => faces.heightAt(xy[2 * i], xy[2 * i + 1]) <= touch);
}

/** The points numbered, parted into what hangs together. */
function partition(xy: Float64Array, numbers: Uint32Array, cell: number): Uint32Array[] {
  const { start, members } = groupPoints(pointsOf(xy, numbers), cell);
  return Array.from({ length: start.length - 1 }, (_, group) =>
    members.subarray(start[group], start[group + 1]).map((k) => numbers[k]),
  );
}
