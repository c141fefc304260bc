/** A circle in the plan, m. */
export interface Circle {
  readonly cx: number;
  readonly cy: number;
  readonly radius: number;
}

/** Places lie in a line when their variance across it is less than about this share of that along it. */
const STRAIGHT = 1e-9;

/**
 * Circle of least squares of squared distances through places ([Kåsa76]); null where they lie in a line. O(places).
 *
 * @param xy x, y a place, m
 * @param weights one a place; all alike where there are none
 */
export function circleThrough(xy: ArrayLike<number>, weights?: ArrayLike<number>): Circle | null {
  const count = xy.length / 2;
  let [sw, mx, my] = [0, 0, 0];
  for (let i = 0; i < count; i++) {
    const w = weights?.[i] ?? 1;
    sw += w;
    mx += w * xy[2 * i];
    my += w * xy[2 * i + 1];
  }
  mx /= sw;
  my /= sw;
  let [xx, cross, yy, xq, yq, q] = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i < count; i++) {
    const [x, y, w] = [xy[2 * i] - mx, xy[2 * i + 1] - my, weights?.[i] ?? 1];
    const s = x * x + y * y;
    xx += w * x * x;
    cross += w * x * y;
    yy += w * y * y;
    xq += w * x * s;
    yq += w * y * s;
    q += w * s;
  }
  const determinant = xx * yy - cross * cross;
  if (!(determinant > STRAIGHT * (xx + yy) ** 2)) return null;
  const cx = (xq * yy - yq * cross) / (2 * determinant);
  const cy = (yq * xx - xq * cross) / (2 * determinant);
  return { cx: cx + mx, cy: cy + my, radius: Math.sqrt(cx * cx + cy * cy + q / sw) };
}
