import { cloudBounds } from '../core/cloud-bounds.ts';
import { isWithin } from '../core/crop.ts';
import { parseCrop } from '../core/crop-box.ts';
import type { Options } from '../core/params.ts';
import type { FloorPlan, PointAttributes, PointCloud, Vec3 } from '../core/types.ts';
import { planBox } from '../session/plan-bounds.ts';
import { makeReport } from '../session/report.ts';
import { isOfScan, type ScanResult } from '../session/result.ts';
import { NO_SLICE, type Session } from '../session/session.ts';
import { sheetToSvg } from '../write/drawing/svg.ts';
import type { CloudView, PictureFacts, PlanView, Surroundings } from './protocol.ts';

/** More points than this no screen tells apart, and a software renderer still draws them in one frame. */
const CLOUD_POINTS = 300_000;

/** What the page is sent of a session's last run. The session keeps its own arrays: only copies are transferred. */
export function makeView(
  session: Session,
  pictures: readonly PictureFacts[],
  totalMs: number,
): { view: PlanView; transfer: Transferable[] } {
  const result = session.result!;
  const { options, plan, solid, stages } = result;
  const seen = isOfScan(result) ? seenOf(result) : unseenOf(plan);
  const { cloud, surroundings } = seen;
  const drawings = result.sheet.map((sheet) => sheetToSvg(sheet, plan));
  const view = {
    options,
    plan,
    drawings,
    solid,
    ...seen,
    stages,
    report: makeReport(result, totalMs),
    pictures,
  };
  const arrays = [cloud.positions, surroundings.cropped, cloud.colour, cloud.intensity];
  return { view, transfer: arrays.flatMap((array) => (array ? [array.buffer as ArrayBuffer] : [])) };
}

type Seen = Pick<
  PlanView,
  'cloud' | 'surroundings' | 'isSlice' | 'isSavedPlan' | 'reasons' | 'slice' | 'levels' | 'secondary'
>;

function seenOf({ read, frame, crop, slice, level, secondary, options }: ScanResult): Seen {
  return {
    cloud: sampleCloud(crop),
    surroundings: surroundingsOf(frame, options),
    isSlice: read.isSlice,
    isSavedPlan: false,
    reasons: frame.reasons,
    slice,
    levels: level.levels,
    secondary,
  };
}

/** A plan without its scan: no points, and the building itself in place of the cloud's extent. */
function unseenOf(plan: FloorPlan): Seen {
  return {
    cloud: { positions: new Float32Array(0), total: 0 },
    surroundings: { ...planBox(plan), cropped: new Float64Array(0) },
    isSlice: false,
    isSavedPlan: true,
    reasons: { unit: 'The plan says so.', up: 'The plan says so.' },
    slice: NO_SLICE,
    levels: [],
    secondary: { clusters: new Uint8Array(0), searches: [], boundaries: [] },
  };
}

/** Shares of the points that are shown black and white: a few glints would darken all else. */
const BLACK_SHARE = 0.02;
const WHITE_SHARE = 0.98;

/** Every n-th point; the cloud is sorted by lattice cell, so this is uniform in space. O(sample). */
function sampleCloud({ positions, attributes }: PointCloud): CloudView {
  const total = positions.length / 3;
  const step = Math.max(1, Math.ceil(total / CLOUD_POINTS));
  const size = Math.ceil(total / step);
  const xyz = new Float32Array(size * 3);
  const colour = sampleColour(attributes, step, size);
  const intensity = sampleIntensity(attributes, step, size);
  for (let i = 0; i < size; i++) {
    for (let k = 0; k < 3; k++) xyz[3 * i + k] = positions[3 * i * step + k];
  }
  return { positions: xyz, ...(colour && { colour }), ...(intensity && { intensity }), total };
}

/** r, g, b of every `step`-th point. */
function sampleColour({ colour }: PointAttributes, step: number, size: number): Uint8Array | null {
  if (!colour) return null;
  const sample = new Uint8Array(size * 3);
  for (let i = 0; i < sample.length; i++) sample[i] = colour[3 * step * Math.floor(i / 3) + (i % 3)];
  return sample;
}

/** Greys of every `step`-th point; null where all are alike. */
function sampleIntensity({ intensity }: PointAttributes, step: number, size: number): Uint8Array | null {
  if (!intensity) return null;
  const sample = Float32Array.from({ length: size }, (_, i) => intensity[i * step]);
  const sorted = sample.toSorted();
  const black = sorted[Math.floor(BLACK_SHARE * size)];
  const white = sorted[Math.floor(WHITE_SHARE * size)];
  if (!(white > black)) return null;
  const shades = new Uint8Array(size * 3);
  for (let i = 0; i < size; i++) {
    const share = Math.min(1, Math.max(0, (sample[i] - black) / (white - black)));
    shades.fill(Math.round(255 * share), 3 * i, 3 * i + 3);
  }
  return shades;
}

/** Where the cloud lies before the crop box, and a sample of what the box leaves out. O(n). */
function surroundingsOf(whole: PointCloud, options: Options): Surroundings {
  const bounds = cloudBounds(whole.positions);
  const box = parseCrop(options.crop);
  const cropped: number[] = [];
  if (box) {
    const isIn = isWithin(whole.frame, box);
    const { positions } = whole;
    const step = 3 * Math.max(1, Math.ceil(positions.length / 3 / CLOUD_POINTS));
    for (let i = 0; i < positions.length; i += step) {
      const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
      if (!isIn(x, y, z)) cropped.push(x, y);
    }
  }
  const corner = ([x, y, z]: Float64Array): Vec3 => [x, y, z];
  return { min: corner(bounds.min), max: corner(bounds.max), cropped: Float64Array.from(cropped) };
}
