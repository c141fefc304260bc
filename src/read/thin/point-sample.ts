import type { Vec3 } from '../../core/types.ts';

/** Most points of a sample; at least half as many where the cloud has them. */
const MOST_POINTS = 1 << 17;
/** Points enough to find the middle. */
const MIDDLE_POINTS = 1 << 12;
const LEAST_PRIORITY = -(2 ** 31);

/**
 * A sample of all points of a stream: those whose hash is below a limit that is halved whenever they get too many.
 *
 * So it does not depend on the order of the points, nor on any cells. Memory is bounded.
 */
export class PointSample {
  count = 0;
  /** Points whose priority is above are not taken. */
  limit = 2 ** 31 - 1;
  /** x, y, z a point, source units; entries past 3 · count are stale. */
  xyz = new Float64Array(0);
  #priorities = new Int32Array(0);

  /** Takes the point whose x is `xyz[at]`; the caller has checked {@link limit}. */
  add(xyz: Float64Array, at: number, priority: number): void {
    if (this.count === this.#priorities.length) this.#makeRoom();
    if (priority > this.limit) return;
    this.#priorities[this.count] = priority;
    const to = 3 * this.count++;
    // −0 becomes 0: one place, different bits.
    this.xyz[to] = xyz[at] + 0;
    this.xyz[to + 1] = xyz[at + 1] + 0;
    this.xyz[to + 2] = xyz[at + 2] + 0;
  }

  /** x, y, z a point, relative to `origin`. */
  positions([x, y, z]: Vec3): Float32Array {
    const { xyz, count } = this;
    const positions = new Float32Array(3 * count);
    for (let i = 0; i < 3 * count; i += 3) {
      positions[i] = xyz[i] - x;
      positions[i + 1] = xyz[i + 1] - y;
      positions[i + 2] = xyz[i + 2] - z;
    }
    return positions;
  }

  /**
   * Median of each axis, rounded to a whole unit towards zero, so that it turns with the axes: strays do not move it, and
   * float32 is finest around it.
   */
  middle(): Vec3 {
    const share = Math.min(1, MIDDLE_POINTS / this.count);
    const limit = LEAST_PRIORITY + share * (this.limit - LEAST_PRIORITY);
    const axes: [number[], number[], number[]] = [[], [], []];
    for (let i = 0; i < this.count; i++) {
      if (this.#priorities[i] > limit) continue;
      for (let axis = 0; axis < 3; axis++) axes[axis].push(this.xyz[3 * i + axis]);
    }
    return [medianOf(axes[0]), medianOf(axes[1]), medianOf(axes[2])];
  }

  #makeRoom(): void {
    while (this.count >= MOST_POINTS) this.#halve();
    const capacity = Math.min(MOST_POINTS, Math.max(1024, 2 * this.count));
    if (capacity <= this.#priorities.length) return;
    const [xyz, priorities] = [new Float64Array(3 * capacity), new Int32Array(capacity)];
    xyz.set(this.xyz);
    priorities.set(this.#priorities);
    this.xyz = xyz;
    this.#priorities = priorities;
  }

  #halve(): void {
    this.limit = LEAST_PRIORITY + Math.floor((this.limit - LEAST_PRIORITY) / 2);
    let left = 0;
    for (let i = 0; i < this.count; i++) {
      if (this.#priorities[i] > this.limit) continue;
      this.#priorities[left] = this.#priorities[i];
      for (let axis = 0; axis < 3; axis++) this.xyz[3 * left + axis] = this.xyz[3 * i + axis];
      left++;
    }
    this.count = left;
  }
}

function medianOf(values: readonly number[]): number {
  const sorted = Float64Array.from(values).sort();
  // −0 would be another origin than 0.
  return Math.trunc(sorted[sorted.length >> 1]) + 0;
}
