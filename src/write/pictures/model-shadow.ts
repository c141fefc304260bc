import { combine } from '../../core/geometry/areas.ts';
import { isCounterClockwise, orientRing } from '../../core/geometry/rings.ts';
import type { Polygon } from '../../core/types.ts';
import type { GroupRings, SolidSlab } from './solid-slabs.ts';

/**
 * The shadow that upright slabs cast on a level beneath them under parallel light, as areas on that level.
 *
 * Each section is swept from where its lower end casts it to where its upper end does: exact for upright prisms.
 *
 * @param ground where shadows can fall: rings x, y, m, on the level `z`
 * @param perMetre how far a metre of height moves the shadow: x, y, m
 */
export function castShadow(
  ground: readonly Float64Array[],
  z: number,
  slabs: readonly SolidSlab[],
  perMetre: readonly [x: number, y: number],
): Polygon[] {
  const swept = slabs
    .filter(({ low }) => low >= z)
    .flatMap(({ sections, low, high }) =>
      sections.flatMap((section) => sweep(section, shift(perMetre, low - z), shift(perMetre, high - z))),
    );
  return swept.length === 0 ? [] : combine('intersection', swept, asPolygons(ground));
}

type Shift = readonly [x: number, y: number];

const shift = ([x, y]: Shift, height: number): Shift => [x * height, y * height];

function sweep({ rings }: GroupRings, from: Shift, to: Shift): Polygon[] {
  const across: Shift = [to[0] - from[0], to[1] - from[1]];
  const sides = rings.flatMap((ring) =>
    monotoneChains(ring, across).map((chain) => {
      const there = moved(chain, from);
      const back = backwards(moved(chain, to));
      const outline = Float64Array.of(...there, ...back);
      return { outer: orientRing(outline, 'counter-clockwise'), holes: [] };
    }),
  );
  return [...asPolygons(rings.map((ring) => moved(ring, to))), ...sides];
}

/** Runs of a ring's edges that all pass the direction from one side: what each sweeps is a simple ring. */
function monotoneChains(ring: Float64Array, [dx, dy]: Shift): Float64Array[] {
  const n = ring.length;
  const sideOf = (i: number): number =>
    Math.sign((ring[(i + 2) % n] - ring[i]) * dy - (ring[(i + 3) % n] - ring[i + 1]) * dx);
  let start = 0;
  while (start < n && sideOf(start) === sideOf((start + n - 2) % n)) start += 2;
  const chains: number[][] = [];
  let side = 0;
  for (let k = 0; k < n; k += 2) {
    const i = (start + k) % n;
    const own = sideOf(i);
    if (own === 0) side = 0;
    else if (own === side) chains.at(-1)!.push(ring[(i + 2) % n], ring[(i + 3) % n]);
    else {
      side = own;
      chains.push([ring[i], ring[i + 1], ring[(i + 2) % n], ring[(i + 3) % n]]);
    }
  }
  return chains.map((chain) => Float64Array.from(chain));
}

/** The vertices in the opposite order. */
function backwards(line: Float64Array): Float64Array {
  return line.map((_, i) => line[line.length - 2 - i + 2 * (i % 2)]);
}

function moved(ring: Float64Array, [x, y]: Shift): Float64Array {
  return ring.map((value, i) => value + (i % 2 === 0 ? x : y));
}

/** Rings as areas: those that turn counter-clockwise around what they hold, the others as holes of the first. */
function asPolygons(rings: readonly Float64Array[]): Polygon[] {
  const outers = rings.filter(isCounterClockwise);
  const holes = rings.filter((ring) => !isCounterClockwise(ring));
  // Windings add up, so it does not matter which outer ring the holes go with.
  return outers.map((outer, i) => ({ outer, holes: i === 0 ? holes : [] }));
}
