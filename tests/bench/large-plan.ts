import { resolveOptions } from '../../src/core/options.ts';
import type { FloorPlan, Opening, Polygon, Room, SecondaryBoundary, Wall } from '../../src/core/types.ts';

/** A storey of rooms in a grid: 25 × 20 rooms of 5 m × 4 m from wall to wall. */
const COLUMNS = 25;
const ROWS = 20;
const WIDTH = 5;
const DEPTH = 4;
const THICKNESS = 0.2;
/** Every wall between two crossings is so many pieces, the first so many of them one less: 5,000 in all. */
const PIECES = 5;
const SHORTER = 225;
const HEIGHT = 2.8;
/** Every so manieth room has a column. */
const COLUMN_EVERY = 5;
const UTM = [691_000.123, 5_334_000.765, 512.5] as const;

/** A plan of 500 rooms and 5,000 walls with a door in every row of rooms, windows all around and 100 columns, at UTM. */
export function largePlan(): FloorPlan {
  const primary = rectangle(
    -THICKNESS / 2,
    -THICKNESS / 2,
    COLUMNS * WIDTH + THICKNESS,
    ROWS * DEPTH + THICKNESS,
  );
  return {
    version: 1,
    source: { name: 'large.ply', format: 'ply', bytes: 1, pointsRead: 1, pointsDropped: 0, pointsKept: 1 },
    frame: {
      ...{ origin: UTM, planOrigin: UTM, rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1] },
      ...{ metresPerUnit: 1, unit: 'm', up: 'z', tilt: 0, crs: 'EPSG:25832' },
    },
    options: resolveOptions({}),
    storeys: [
      {
        ...{ index: 0, floor: 0, height: HEIGHT, primary: [primary], gaps: [] },
        ...{ walls: walls(), rooms: rooms(), openings: openings(), secondary: columns() },
      },
    ],
    warnings: [],
  };
}

/** Points every so far, m, along the inner faces: what the outline of such a plan is found from. */
export function sliceOf({ storeys: [{ rooms: all }] }: FloorPlan, spacing: number): Float64Array {
  const xy: number[] = [];
  for (const { outline } of all) {
    const [x0, y0, x1, , , y1] = outline.outer;
    for (let x = x0; x < x1; x += spacing) xy.push(x, y0, x, y1);
    for (let y = y0; y < y1; y += spacing) xy.push(x0, y, x1, y);
  }
  return Float64Array.from(xy);
}

const rectangle = (x: number, y: number, width: number, depth: number): Polygon => ({
  outer: Float64Array.of(x, y, x + width, y, x + width, y + depth, x, y + depth),
  holes: [],
});

const cells = <T>(columns: number, rows: number, make: (c: number, r: number) => T): T[] =>
  Array.from({ length: columns * rows }, (_, i) => make(i % columns, Math.floor(i / columns)));

/** Walls along x run through the crossings, those along y stand between them. */
function walls(): Wall[] {
  const half = THICKNESS / 2;
  const along = cells(COLUMNS, ROWS + 1, (c, r) => {
    const [from, to] = [c === 0 ? -half : c * WIDTH, (c + 1) * WIDTH + (c === COLUMNS - 1 ? half : 0)];
    return { x: from, y: r * DEPTH - half, width: to - from, depth: THICKNESS };
  });
  const across = cells(COLUMNS + 1, ROWS, (c, r) => ({
    ...{ x: c * WIDTH - half, y: r * DEPTH + half, width: THICKNESS, depth: DEPTH - THICKNESS },
  }));
  return [...along, ...across].flatMap(({ x, y, width, depth }, k) => {
    const count = k < SHORTER ? PIECES - 1 : PIECES;
    return Array.from({ length: count }, (_, i): Wall => {
      const outline =
        width > depth
          ? rectangle(x + (i * width) / count, y, width / count, depth)
          : rectangle(x, y + (i * depth) / count, width, depth / count);
      return { outline, thickness: THICKNESS, confidence: 0.9 };
    });
  });
}

const rooms = (): Room[] =>
  cells(COLUMNS, ROWS, (c, r) => ({
    name: `Room ${r * COLUMNS + c + 1}`,
    outline: rectangle(
      ...([c * WIDTH + THICKNESS / 2, r * DEPTH + THICKNESS / 2] as const),
      ...([WIDTH - THICKNESS, DEPTH - THICKNESS] as const),
    ),
    ...{ height: HEIGHT, confidence: 0.9 },
  }));

/** No two are measured alike: every opening has a height of its own. */
function openings(): Opening[] {
  let measured = 0;
  const opening = (type: Opening['type'], x: number, y: number, width: number): Opening => ({
    ...{ type, from: [x, y], to: [x + width, y], confidence: 0.8 },
    ...{ sill: type === 'door' ? 0 : 0.9, head: 2.1 + measured++ * 1e-5 },
  });
  const doors = cells(COLUMNS, ROWS - 1, (c, r) => opening('door', c * WIDTH + 1, (r + 1) * DEPTH, 0.9));
  const windows = cells(COLUMNS, 2, (c, r) => opening('window', c * WIDTH + 1.5, r * ROWS * DEPTH, 2));
  return [...doors, ...windows];
}

const columns = (): SecondaryBoundary[] =>
  cells(COLUMNS / COLUMN_EVERY, ROWS, (c, r) => ({
    outline: rectangle((c * COLUMN_EVERY + 0.5) * WIDTH, (r + 0.5) * DEPTH, 0.4, 0.4),
    ...{ operation: 'subtract', type: 'column', points: 400 },
  }));
