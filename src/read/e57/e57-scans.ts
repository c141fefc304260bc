import { FloorPlanError } from '../../core/errors.ts';
import { MOST_STATIONS, type Pose, rotationOf } from '../pose.ts';
import type { E57Node } from './e57-node.ts';
import { type Prototype, readPrototype } from './prototype.ts';

/** One scan (`data3D`) of the file. */
export interface E57Scan {
  /** Number in the file, counted from 0. */
  readonly index: number;
  /** Physical offset of its binary section. */
  readonly offset: number;
  readonly count: number;
  readonly prototype: Prototype;
  /** Null where the file gives none: the scan's coordinates are the file's. */
  readonly pose: Pose | null;
}

/** All scans that have points, in the file's order. @throws input/malformed, input/empty, input/too-large */
export function readE57Scans(root: E57Node, file: string): E57Scan[] {
  const nodes = root.child('data3D')?.children ?? [];
  if (nodes.length > MOST_STATIONS) throw tooManyScans(file, nodes.length);
  const scans = nodes.flatMap((node, index) => {
    const points = node.child('points');
    const count = points?.sizeAttribute('recordCount') ?? 0;
    if (!points || count === 0) return [];
    const offset = points.sizeAttribute('fileOffset');
    return [{ index, offset, count, prototype: readPrototype(node, points), pose: readPose(node) }];
  });
  if (scans.length === 0) throw noScans(file, nodes.length, root.child('images2D')?.children.length ?? 0);
  return scans;
}

function readPose(scan: E57Node): Pose | null {
  const pose = scan.child('pose');
  if (!pose) return null;
  const numbers = (name: string, parts: readonly string[], missing: readonly number[]) => {
    const node = pose.child(name);
    return node ? parts.map((part) => node.child(part)?.number() ?? 0) : missing;
  };
  const quaternion = numbers('rotation', ['w', 'x', 'y', 'z'], [1, 0, 0, 0]);
  const length = Math.hypot(...quaternion);
  if (length === 0) throw pose.malformed('a rotation', '0 0 0 0');
  const [w, i, j, k] = quaternion.map((part) => part / length);
  const [x, y, z] = numbers('translation', ['x', 'y', 'z'], [0, 0, 0]);
  return { rotation: rotationOf(w, i, j, k), translation: [x, y, z] };
}

function noScans(file: string, scans: number, images: number): FloorPlanError {
  const found = scans > 0 ? `${scans} without any` : images > 0 ? `${images} images only` : 'none';
  return new FloorPlanError('input/empty', `${file}: expected scans with points, found ${found}`, {
    hint: 'Export the scans with their points.',
    detail: { scans, images },
  });
}

function tooManyScans(file: string, scans: number): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${file}: expected at most ${MOST_STATIONS} scans, found ${scans}`,
    { hint: 'Export the scans in several files.', detail: { scans } },
  );
}
