import type { Slice } from '../types.ts';
import { groupPoints } from './point-groups.ts';
import type { WallFaces } from './wall-faces.ts';

/** Cells are this many mean spacings wide: points one to two cells apart hang together. */
const CELL_SPACINGS = 4;
/** Clear of the walls, faces of one structure may stand this many times further apart. */
const STRUCTURE_CELLS = 3;
/** Cells this many times finer tell a structure from the stray points that tie it to a wall. */
const FINER_CELLS = 2;
/** What comes nearer to a wall than so many spacings may hang together with it. */
const TOUCH_SPACINGS = 3;

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
  for (const members of groupPoints(xy, off, cell)) {
    if (touches(members, xy, spacing, faces)) groups.push({ members, place: 'touching' });
    else for (const i of members) clear.push(i);
  }
  for (const members of groupPoints(xy, Uint32Array.from(clear), STRUCTURE_CELLS * cell)) {
    groups.push({ members, place: 'clear' });
  }
  return groups;
}

/**
 * What hangs together more closely within a group that touches a wall, and is tied to the rest by nothing but points near
 * the wall: a piece of a wall that leads into the room is not.
 */
export function cutGroup(
  { members }: OffWallGroup,
  { xy, spacing }: Slice,
  faces: WallFaces,
): OffWallGroup[] {
  const parts = groupPoints(xy, members, (CELL_SPACINGS / FINER_CELLS) * spacing);
  const partOf = new Map<number, Uint32Array>();
  for (const part of parts) for (const i of part) partOf.set(i, part);
  const off = members.filter((i) => !isNearWall(i, xy, spacing, faces));
  const tied = new Set<Uint32Array>();
  for (const together of groupPoints(xy, off, CELL_SPACINGS * spacing)) {
    const joined = new Set(Array.from(together, (i) => partOf.get(i)!));
    if (joined.size > 1) for (const part of joined) tied.add(part);
  }
  return parts
    .filter((part) => !tied.has(part))
    .map((part) => ({ members: part, place: touches(part, xy, spacing, faces) ? 'touching' : 'cut' }));
}

function touches(members: Uint32Array, xy: Float64Array, spacing: number, faces: WallFaces): boolean {
  return members.some((i) => isNearWall(i, xy, spacing, faces));
}

function isNearWall(i: number, xy: Float64Array, spacing: number, { reach, heightAt }: WallFaces): boolean {
  return heightAt(xy[2 * i], xy[2 * i + 1]) <= reach + TOUCH_SPACINGS * spacing;
}
