/** Smallest eigenvalue pair of a symmetric 3 × 3 matrix; written to by {@link smallestEigen}. */
export interface SmallestEigen {
  /** Eigenvalues, rising. */
  readonly values: Float64Array;
  /** Unit eigenvector of the smallest; zero where it is not unique. */
  readonly vector: Float64Array;
}

/**
 * Eigenvalues of a symmetric 3 × 3 matrix in closed form and the eigenvector of the smallest.
 *
 * Trigonometric solution of the characteristic cubic ([Smith61]); the vector is the longest cross product of
 * two rows of A − λ₀I. Good to about 1e-8 of the largest eigenvalue, plenty for scan noise.
 *
 * @param m xx, xy, xz, yy, yz, zz
 * @param out result, overwritten, so that nothing is allocated a call
 */
export function smallestEigen(m: ArrayLike<number>, out: SmallestEigen): void {
  const [xx, xy, xz, yy, yz, zz] = [m[0], m[1], m[2], m[3], m[4], m[5]];
  const mean = (xx + yy + zz) / 3;
  const offDiagonal = xy * xy + xz * xz + yz * yz;
  const spread = Math.sqrt(((xx - mean) ** 2 + (yy - mean) ** 2 + (zz - mean) ** 2 + 2 * offDiagonal) / 6);
  out.vector.fill(0);
  out.values.fill(mean);
  if (spread === 0) return;
  const [a, b, c] = [(xx - mean) / spread, (yy - mean) / spread, (zz - mean) / spread];
  const [d, e, f] = [xy / spread, xz / spread, yz / spread];
  const determinant = a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e);
  const angle = Math.acos(Math.min(1, Math.max(-1, determinant / 2))) / 3;
  const largest = mean + 2 * spread * Math.cos(angle);
  const smallest = mean + 2 * spread * Math.cos(angle + (2 * Math.PI) / 3);
  out.values[0] = smallest;
  out.values[1] = 3 * mean - largest - smallest;
  out.values[2] = largest;
  nullVector([xx - smallest, xy, xz, yy - smallest, yz, zz - smallest], out.vector);
}

function nullVector([xx, xy, xz, yy, yz, zz]: readonly number[], out: Float64Array): void {
  let longest = 0;
  const keepLonger = (x: number, y: number, z: number): void => {
    const length = Math.hypot(x, y, z);
    if (length <= longest) return;
    longest = length;
    out[0] = x / length;
    out[1] = y / length;
    out[2] = z / length;
  };
  keepLonger(xy * yz - xz * yy, xz * xy - xx * yz, xx * yy - xy * xy);
  keepLonger(xy * zz - xz * yz, xz * xz - xx * zz, xx * yz - xy * xz);
  keepLonger(yy * zz - yz * yz, yz * xz - xy * zz, xy * yz - yy * xz);
}
