import { ringsOf } from '../../core/geometry/rings.ts';
import type { Polygon } from '../../core/types.ts';
import { wallSection } from '../../solid/sections.ts';
import { decimal, rounded } from '../decimals.ts';
import type { Product } from '../plan-writer.ts';
import { roundedPolygons } from '../rounded-polygons.ts';
import { extentOf } from '../sheet/dimensions.ts';

/** 0.01 mm: extruding the paths gives the very solid. */
const DIGITS = 5;

/**
 * Writes plan.minimal.svg: paths only, in plan metres with y down, as [Stojanovic19] §3.2 extrudes them.
 *
 * One path holds the walls as cut a metre above the floor, after openings were cut and secondary boundaries carved out
 * or added; one path each holds a secondary boundary. three's SVGLoader reads it as it stands; extruded, it lacks the
 * lintels over doors.
 */
export function writeMinimalSvg({ plan }: Product, storey: number): string {
  const { secondary } = plan.storeys[storey];
  const walls = wallSection(plan.storeys[storey]);
  const shapes = [...walls, ...secondary.map(({ outline }) => outline)];
  const { minX, minY, maxX, maxY } =
    shapes.length > 0 ? extentOf(shapes) : { minX: 0, minY: 0, maxX: 1, maxY: 1 };
  const box = [minX, -maxY, maxX - minX, maxY - minY].map(metres).join(' ');
  const paths = secondary.map(
    ({ outline, operation }, i) =>
      `<path id="secondary-${i}" data-operation="${operation}" fill-rule="evenodd" d="${pathData([outline])}"/>`,
  );
  if (walls.length > 0) paths.unshift(`<path id="walls" fill-rule="evenodd" d="${pathData(walls)}"/>`);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${box}">\n${paths.join('\n')}\n</svg>\n`;
}

function pathData(polygons: readonly Polygon[]): string {
  let d = '';
  const written = polygons.flatMap((polygon) => roundedPolygons(polygon, place));
  for (const ring of ringsOf(written.map((one) => one.rounded))) {
    for (let i = 0; i < ring.length; i += 2) {
      d += `${i === 0 ? 'M' : 'L'}${metres(ring[i])} ${metres(-ring[i + 1])}`;
    }
    d += 'Z';
  }
  return d;
}

const place = (x: number, y: number) => [rounded(x, DIGITS), rounded(y, DIGITS)] as const;

const metres = (value: number): string => decimal(value, DIGITS);
