import { connectedColumns } from '../columns/connected-columns.ts';
import { columnAt, type HeightColumns } from '../columns/height-columns.ts';
import type { SeenSpace } from '../columns/seen-space.ts';
import { columnDirections } from '../faces/column-directions.ts';
import { alongOf, asideOf, endsOf, isParallel, type Line, pointOn } from '../faces/face.ts';
import { type FaceSupport, STEP, TAKEN_SHARE } from '../faces/face-support.ts';
import type { FreeColumns } from '../faces/free-columns.ts';
import { growLine } from '../faces/grow-line.ts';
import type { FoundRooms, WallFace, WallFaces } from './found-rooms.ts';
import { columnFaces } from './label-space.ts';

/** Space of no room is a lost room from this area on, m²: less is a reveal, or what was seen through a door. */
const SMALLEST_ROOM = 4;
/** A ceiling ends where none was seen for so far beyond, m: the rows of a scanner far off are nearer to each other. */
const BEYOND = 0.4;
/** Shortest front, m. */
const SHORTEST = 1;
/** A front that runs so near a wall already known, m, is that. */
const SAME_WALL = 0.15;
/** Its frames lie no farther from the ceiling's edge, m, within the wall's reveal or outside … */
const REVEAL = 0.4;
/** … in a line along so much of it: a sill, or what a pane sends back … */
const SEEN_SHARE = 0.5;
/** … or posts, which fill so much of the storey's height, the first and the last so much of its length apart. */
const POST_HEIGHT = 0.5;
const POSTS_APART = 0.5;
/** Share of the points of a ceiling's last columns that lie within its edge: the others are noise. */
const WITHIN_EDGE = 0.95;
/** A front is drawn on past its ends, m, to the walls there: far from a scanner the end of a ceiling's edge frays. */
const REACH = 2;
/** … and stands so far past them, m. */
const OVERLAP = 0.3;

/**
 * Fronts of glass: where walls do not bound what was seen, lines along which its ceiling ends and frames or panes were seen.
 *
 * A front without lintel or parapet is no face that stands: rays go through it. Looked for only where space that is as
 * large as a room is in none. O(columns).
 */
export function glassFronts(
  found: FoundRooms,
  walls: WallFaces,
  columns: HeightColumns,
  seen: SeenSpace,
): WallFaces {
  const lost = lostCeilings(found, columns, seen);
  if (lost.length === 0) return { faces: [], supports: [] };
  const isFree = edgeOf(columns, lost);
  const edges = { ...columns, centres: columns.overCentres, hits: new Uint8Array(columns.count).fill(1) };
  const { angle, support } = columnDirections(edges, isFree);
  const free: FreeColumns = { columns: edges, angle, isFree };
  const seeds = lost.filter((c) => isFree[c] === 1 && support[c] > 0);
  seeds.sort((a, b) => support[b] - support[a] || a - b);
  const lines: Line[] = [];
  for (const seed of seeds) {
    const line = isFree[seed] === 1 ? growLine(free, seed) : null;
    if (!line || lengthOf(line) < SHORTEST) continue;
    for (const c of line.members) isFree[c] = 0;
    lines.push(line);
  }
  const faces: WallFace[] = [];
  for (const line of lines.sort((p, q) => lengthOf(q) - lengthOf(p))) {
    const edge = atCeilingsEdge(line, columns);
    if (edge === null || isKnown(edge, walls)) continue;
    const at = faces.findIndex((face) => isInLine(edge, face));
    if (at >= 0) faces[at] = drawnOnTo(faces[at], edge);
    else {
      const front = atFrame(edge, columns);
      if (front && !isKnown(front, walls)) faces.push(front);
    }
  }
  return { faces, supports: faces.map(supportOf) };
}

const lengthOf = ({ from, to }: Line): number => to - from;

/** Whether a ceiling's edge goes on that of a front: where few points of it were seen it frays. */
function isInLine(edge: Line, front: Line): boolean {
  if (endsOf(edge).some(([x, y]) => Math.abs(asideOf(front, x, y)) > REVEAL)) return false;
  const [from, to] = placesOn(front, edge);
  return Math.max(from - front.to, front.from - to) <= REACH;
}

function drawnOnTo(front: WallFace, edge: Line): WallFace {
  const [from, to] = placesOn(front, edge);
  return { ...front, from: Math.min(front.from, from), to: Math.max(front.to, to) };
}

/** Where along a line the ends of another are, m, the lower first. */
function placesOn(line: Line, other: Line): [number, number] {
  const [a, b] = endsOf(other).map((end) => alongOf(line, ...end));
  return [Math.min(a, b), Math.max(a, b)];
}

