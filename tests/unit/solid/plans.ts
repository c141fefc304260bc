import { resolveOptions } from '../../../src/core/options.ts';
import type {
  FloorPlan,
  Operation,
  Polygon,
  Ring,
  SecondaryBoundary,
  Storey,
} from '../../../src/core/types.ts';
import { UPRIGHT_FRAME } from '../core/made-scan.ts';

/** Plans made by hand, for the tests of solids and writers. */

export const ring = (...coordinates: number[]): Ring => Float64Array.from(coordinates);

export const rectangle = (x: number, y: number, width: number, depth: number): Ring =>
  ring(x, y, x + width, y, x + width, y + depth, x, y + depth);

/** Regular polygon, counter-clockwise. */
export function disc(x: number, y: number, radius: number, sides: number, turn = 0): Ring {
  const vertices: number[] = [];
  for (let i = 0; i < sides; i++) {
    const angle = turn + (2 * Math.PI * i) / sides;
    vertices.push(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  }
  return ring(...vertices);
}

export function reversed(source: Ring): Ring {
  const vertices: number[] = [];
  for (let i = source.length - 2; i >= 0; i -= 2) vertices.push(source[i], source[i + 1]);
  return ring(...vertices);
}

export function rotated(source: Ring, angle: number): Ring {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return source.map((_, k) =>
    k % 2 === 0 ? c * source[k] - s * source[k + 1] : s * source[k - 1] + c * source[k],
  );
}

/** Moves every edge of a counter-clockwise ring outwards; corners stay mitred. */
export function offset(source: Ring, distance: number): Ring {
  const count = source.length / 2;
  const at = (i: number) => {
    const k = 2 * ((i + count) % count);
    return [source[k], source[k + 1]] as const;
  };
  const normal = (i: number) => {
    const [[ax, ay], [bx, by]] = [at(i), at(i + 1)];
    const length = Math.hypot(bx - ax, by - ay);
    return [(by - ay) / length, (ax - bx) / length] as const;
  };
  const vertices: number[] = [];
  for (let i = 0; i < count; i++) {
    const [[mx, my], [nx, ny], [x, y]] = [normal(i - 1), normal(i), at(i)];
    const scale = distance / (1 + mx * nx + my * ny);
    vertices.push(x + scale * (mx + nx), y + scale * (my + ny));
  }
  return ring(...vertices);
}

/** The wall around an inner face: a ring of material with the room as its hole. */
export const wallAround = (inner: Ring, thickness: number): Polygon => ({
  outer: offset(inner, thickness),
  holes: [reversed(inner)],
});

export const secondary = (
  outer: Ring,
  operation: Operation,
  holes: readonly Ring[] = [],
): SecondaryBoundary => ({
  outline: { outer, holes },
  operation,
  type: 'column',
  points: 100,
});

export interface PlanFacts {
  readonly storeys?: readonly Partial<Storey>[];
  readonly frame?: Partial<FloorPlan['frame']>;
  readonly name?: string;
  readonly options?: Parameters<typeof resolveOptions>[0];
}

/** A plan in the default frame; every storey starts as a room of 4 m × 3 m with walls of 0.2 m, 2.5 m high. */
export function planOf({
  storeys = [{}],
  frame = {},
  name = 'room.ply',
  options = {},
}: PlanFacts = {}): FloorPlan {
  const room = rectangle(0, 0, 4, 3);
  return {
    version: 1,
    source: { name, format: 'ply', bytes: 1, pointsRead: 1000, pointsDropped: 0, pointsKept: 1000 },
    frame: { ...UPRIGHT_FRAME, ...frame },
    options: resolveOptions(options),
    storeys: storeys.map((storey, index) => ({
      index,
      floor: 3 * index,
      height: 2.5,
      primary: [{ outer: room, holes: [] }],
      secondary: [],
      walls: [{ outline: wallAround(room, 0.2), thickness: 0.2, confidence: 1 }],
      rooms: [],
      openings: [],
      gaps: [],
      ...storey,
    })),
    warnings: [],
  };
}
