import { BufferAttribute, BufferGeometry, type Plane, Points, PointsMaterial } from 'three';
import { viridis } from '../write/pictures/viridis.ts';

/** Size of a point, px. */
const POINT_SIZE = 1.6;
/** Full scale of the 16-bit colours the graphics card reads as 0 to 1. */
const FULL = 65_535;
/** Steps of the height scale. */
const HEIGHT_STEPS = 256;

/**
 * Points to look at: in the scan's own colours where it has them, else by height.
 *
 * Colours are stored linear in 16 bit: eight bits would band in the dark.
 *
 * @param positions x, y, z a point, m
 * @param colour r, g, b a point, 0 to 255
 * @param above points on the far side of this plane are not drawn
 */
export function makeCloud(positions: Float32Array, colour: Uint8Array | undefined, above: Plane): Points {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  const colours = colour ? linearColours(colour) : heightColours(positions);
  geometry.setAttribute('color', new BufferAttribute(colours, 3, true));
  const material = new PointsMaterial({ size: POINT_SIZE, sizeAttenuation: false, vertexColors: true });
  material.clippingPlanes = [above];
  return new Points(geometry, material);
}

function linearColours(colour: Uint8Array): Uint16Array {
  const table = Uint16Array.from({ length: 256 }, (_, value) => linear(value));
  const colours = new Uint16Array(colour.length);
  for (let i = 0; i < colour.length; i++) colours[i] = table[colour[i]];
  return colours;
}

function heightColours(positions: Float32Array): Uint16Array {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 2; i < positions.length; i += 3) {
    low = Math.min(low, positions[i]);
    high = Math.max(high, positions[i]);
  }
  const table = Array.from({ length: HEIGHT_STEPS }, (_, i) => viridis(i / (HEIGHT_STEPS - 1)).map(linear));
  const scale = (HEIGHT_STEPS - 1) / Math.max(high - low, Number.EPSILON);
  const colours = new Uint16Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    colours.set(table[Math.round((positions[i + 2] - low) * scale)], i);
  }
  return colours;
}

/** sRGB byte → linear light in 16 bit (IEC 61966-2-1). */
function linear(value: number): number {
  const v = value / 255;
  return Math.round(FULL * (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
}
