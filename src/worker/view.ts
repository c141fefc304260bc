import type { PointCloud } from '../core/types.ts';
import { makeReport } from '../session/report.ts';
import type { Session } from '../session/session.ts';
import type { CloudView, PictureFacts, PlanView } from './protocol.ts';

/** More points than this no screen tells apart, and a software renderer still draws them in one frame. */
const CLOUD_POINTS = 300_000;

/** What the page is sent of a session's last run. The session keeps its own arrays: only copies are transferred. */
export function makeView(
  session: Session,
  pictures: readonly PictureFacts[],
  totalMs: number,
): { view: PlanView; transfer: Transferable[] } {
  const result = session.result!;
  const { options, plan, solid, slice, level, secondary, stages } = result;
  const cloud = sampleCloud(result.frame);
  const drawings = session.write('svg').map(({ content }) => content as string);
  const view = {
    options,
    plan,
    drawings,
    solid,
    cloud,
    slice,
    levels: level.levels,
    secondary,
    stages,
    report: makeReport(result, totalMs),
    pictures,
  };
  const buffers = cloud.colour ? [cloud.positions.buffer, cloud.colour.buffer] : [cloud.positions.buffer];
  return { view, transfer: buffers as ArrayBuffer[] };
}

/** Every n-th point; the cloud is sorted by lattice cell, so this is uniform in space. O(sample). */
function sampleCloud({ positions, attributes }: PointCloud): CloudView {
  const total = positions.length / 3;
  const step = Math.max(1, Math.ceil(total / CLOUD_POINTS));
  const size = Math.ceil(total / step);
  const xyz = new Float32Array(size * 3);
  const colour = attributes.colour ? new Uint8Array(size * 3) : undefined;
  for (let i = 0; i < size; i++) {
    for (let k = 0; k < 3; k++) {
      xyz[3 * i + k] = positions[3 * i * step + k];
      if (colour) colour[3 * i + k] = attributes.colour![3 * i * step + k];
    }
  }
  return colour ? { positions: xyz, colour, total } : { positions: xyz, total };
}
