/** A piece of upright wall seen along one direction: u to the right, v towards the viewer, m. */
export interface SeenSegment {
  readonly u0: number;
  readonly v0: number;
  /** Greater than `u0`. */
  readonly u1: number;
  readonly v1: number;
}

/**
 * The order in which upright faces of one height must be painted so that nearer ones cover farther ones.
 *
 * For segments that do not cross "lies before" along one direction has no cycle, so there is an exact order without
 * cutting anything; a sweep over u finds who lies directly before whom, and those pairs are sorted topologically.
 * O(n log n) comparisons.
 *
 * @returns indices, farthest first; where segments cross after all, what is left by depth
 */
export function paintOrder(segments: readonly SeenSegment[]): number[] {
  const nearer: number[][] = segments.map(() => []);
  const farther = new Uint32Array(segments.length);
  const relate = (far: number | undefined, near: number | undefined): void => {
    if (far === undefined || near === undefined) return;
    nearer[far].push(near);
    farther[near]++;
  };
  const active: number[] = [];
  for (const event of eventsOf(segments)) {
    if (event < 0) {
      const place = active.indexOf(-event - 1);
      relate(active[place - 1], active[place + 1]);
      active.splice(place, 1);
      continue;
    }
    const place = placeAmong(active, segments, event);
    relate(active[place - 1], event);
    relate(event, active[place]);
    active.splice(place, 0, event);
  }
  return sorted(segments, nearer, farther);
}

/** Starts as i, ends as -i - 1, from left to right; at one place ends come first. */
function eventsOf(segments: readonly SeenSegment[]): number[] {
  const events = segments.flatMap((_, i) => [i, -i - 1]);
  const at = (event: number): number => (event < 0 ? segments[-event - 1].u1 : segments[event].u0);
  return events.sort((a, b) => at(a) - at(b) || Number(b < 0) - Number(a < 0) || a - b);
}

/** Binary search among the segments at hand, farthest first. */
function placeAmong(active: readonly number[], segments: readonly SeenSegment[], i: number): number {
  let [low, high] = [0, active.length];
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (isNearer(segments[i], segments[active[middle]])) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Compared in the middle of what both span: the surest place where ends touch. */
function isNearer(a: SeenSegment, b: SeenSegment): boolean {
  const u = (Math.max(a.u0, b.u0) + Math.min(a.u1, b.u1)) / 2;
  return depthAt(a, u) > depthAt(b, u);
}

const depthAt = ({ u0, v0, u1, v1 }: SeenSegment, u: number): number =>
  v0 + ((u - u0) / (u1 - u0)) * (v1 - v0);

function sorted(
  segments: readonly SeenSegment[],
  nearer: readonly (readonly number[])[],
  farther: Uint32Array,
): number[] {
  const order = [...segments.keys()].filter((i) => farther[i] === 0);
  for (let k = 0; k < order.length; k++) {
    for (const near of nearer[order[k]]) if (--farther[near] === 0) order.push(near);
  }
  if (order.length === segments.length) return order;
  const depth = (i: number): number => segments[i].v0 + segments[i].v1;
  const left = [...segments.keys()].filter((i) => farther[i] > 0).sort((a, b) => depth(a) - depth(b));
  return [...order, ...left];
}
