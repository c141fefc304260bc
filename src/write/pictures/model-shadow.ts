import { isCounterClockwise, orientRing } from '../../core/geometry/rings.ts';
import type { Polygon } from '../../core/types.ts';
import { combine } from '../../solid/planar.ts';
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
  const sides = rings.flatMap((ring) => {
    const quads: Polygon[] = [];
    for (let i = 0; i < ring.length; i += 2) {
      const j = (i + 2) % ring.length;
      const quad = Float64Array.of(
        ...[ring[i] + from[0], ring[i + 1] + from[1], ring[j] + from[0], ring[j + 1] + from[1]],
        ...[ring[j] + to[0], ring[j + 1] + to[1], ring[i] + to[0], ring[i + 1] + to[1]],
      );
      quads.push({ outer: orientRing(quad, 'counter-clockwise'), holes: [] });
    }
    return quads;
  });
  return [...asPolygons(rings.map((ring) => moved(ring, to))), ...sides];
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
