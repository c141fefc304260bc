/**
 * Parallel lines across an area, by the even-odd rule; lines of neighbouring areas meet, since all start from the
 * sheet's corner.
 *
 * @param rings x, y a vertex, mm
 * @param angle of the lines, radians, y down
 * @param spacing mm
 * @returns one line of two points each. Rings' vertices × lines they span.
 */
export function hatch(rings: readonly Float64Array[], angle: number, spacing: number): Float64Array[] {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const crossings = new Map<number, number[]>();
  for (const ring of rings) {
    for (let i = 0; i < ring.length; i += 2) {
      const j = (i + 2) % ring.length;
      const from = [c * ring[i] + s * ring[i + 1], c * ring[i + 1] - s * ring[i]] as const;
      const to = [c * ring[j] + s * ring[j + 1], c * ring[j + 1] - s * ring[j]] as const;
      crossEdge(from, to, spacing, crossings);
    }
  }
  const lines: Float64Array[] = [];
  for (const row of [...crossings.keys()].sort((a, b) => a - b)) {
    const along = crossings.get(row)!.sort((a, b) => a - b);
    const v = row * spacing;
    for (let i = 0; i + 1 < along.length; i += 2) {
      const [u, w] = [along[i], along[i + 1]];
      lines.push(Float64Array.of(c * u - s * v, s * u + c * v, c * w - s * v, s * w + c * v));
    }
  }
  return lines;
}

/** Notes where an edge crosses the rows; half-open, so a vertex on a row counts once. */
function crossEdge(
  from: readonly [number, number],
  to: readonly [number, number],
  spacing: number,
  crossings: Map<number, number[]>,
): void {
  const [low, high] = from[1] < to[1] ? [from, to] : [to, from];
  for (let row = Math.ceil(low[1] / spacing); row * spacing < high[1]; row++) {
    const share = (row * spacing - low[1]) / (high[1] - low[1]);
    const at = low[0] + share * (high[0] - low[0]);
    const known = crossings.get(row);
    if (known === undefined) crossings.set(row, [at]);
    else known.push(at);
  }
}
