import { areaOf, combine, grow } from '../../core/geometry/areas.ts';
import { type Bounds, boundsOf, pointInPolygon } from '../../core/geometry/rings.ts';
import type { Opening, Polygon, Room, Storey, Wall } from '../../core/types.ts';
import { type OpeningBox, openingBoxes } from '../../solid/opening-boxes.ts';
import { filePolygons } from './ifc-shapes.ts';

/** A wall as an element of its own. */
export interface WallPart {
  readonly wall: Wall;
  /** What is left of it beside the structures that are elements themselves; disjoint, as the file holds them. */
  readonly pieces: readonly Polygon[];
  /** Whether it bounds the storey's rooms outwards; absent where no rooms are known. */
  readonly isExternal?: boolean;
}

/** A hole, and what it goes through. */
export interface OpeningPart {
  readonly opening: Opening;
  /** m; above 0. */
  readonly width: number;
  /** Its box, heights above the floor; null where it is off every wall. */
  readonly box: OpeningBox | null;
  /** Indices of the walls it goes through, the one it takes most of first. */
  readonly walls: readonly number[];
}

/** An inner wall ends this near outside the outline at most, m. */
const OUTSIDE = 0.03;
/** An opening's box is this much longer and deeper than the hole to be cut flush; walls touched by that stay whole, m. */
const FLUSH = 3e-3;
/** Less than this of a wall, m², is no part of an opening's way. */
const LEAST_CUT = 1e-4;
/** Doors and passages with a sill up to here interrupt a room's edge on the floor, m. */
const THRESHOLD = 0.05;
/** A room lies this far behind the face of its wall, m. */
const BEHIND_FACE = 0.05;

export function wallParts(storey: Storey): WallPart[] {
  const inside = grow(storey.primary, OUTSIDE);
  const structures = storey.secondary
    .filter(({ operation }) => operation !== 'independent')
    .map(({ outline }) => outline);
  const bounds = structures.map(({ outer }) => boundsOf(outer));
  const knowsOutside = storey.rooms.length > 0 && inside.length > 0;
  return storey.walls.map((wall) => {
    const near = indicesNear(bounds, boundsOf(wall.outline.outer), 0).map((i) => structures[i]);
    const left = near.length === 0 ? [wall.outline] : combine('difference', [wall.outline], near);
    const pieces = left.flatMap(filePolygons);
    return knowsOutside ? { wall, pieces, isExternal: reachesOut(wall.outline, inside) } : { wall, pieces };
  });
}

function reachesOut({ outer }: Polygon, inside: readonly Polygon[]): boolean {
  for (let i = 0; i < outer.length; i += 2) {
    if (inside.every((polygon) => pointInPolygon(outer[i], outer[i + 1], polygon) < 0)) return true;
  }
  return false;
}

/** Openings without width or height are left out. */
export function openingParts(storey: Storey, walls: readonly WallPart[]): OpeningPart[] {
  const bounds = walls.map(({ wall }) => boundsOf(wall.outline.outer));
  const boxes = new Map(openingBoxes(storey).map((box) => [box.number, box]));
  return storey.openings.flatMap((opening, number): OpeningPart[] => {
    const { from, to, sill, head } = opening;
    const width = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (!(width > 0 && head > sill)) return [];
    const found = boxes.get(number);
    if (found === undefined) return [{ opening, width, box: null, walls: [] }];
    const near = indicesNear(bounds, boundsOf(found.base.outer), 0);
    const box = { ...found, low: sill, high: head };
    return [{ opening, width, box, walls: crossed(box, near, walls) }];
  });
}

/** A loop, since every opening asks of every wall. */
function indicesNear(boxes: readonly Bounds[], to: Bounds, distance: number): number[] {
  const near: number[] = [];
  for (let i = 0; i < boxes.length; i++) if (areNear(boxes[i], to, distance)) near.push(i);
  return near;
}

function crossed(box: OpeningBox, near: readonly number[], walls: readonly WallPart[]): number[] {
  const hole = grow([box.base], -FLUSH);
  return near
    .map((i) => ({ i, area: areaOf(combine('intersection', walls[i].pieces, hole)) }))
    .filter(({ area }) => area > LEAST_CUT)
    .sort((a, b) => b.area - a.area || a.i - b.i)
    .map(({ i }) => i);
}

/** What is left of a wall's foot and body once openings are cut; m² and m³. */
export function netOf(
  pieces: readonly Polygon[],
  boxes: readonly OpeningBox[],
  height: number,
): { foot: number; volume: number } {
  const levels = [0, height, ...boxes.flatMap(({ low, high }) => [low, high])]
    .filter((z) => z >= 0 && z <= height)
    .sort((a, b) => a - b);
  let foot: number | null = null;
  let volume = 0;
  for (let k = 1; k < levels.length; k++) {
    if (levels[k] === levels[k - 1]) continue;
    const middle = (levels[k] + levels[k - 1]) / 2;
    const open = boxes.filter(({ low, high }) => low < middle && middle < high).map(({ base }) => base);
    const area = areaOf(open.length === 0 ? pieces : combine('difference', pieces, open));
    foot ??= area;
    volume += area * (levels[k] - levels[k - 1]);
  }
  return { foot: foot ?? areaOf(pieces), volume };
}

/** How much of each room's edge on the floor doors and passages take, m. */
export function doorwayWidths(rooms: readonly Room[], openings: readonly OpeningPart[]): number[] {
  const widths = rooms.map(() => 0);
  const bounds = rooms.map(({ outline }) => boundsOf(outline.outer));
  for (const { opening, box, width } of openings) {
    if (box === null || opening.type === 'window' || opening.sill > THRESHOLD) continue;
    for (const [x, y] of bothSides(box)) {
      const at = rooms.findIndex(
        ({ outline }, i) =>
          areNear(bounds[i], { minX: x, minY: y, maxX: x, maxY: y }, 0) && pointInPolygon(x, y, outline) > 0,
      );
      if (at >= 0) widths[at] += width;
    }
  }
  return widths;
}

/** Places right before and behind a wall, in the middle of an opening; its box is a rectangle along it. */
function bothSides({ base: { outer: b } }: OpeningBox): [x: number, y: number][] {
  const [ax, ay, bx, by] = [(b[0] + b[2]) / 2, (b[1] + b[3]) / 2, (b[4] + b[6]) / 2, (b[5] + b[7]) / 2];
  const depth = Math.hypot(bx - ax, by - ay);
  const [nx, ny] = [((bx - ax) / depth) * BEHIND_FACE, ((by - ay) / depth) * BEHIND_FACE];
  return [
    [ax - nx, ay - ny],
    [bx + nx, by + ny],
  ];
}

export function areNear(a: Bounds, b: Bounds, distance: number): boolean {
  return (
    a.minX - distance <= b.maxX &&
    b.minX - distance <= a.maxX &&
    a.minY - distance <= b.maxY &&
    b.minY - distance <= a.maxY
  );
}
