import type { Opening, Polygon, Storey } from '../core/types.ts';
import { extrude } from './extrude.ts';
import { type OpeningBox, openingBoxes } from './opening-boxes.ts';
import type { TriangleMesh } from './triangle-mesh.ts';

/** How wide a frame looks from the front, m: a usual steel door lining and window frame; no scan tells it. */
const PROFILE = 0.05;
/** How deep a window's frame is, m: the usual profile; a door's lining is as deep as its wall. */
const WINDOW_DEPTH = 0.07;
/** A pane of insulating glass, m. */
const PANE_DEPTH = 0.024;
/** A frame that leaves less than this to see through, m, is none. */
const LEAST_CLEAR = 0.05;

/** What stands in an opening: a door's lining without its leaf, whose hinge nobody knows, or a window's frame and pane. */
export interface OpeningFrame {
  readonly opening: Opening;
  /** Metres, plan frame; a closed two-manifold, as is the pane. */
  readonly frame: TriangleMesh;
  readonly pane: TriangleMesh | null;
}

/**
 * The frames of a storey's doors and windows, each flush with the reveals of its hole; passages have none, nor have
 * openings off every wall.
 */
export function openingFrames(storey: Storey): OpeningFrame[] {
  return openingBoxes(storey).flatMap((box) => {
    const ceiling = storey.floor + storey.height;
    const [low, high] = [Math.max(box.low, storey.floor), Math.min(box.high, ceiling)];
    const { from, to } = box.opening;
    const [width, height] = [Math.hypot(to[0] - from[0], to[1] - from[1]), high - low];
    const isTooSmall = Math.min(width, height) < 2 * PROFILE + LEAST_CLEAR;
    if (box.opening.type === 'passage' || isTooSmall) return [];
    return [
      box.opening.type === 'door'
        ? doorOf(box, { width, height, low })
        : windowOf(box, { width, height, low }),
    ];
  });
}

/** An opening as seen from the front, m; `low` in the plan frame. */
interface Front {
  readonly width: number;
  readonly height: number;
  readonly low: number;
}

function doorOf({ opening, depth }: OpeningBox, front: Front): OpeningFrame {
  const { width: w, height: h } = front;
  const p = PROFILE;
  const outer = Float64Array.of(0, 0, p, 0, p, h - p, w - p, h - p, w - p, 0, w, 0, w, h, 0, h);
  const lining = raise({ outer, holes: [] }, opening, { low: front.low, ...between(depth.low, depth.high) });
  return { opening, frame: lining, pane: null };
}

function windowOf({ opening, depth }: OpeningBox, front: Front): OpeningFrame {
  const { width: w, height: h, low } = front;
  const p = PROFILE;
  const clear = Float64Array.of(p, p, w - p, p, w - p, h - p, p, h - p);
  const hole = Float64Array.of(p, p, p, h - p, w - p, h - p, w - p, p);
  const middle = (depth.low + depth.high) / 2;
  const deep = (size: number) => {
    const half = Math.min(size, depth.high - depth.low) / 2;
    return { low, ...between(middle - half, middle + half) };
  };
  const around = { outer: Float64Array.of(0, 0, w, 0, w, h, 0, h), holes: [hole] };
  return {
    opening,
    frame: raise(around, opening, deep(WINDOW_DEPTH)),
    pane: raise({ outer: clear, holes: [] }, opening, deep(PANE_DEPTH)),
  };
}

const between = (right: number, left: number) => ({ right, left });

/** Where a profile seen from the front comes to stand. */
interface Place {
  readonly low: number;
  /** Its faces, m to the left of the opening's axis. */
  readonly right: number;
  readonly left: number;
}

/** A profile (along the axis, up) as a prism across the wall: a turn, so that faces keep facing outwards. */
function raise(profile: Polygon, { from, to }: Opening, { low, right, left }: Place): TriangleMesh {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const [ex, ey] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  // Along × up points to the right of the axis.
  const { positions, indices } = extrude(profile, -left, -right);
  const turned = new Float64Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    const [along, up, aside] = positions.subarray(i, i + 3);
    turned[i] = from[0] + along * ex + aside * ey;
    turned[i + 1] = from[1] + along * ey - aside * ex;
    turned[i + 2] = low + up;
  }
  return { positions: turned, indices };
}
