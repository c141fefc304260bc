import { type Bounds, boundsOf } from '../../core/geometry/rings.ts';
import type { Solid } from '../../core/types.ts';
import type { Sight } from './model-faces.ts';
import { CONTENT_WIDTH, MARGIN } from './page.ts';

/** Seen from the south-east, a little more from the south so that no corner hides behind another, and from above. */
const HEADING = (-58 * Math.PI) / 180;
/** From as high above that walls hide no more than this share of what lies behind them, within these bounds. */
const HIDDEN = 0.4;
const LOWEST = (42 * Math.PI) / 180;
const HIGHEST = (62 * Math.PI) / 180;
/** The light comes from the viewer's left. */
const LIGHT = HEADING - (55 * Math.PI) / 180;
const TALLEST = 460;

/** Where the model is seen from, and the page it is seen on. */
export interface Eye extends Sight {
  /** Unit vector in the plan towards the light. */
  readonly light: readonly [x: number, y: number];
  /** Of the line of sight above the ground, radians. */
  readonly elevation: number;
  /** Of the page above its caption, px. */
  readonly height: number;
  /** What one px shows, m. */
  readonly pixel: number;
  /** Vertices x, y at a height, m, to px. */
  map(xy: ArrayLike<number>, z: number): Float64Array;
}

/**
 * An eye that sees the whole solid as large as the page allows.
 *
 * @param turn by which the plan would stand square, radians: the view keeps its angle to the walls
 */
export function makeEye(solid: Solid, turn: number): Eye {
  const { positions } = solid;
  const direction = (angle: number) => [Math.cos(angle - turn), Math.sin(angle - turn)] as const;
  const towards = direction(HEADING);
  const right = [-towards[1], towards[0]] as const;
  const elevation = elevationFor(solid, towards);
  const [lift, rise] = [Math.sin(elevation), Math.cos(elevation)];
  const project = (x: number, y: number, z: number) =>
    [right[0] * x + right[1] * y, lift * (towards[0] * x + towards[1] * y) - rise * z] as const;
  const flat = new Float64Array((positions.length / 3) * 2);
  for (let i = 0; i < positions.length / 3; i++) {
    flat.set(project(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]), 2 * i);
  }
  const { scale, left, head, height } = fitPage(boundsOf(flat));
  return {
    towards,
    right,
    light: direction(LIGHT),
    elevation,
    height,
    pixel: 1 / scale,
    map(xy, z) {
      const mapped = new Float64Array(xy.length);
      for (let i = 0; i < xy.length; i += 2) {
        const [u, w] = project(xy[i], xy[i + 1], z);
        mapped[i] = left + scale * u;
        mapped[i + 1] = head + scale * w;
      }
      return mapped;
    },
  };
}

/** How steeply to look: a wall of height h hides h / tan(elevation) of the ground behind it. */
function elevationFor({ positions }: Solid, towards: readonly [number, number]): number {
  let [nearest, farthest, lowest, highest] = [-Infinity, Infinity, Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    const depth = towards[0] * positions[i] + towards[1] * positions[i + 1];
    nearest = Math.max(nearest, depth);
    farthest = Math.min(farthest, depth);
    lowest = Math.min(lowest, positions[i + 2]);
    highest = Math.max(highest, positions[i + 2]);
  }
  const steepness = Math.atan2(highest - lowest, HIDDEN * (nearest - farthest));
  return Math.min(HIGHEST, Math.max(LOWEST, steepness));
}

function fitPage({ minX, minY, maxX, maxY }: Bounds) {
  const scale = Math.min(CONTENT_WIDTH / (maxX - minX), TALLEST / (maxY - minY));
  const left = MARGIN + CONTENT_WIDTH / 2 - (scale * (minX + maxX)) / 2;
  return { scale, left, head: MARGIN - scale * minY, height: MARGIN + scale * (maxY - minY) + 8 };
}
