import { boundsOf, pointInPolygon, pointInRing, ringsOf } from '../../geometry/rings.ts';
import { distanceToRing } from '../../secondary/structure.ts';
import type { PointCloud, Polygon, Room, SecondaryBoundary } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import type { LocalCeiling } from '../columns/local-ceiling.ts';

/** Points nearer to a wall than so many deviations of its points, or than this, m, are its own, its skirting or its pictures. */
const WALL_DEVIATIONS = 3;
const LEAST_OFF_WALL = 0.05;
/** Points this near to the ceiling are its own, its lamps or its coving, m. */
const OFF_CEILING = 0.12;
/** Walls are seen up to this below the ceiling, m, its own noise and a step between points left out. */
const SHORT = 0.15;
/** What is no higher than this is a threshold, a carpet or the noise of the floor, m. */
const LEAST_HEIGHT = 0.1;
/** What begins higher than this hangs, m: plans are cut about here, and lamps, shelves and hoods are above. */
const HIGHEST_FOOT = 1.2;

/** What stands in the rooms of a storey, column by column. */
export interface StandingPoints {
  readonly columns: HeightColumns;
  /** Room that each column's points stand in; −1 where nothing does. */
  readonly room: Int32Array;
  /** Height of the highest of them above the floor, m. */
  readonly top: Float32Array;
  /** 1 where they stop short of the ceiling, or of what hangs over the column. */
  readonly isShort: Uint8Array;
  /** Their x, y, m, column by column. */
  readonly xy: Float64Array;
  /** First point of each column; one entry more than columns. */
  readonly start: Uint32Array;
}

/** The rooms of a storey and what was seen of them. */
export interface FurnishedRooms {
  readonly cloud: PointCloud;
  readonly columns: HeightColumns;
  readonly ceiling: LocalCeiling;
  readonly rooms: readonly Room[];
  readonly secondary: readonly SecondaryBoundary[];
  /** Standard deviation of points across a wall's face, m. */
  readonly noise: number;
}

/** The points between floor and ceiling that stand in rooms, off their walls. O(points + columns · vertices of a room). */
export function standingPoints(site: FurnishedRooms): StandingPoints {
  const { cloud, columns, ceiling, noise } = site;
  const { positions } = cloud;
  const { count, table, size, heights, overhead } = columns;
  const off = Math.max(LEAST_OFF_WALL, WALL_DEVIATIONS * noise);
  const room = new Int32Array(count).fill(-1);
  const top = new Float32Array(count);
  const isShort = new Uint8Array(count);
  const start = new Uint32Array(count + 1);
  const found: number[] = [];
  const insides = roomOfColumns(site);
  for (let c = 0; c < count; c++) {
    start[c + 1] = found.length / 2;
    const owner = insides[c];
    if (owner < 0) continue;
    const [ix, iy] = table.coordinatesOf(c);
    const [x, y] = [(ix + 0.5) * size, (iy + 0.5) * size];
    const over = Number.isNaN(overhead[c]) ? ceiling.at(x, y) : overhead[c];
    const isOffWall = offWall(site.rooms[owner].outline, [x, y], { off, reach: size });
    let [lowest, highest, end] = [Infinity, -Infinity, -Infinity];
    for (let k = columns.start[c]; k < columns.start[c + 1]; k++) {
      const [px, py, pz] = positions.subarray(3 * columns.points[k], 3 * columns.points[k] + 3);
      end = Math.max(end, pz);
      if (pz > over - OFF_CEILING || !isOffWall(px, py)) continue;
      [lowest, highest] = [Math.min(lowest, pz), Math.max(highest, pz)];
      found.push(px, py);
    }
    const isStanding = highest >= heights.floor + LEAST_HEIGHT && lowest <= heights.floor + HIGHEST_FOOT;
    if (isStanding)
      [room[c], top[c], isShort[c]] = [owner, highest - heights.floor, end < over - SHORT ? 1 : 0];
    else found.length = 2 * start[c + 1];
    start[c + 1] = found.length / 2;
  }
  return { columns, room, top, isShort, xy: Float64Array.from(found), start };
}

/** The room that the middle of each column with points between floor and ceiling is in; −1 for none, and for structures'. */
function roomOfColumns({ columns, rooms, secondary }: FurnishedRooms): Int32Array {
  const { table, size, count } = columns;
  const isOfStructure = (x: number, y: number) =>
    secondary.some(
      ({ outline: { outer } }) =>
        pointInRing(x, y, outer) >= 0 || distanceToRing(x, y, outer) < LEAST_OFF_WALL + size / 2,
    );
  const owner = new Int32Array(count).fill(-1);
  rooms.forEach(({ outline }, r) => {
    const { minX, minY, maxX, maxY } = boundsOf(outline.outer);
    for (let iy = Math.floor(minY / size); iy * size <= maxY; iy++) {
      for (let ix = Math.floor(minX / size); ix * size <= maxX; ix++) {
        const c = table.find(ix, iy, 0);
        if (c < 0 || columns.start[c] === columns.start[c + 1]) continue;
        const [x, y] = [(ix + 0.5) * size, (iy + 0.5) * size];
        if (pointInPolygon(x, y, outline) > 0 && !isOfStructure(x, y)) owner[c] = r;
      }
    }
  });
  return owner;
}

/** Whether a point of a column around a place is in a room and off its walls; told without a look at it where all are. */
function offWall(
  room: Polygon,
  [x, y]: readonly [x: number, y: number],
  { off, reach }: { off: number; reach: number },
): (x: number, y: number) => boolean {
  const away = (px: number, py: number) =>
    Math.min(...ringsOf([room]).map((ring) => distanceToRing(px, py, ring)));
  const distance = away(x, y);
  if (distance > off + reach) return () => true;
  if (distance < off - reach) return () => false;
  return (px, py) => away(px, py) > off && pointInPolygon(px, py, room) > 0;
}