/** Columns with a ceiling that hang together in no room, of areas as large as one. */
function lostCeilings(
  { arrangement, rooms }: FoundRooms,
  columns: HeightColumns,
  { isSeen }: SeenSpace,
): number[] {
  const { count, overhead, size } = columns;
  const isHeld = new Uint8Array(arrangement.areas.length);
  for (const { faces } of rooms) for (const f of faces) isHeld[f] = 1;
  const owner = columnFaces(arrangement, columns);
  const isLost = Uint8Array.from({ length: count }, (_, c) =>
    !Number.isNaN(overhead[c]) && (owner[c] < 0 || isHeld[owner[c]] === 0) ? 1 : 0,
  );
  const lost: number[] = [];
  for (let seed = 0; seed < count; seed++) {
    if (isLost[seed] === 0) continue;
    isLost[seed] = 0;
    const region = connectedColumns(columns, seed, 1, (c) => {
      if (isLost[c] === 0) return false;
      isLost[c] = 0;
      return true;
    });
    const area = region.filter((c) => isSeen[c] === 1).length * size ** 2;
    if (area >= SMALLEST_ROOM) for (const c of region) lost.push(c);
  }
  return lost;
}

/** Marks the columns at which a ceiling ends. */
function edgeOf({ table, count, size, overhead }: HeightColumns, region: readonly number[]): Uint8Array {
  const isEdge = new Uint8Array(count);
  const reach = Math.round(BEYOND / size);
  const isBare = (ix: number, iy: number, dx: number, dy: number) => {
    for (let k = 1; k <= reach; k++) {
      const c = table.find(ix + k * dx, iy + k * dy, 0);
      if (c >= 0 && !Number.isNaN(overhead[c])) return false;
    }
    return true;
  };
  for (const c of region) {
    const [ix, iy] = table.coordinatesOf(c);
    const ends =
      isBare(ix, iy, 1, 0) || isBare(ix, iy, -1, 0) || isBare(ix, iy, 0, 1) || isBare(ix, iy, 0, -1);
    isEdge[c] = ends ? 1 : 0;
  }
  return isEdge;
}

/** A line through the last columns of a ceiling, at its very edge, its normal pointing out; null where it ends to neither side. */
function atCeilingsEdge(line: Line, columns: HeightColumns): WallFace | null {
  const ceilings = [1, -1].map((side) => {
    let count = 0;
    for (let along = line.from; along < line.to; along += columns.size) {
      const c = columnAt(columns, ...pointOn(line, along, side * (BEYOND / 2)));
      if (c >= 0 && !Number.isNaN(columns.overhead[c])) count++;
    }
    return count;
  });
  if (ceilings[0] === ceilings[1]) return null;
  const side = ceilings[0] < ceilings[1] ? 1 : -1;
  const outward = { nx: side * line.nx, ny: side * line.ny, offset: side * line.offset };
  const asides = line.members.map((c) =>
    asideOf(outward, columns.overCentres[2 * c], columns.overCentres[2 * c + 1]),
  );
  const edge = asides.sort((a, b) => a - b)[Math.floor(WITHIN_EDGE * (asides.length - 1))] + columns.size / 2;
  const [from, to] = side > 0 ? [line.from, line.to] : [-line.to, -line.from];
  return {
    ...outward,
    offset: outward.offset + edge,
    from,
    to,
    members: [],
    noise: columns.size / 2,
    support: 0,
    reach: REACH,
  };
}

/** The outermost line beside a ceiling's edge in which a sill, a pane or posts were seen; null where none were: the edge of a view. */
function atFrame(edge: WallFace, columns: HeightColumns): WallFace | null {
  for (let across = REVEAL; across >= -REVEAL; across -= columns.size / 2) {
    const line = { ...edge, offset: edge.offset + across };
    const place = placeOfFrame(line, columns);
    if (place !== null) return { ...line, offset: line.offset + place };
  }
  return null;
}

/** How far off a line a frame along it was seen, m; null where there is none. */
function placeOfFrame(line: Line, columns: HeightColumns): number | null {
  const { from, to } = line;
  const { hits, bins, centres } = columns;
  let [bits, seen, first, last, asides] = [0, 0, to, from, 0];
  for (let along = from; along < to; along += STEP) {
    bits++;
    const c = columnAt(columns, ...pointOn(line, along));
    if (c < 0 || hits[c] === 0) continue;
    seen++;
    asides += asideOf(line, centres[2 * c], centres[2 * c + 1]);
    if (hits[c] < POST_HEIGHT * bins) continue;
    first = Math.min(first, along);
    last = along;
  }
  const isFrame = seen >= SEEN_SHARE * bits || last - first >= POSTS_APART * (to - from);
  return isFrame ? asides / seen : null;
}

function isKnown(front: Line, { faces }: WallFaces): boolean {
  return faces.some((face) => {
    if (!isParallel(front, face)) return false;
    if (endsOf(front).some(([x, y]) => Math.abs(asideOf(face, x, y)) > SAME_WALL)) return false;
    const [low, high] = placesOn(face, front);
    return Math.min(high, face.to) - Math.max(low, face.from) > (high - low) / 2;
  });
}

function supportOf({ from, to }: Line): FaceSupport {
  const count = Math.ceil((to - from + 2 * REACH) / STEP);
  const past = Math.round((REACH - OVERLAP) / STEP);
  return {
    from: from - REACH,
    step: STEP,
    shares: new Float64Array(count).fill(TAKEN_SHARE, past, count - past),
    isSeen: new Uint8Array(count),
    ceiling: new Float64Array(count).fill(Number.NaN),
  };
}
