import { cloudBounds } from '../core/cloud-bounds.ts';
import { planPlace, sourceCoordinates } from '../core/source-coordinates.ts';
import type { Frame, Vec2 } from '../core/types.ts';
import type { Placement } from './pan-zoom.ts';
import type { Drawing, SheetTransform } from './parse-drawing.ts';

/** Of the window a sheet is seen in, px. */
type Size = readonly [width: number, height: number];

interface PlacedSheet {
  readonly drawing: Drawing;
  readonly frame: Frame;
}

/** What of the plan is in the middle of the window, whatever sheet it is drawn on. */
export interface Sight {
  /** Source units and coordinates. */
  readonly x: number;
  readonly y: number;
  readonly pixelsPerUnit: number;
}

/** By eighths of a turn, clockwise from the right. */
const RESIZE_CURSORS = ['ew-resize', 'nwse-resize', 'ns-resize', 'nesw-resize'] as const;

/** What is seen of a sheet. */
export function sightOf({ drawing, frame }: PlacedSheet, { zoom, x, y }: Placement, [w, h]: Size): Sight {
  const { planToSheet } = drawing;
  const to = sourceCoordinates(frame);
  const [planX, planY] = invert(planToSheet, (w / 2 - x) / zoom, (h / 2 - y) / zoom);
  const pixelsPerMetre = zoom * Math.hypot(planToSheet[0], planToSheet[1]);
  return { x: to.x(planX), y: to.y(planY), pixelsPerUnit: pixelsPerMetre * frame.metresPerUnit };
}

/** Where another sheet has to lie so that the same is seen of it; the inverse of {@link sightOf}. */
export function placementFor(sight: Sight, { drawing, frame }: PlacedSheet, [w, h]: Size): Placement {
  const [a, b, c, d, e, f] = drawing.planToSheet;
  const [x, y] = planPlace(frame, sight.x, sight.y);
  const zoom = sight.pixelsPerUnit / (Math.hypot(a, b) * frame.metresPerUnit);
  return { zoom, x: w / 2 - zoom * (a * x + c * y + e), y: h / 2 - zoom * (b * x + d * y + f) };
}

/** The pointer for an edge that moves in a direction of the plan, as that lies on the sheet. */
export function resizeCursor([dx, dy]: readonly [number, number], drawing: Drawing | null): string {
  if (!drawing) return '';
  const [a, b, c, d] = drawing.planToSheet;
  const eighth = Math.round(Math.atan2(b * dx + d * dy, a * dx + c * dy) / (Math.PI / 4));
  return RESIZE_CURSORS[((eighth % 4) + 4) % 4];
}

/** The place of the plan at a place of the sheet. */
export function invert([a, b, c, d, e, f]: SheetTransform, x: number, y: number): Vec2 {
  const determinant = a * d - b * c;
  return [(d * (x - e) - c * (y - f)) / determinant, (a * (y - f) - b * (x - e)) / determinant];
}

/** Positions without their axis of least extent, and the transform that fits them into a window with a margin. */
export function flatten(
  positions: Float32Array,
  [width, height]: Size,
  margin: number,
): { xy: Float64Array; planToSheet: SheetTransform } {
  const { min: low, max: high } = cloudBounds(positions);
  const extent = high.map((value, axis) => value - low[axis]);
  const flat = extent.indexOf(Math.min(...extent));
  const [u, v] = [0, 1, 2].filter((axis) => axis !== flat);
  const xy = new Float64Array((positions.length / 3) * 2);
  for (let i = 0; i < positions.length / 3; i++) {
    xy[2 * i] = positions[3 * i + u];
    xy[2 * i + 1] = positions[3 * i + v];
  }
  const k = Math.min(
    (width - 2 * margin) / Math.max(extent[u], Number.EPSILON),
    (height - 2 * margin) / Math.max(extent[v], Number.EPSILON),
  );
  const [cx, cy] = [(low[u] + high[u]) / 2, (low[v] + high[v]) / 2];
  return { xy, planToSheet: [k, 0, 0, -k, width / 2 - k * cx, height / 2 + k * cy] };
}
