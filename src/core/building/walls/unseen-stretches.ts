import type { Gap } from '../../types.ts';
import type { WallStrip } from '../openings/wall-strip.ts';
import type { RoomEdge } from './room-edges.ts';

/** Bits of a face that are seen or not, m. */
const STEP = 0.1;
/** Shortest stretch told, m: voxels leave shorter ones in any wall. */
const SHORTEST = 0.3;
/** Height over which a bit must have points to be seen, m. */
const LEAST_HEIGHT = 0.1;

/** The stretches of a face that no point supports and no opening explains. */
export function unseenStretches(
  { ax, ay, ux, uy, length }: RoomEdge,
  { count, along, deep, high }: WallStrip,
  band: number,
  openings: readonly { readonly from: number; readonly to: number }[],
): Gap[] {
  const bits = Math.max(1, Math.ceil(length / STEP));
  const low = new Float64Array(bits).fill(Infinity);
  const top = new Float64Array(bits).fill(-Infinity);
  for (let i = 0; i < count; i++) {
    if (Math.abs(deep[i]) > band) continue;
    const bit = Math.min(bits - 1, Math.floor(along[i] / STEP));
    low[bit] = Math.min(low[bit], high[i]);
    top[bit] = Math.max(top[bit], high[i]);
  }
  const isSeen = (k: number) => {
    const middle = (k + 0.5) * STEP;
    return top[k] - low[k] >= LEAST_HEIGHT || openings.some(({ from, to }) => middle > from && middle < to);
  };
  const stretches: Gap[] = [];
  for (let k = 0, begin = 0; k <= bits; k++) {
    if (k < bits && !isSeen(k)) continue;
    const [from, to] = [begin * STEP, Math.min(length, k * STEP)];
    if (to - from >= SHORTEST) {
      stretches.push({
        from: [ax + from * ux, ay + from * uy],
        to: [ax + to * ux, ay + to * uy],
        width: to - from,
      });
    }
    begin = k + 1;
  }
  return stretches;
}
