import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from 'three';

/** Metres between lines; the grid coarsens until it has at most this many lines a side. */
const SPACINGS = [1, 5, 10, 50, 100, 500, 1000] as const;
const MOST_LINES = 80;
/** The grid reaches this far past the model, in its own squares. */
const RIM = 2;
/** Below the floor, so that both do not flicker, m. */
const BELOW = 0.02;
const OPACITY = 0.55;

/**
 * A metre grid, on whole metres of the plan.
 *
 * @param bounds least and greatest x, y, z of what stands on it
 */
export function makeGrid([minX, minY, minZ, maxX, maxY]: readonly number[]): LineSegments<
  BufferGeometry,
  LineBasicMaterial
> {
  const longest = Math.max(maxX - minX, maxY - minY);
  const spacing = SPACINGS.find((metres) => longest / metres <= MOST_LINES) ?? SPACINGS.at(-1)!;
  const first = (value: number) => (Math.floor(value / spacing) - RIM) * spacing;
  const last = (value: number) => (Math.ceil(value / spacing) + RIM) * spacing;
  const [x0, x1, y0, y1] = [first(minX), last(maxX), first(minY), last(maxY)];
  const z = minZ - BELOW;
  const ends: number[] = [];
  for (let x = x0; x <= x1; x += spacing) ends.push(x, y0, z, x, y1, z);
  for (let y = y0; y <= y1; y += spacing) ends.push(x0, y, z, x1, y, z);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(ends), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ transparent: true, opacity: OPACITY }));
}
