import earcut from 'earcut';

/** Ear cutting may take the square of the corners; no modelled face has so many. */
const MOST_CUT_CORNERS = 4096;

/**
 * Triangles of a flat polygon in space: a fan where it is convex, else cut ears, for a wall with a door is often one
 * concave polygon and a fan would close the door.
 *
 * @param xyz x, y, z a vertex @param corners vertices around the polygon, four or more
 * @returns three vertices a triangle. Complexity: O(corners) where convex, else up to O(corners²)
 */
export function triangulatePolygon(xyz: Float64Array, corners: readonly number[]): readonly number[] {
  const flat = flatten(xyz, corners);
  if (flat.every(Number.isFinite) && !isConvex(flat) && corners.length <= MOST_CUT_CORNERS) {
    return earcut(flat).map((corner) => corners[corner]);
  }
  return corners.slice(2).flatMap((corner, i) => [corners[0], corners[i + 1], corner]);
}

/** The polygon seen along the axis nearest to its normal (Newell's sum): u, v a corner. */
function flatten(xyz: Float64Array, corners: readonly number[]): number[] {
  const normal = [0, 0, 0];
  const [ox, oy, oz] = [0, 1, 2].map((axis) => xyz[3 * corners[0] + axis]);
  for (let i = 0; i < corners.length; i++) {
    const a = 3 * corners[i];
    const b = 3 * corners[(i + 1) % corners.length];
    const [ax, ay, az] = [xyz[a] - ox, xyz[a + 1] - oy, xyz[a + 2] - oz];
    const [bx, by, bz] = [xyz[b] - ox, xyz[b + 1] - oy, xyz[b + 2] - oz];
    normal[0] += ay * bz - az * by;
    normal[1] += az * bx - ax * bz;
    normal[2] += ax * by - ay * bx;
  }
  const size = normal.map(Math.abs);
  const across = size.indexOf(Math.max(...size));
  const [u, v] = [(across + 1) % 3, (across + 2) % 3];
  const origin = [ox, oy, oz];
  return corners.flatMap((corner) => [xyz[3 * corner + u] - origin[u], xyz[3 * corner + v] - origin[v]]);
}

/** Whether every corner turns the same way, and once around. */
function isConvex(flat: readonly number[]): boolean {
  let turn = 0;
  let sweeps = 0;
  const count = flat.length;
  for (let i = 0; i < count; i += 2) {
    const [ax, ay, bx, by] = [flat[i], flat[i + 1], flat[(i + 2) % count], flat[(i + 3) % count]];
    const [cx, cy] = [flat[(i + 4) % count], flat[(i + 5) % count]];
    const cross = (bx - ax) * (cy - by) - (by - ay) * (cx - bx);
    if (cross * turn < 0) return false;
    if (cross !== 0) turn = cross;
    // A convex ring goes to the right and comes back once.
    if (bx > ax !== cx > bx) sweeps++;
  }
  return sweeps <= 2;
}
