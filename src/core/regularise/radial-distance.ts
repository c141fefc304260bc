/**
 * Radial distance simplification [Koning11]: vertices within ε of the last one kept go; both ends stay. Linear.
 *
 * The same as the first pass of `simplify-js`, which the package does not offer by itself.
 *
 * @param line open, x, y a vertex, m
 */
export function radialDistance(line: Float64Array, epsilon: number): Float64Array {
  if (line.length <= 4) return line;
  const kept = new Float64Array(line.length);
  kept[0] = line[0];
  kept[1] = line[1];
  let end = 2;
  for (let i = 2; i < line.length - 2; i += 2) {
    const dx = line[i] - kept[end - 2];
    const dy = line[i + 1] - kept[end - 1];
    if (dx * dx + dy * dy <= epsilon * epsilon) continue;
    kept[end++] = line[i];
    kept[end++] = line[i + 1];
  }
  kept[end++] = line[line.length - 2];
  kept[end++] = line[line.length - 1];
  return kept.slice(0, end);
}

/**
 * The same on a part of a ring, whose end is a vertex like others: vertices within ε of it that the pass would leave before
 * it go too, so no edge of what stays is as short as ε but one between both ends.
 */
export function radialDistanceInRing(line: Float64Array, epsilon: number): Float64Array {
  const kept = radialDistance(line, epsilon);
  const [x, y] = kept.subarray(-2);
  let end = kept.length - 2;
  while (end > 2 && (kept[end - 2] - x) ** 2 + (kept[end - 1] - y) ** 2 <= epsilon * epsilon) end -= 2;
  const shorter = kept.slice(0, end + 2);
  shorter.set([x, y], end);
  return shorter;
}
