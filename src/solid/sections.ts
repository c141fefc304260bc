import { polygonArea } from '../core/geometry/rings.ts';
import type { Polygon, SecondaryBoundary, Storey } from '../core/types.ts';
import { combine, type PlanarOperation, separatePinches } from './planar.ts';

/** Cross-section of a storey's walls once secondary boundaries are carved out or added: disjoint polygons, metres. */
export function wallSection(storey: Storey): Polygon[] {
  const walls = storey.walls.map(({ outline }) => outline);
  return carve(combine('union', walls), storey.secondary);
}

/** All that a storey covers, walls included; courtyards stay open. Disjoint polygons, metres. */
export function footprint(storey: Storey): Polygon[] {
  const walls = storey.walls.map(({ outline }) => outline);
  const rooms = storey.rooms.map(({ outline }) => outline);
  return combine('union', [...storey.primary, ...rooms, ...walls]);
}

/**
 * An area after the secondary boundaries, in their order: subtracted ones are cut out, added ones joined on
 * ([Stojanovic19] §3.2); independent ones leave it alone.
 *
 * @returns disjoint polygons fit for extrusion, the largest first
 */
export function carve(base: readonly Polygon[], secondary: readonly SecondaryBoundary[]): Polygon[] {
  let section = [...base];
  for (const { outline, operation } of secondary) {
    const planar = PLANAR[operation];
    if (planar !== null) section = combine(planar, section, [outline]);
  }
  return separatePinches(section).sort((a, b) => polygonArea(b) - polygonArea(a));
}

const PLANAR: Record<SecondaryBoundary['operation'], PlanarOperation | null> = {
  subtract: 'difference',
  add: 'union',
  independent: null,
};
