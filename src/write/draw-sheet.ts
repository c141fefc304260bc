import { areaOf, combine } from '../core/geometry/areas.ts';
import type { Circle } from '../core/geometry/circle.ts';
import { circlesOf } from '../core/geometry/ring-arcs.ts';
import { orientRing, ringsOf } from '../core/geometry/rings.ts';
import type { Furniture, Gap, Polygon, RingArc, SecondaryBoundary, Storey } from '../core/types.ts';
import { footprint, openingsAtCut } from '../solid/sections.ts';
import { rounded } from './decimals.ts';
import { drawDimensions, extentOf, planDimensions } from './dimensions.ts';
import { drawOpenings, placeData } from './draw-openings.ts';
import { hatch } from './hatch.ts';
import { labelPoint } from './label-point.ts';
import type { Product } from './plan-writer.ts';
import { roundedPolygons } from './rounded-polygons.ts';
import { HATCHES } from './secondary-hatch.ts';
import {
  type Affine,
  chain,
  mapped,
  SHEET_DIGITS,
  type Sheet,
  type SheetItem,
  type SheetLayer,
  type SheetPath,
  TEXT_SIZES,
} from './sheet.ts';
import { fitPage } from './sheet-page.ts';
import { rotationBy, turnToSquare } from './sheet-turn.ts';
import { textWidth } from './text-width.ts';
import { drawTitleBlock, type LegendEntry } from './title-block.ts';

/** A gap is cut out of walls up to this much thicker than they are said to be, so that rounding leaves no sliver. */
const GAP_OVERLAP = 1.02;
/** Decimals of metres in data attributes: 0.1 mm. */
const DATA_DIGITS = 4;
/** Blank around a room's label, mm. */
const LABEL_BLANK = 1.5;

export interface DrawOptions {
  /** Draws the slice's points beneath the plan; off by default, since a viewer has them anyway. */
  readonly hasPoints?: boolean;
}

/**
 * Draws one storey as an architect would: cut walls solid, inferred stretches dashed, secondary boundaries hatched by
 * what they do to the model, dimensions outside, walls square to the sheet, scale and paper chosen to fit.
 *
 * @param storey index into the plan's storeys
 */
export function drawSheet(product: Product, storey: number, { hasPoints = false }: DrawOptions = {}): Sheet {
  const { plan, slice } = product;
  const drawn = plan.storeys[storey];
  const turn = turnToSquare(plan.storeys.flatMap(({ primary }) => primary));
  const covered = footprint(drawn).map((polygon) => mappedPolygon(polygon, rotationBy(turn)));
  const extent = extentOf(covered.length > 0 ? covered : [{ outer: new Float64Array(2), holes: [] }]);
  // The steps worth a dimension depend on the scale and the scale on their space: the second guess settles it.
  const firstGuess = fitPage(extent, planDimensions(covered, extent, 1).surround);
  const dimensions = planDimensions(covered, extent, firstGuess.scale);
  const { paper, scale, planToSheet: squareToSheet } = fitPage(extent, dimensions.surround);
  const planToSheet = chain(squareToSheet, rotationBy(turn));
  const walls = drawWalls(drawn, planToSheet);
  const openings = drawOpenings(drawn, planToSheet);
  const facts = factsOf(product, drawn, { scale, paper: paper.name, turn });
  const block = drawTitleBlock(
    { ...facts, turn, legend: legendOf(drawn, walls.gaps, openings) },
    paper,
    scale,
  );
  const points: SheetItem[] = hasPoints ? [{ kind: 'points', xy: mapped(slice.xy, planToSheet) }] : [];
  const layers: SheetLayer[] = [
    { name: 'points', isVisible: hasPoints, items: points },
    ...drawFurniture(drawn.furniture ?? [], planToSheet),
    { name: 'walls', isVisible: true, items: walls.cut },
    { name: 'secondary', isVisible: true, items: drawSecondary(drawn.secondary, planToSheet) },
    { name: 'gaps', isVisible: true, items: walls.gaps },
    { name: 'openings', isVisible: true, items: openings },
    { name: 'dimensions', isVisible: true, items: drawDimensions(dimensions, extent, squareToSheet) },
    { name: 'labels', isVisible: true, items: drawLabels(drawn, planToSheet, scale) },
    { name: 'title', isVisible: true, items: block },
  ];
  const description = [facts.title, ...facts.lines].join('. ');
  return { paper, scale, storey, title: facts.title, description, planToSheet, layers };
}

/**
 * Cut walls, and the stretches of wall along gaps, which no point supports; openings and secondary boundaries are left
 * free.
 */
function drawWalls(storey: Storey, planToSheet: Affine): { cut: SheetItem[]; gaps: SheetItem[] } {
  const section = combine(
    'difference',
    storey.walls.map(({ outline }) => outline),
    [...storey.secondary.map(({ outline }) => outline), ...openingsAtCut(storey)],
  );
  const curves = storey.walls.flatMap(({ outline }) => circlesOf(outline));
  const thickness = Math.max(0, ...storey.walls.map((wall) => wall.thickness));
  const stretches = storey.gaps.map((gap) => stretchOf(gap, thickness * GAP_OVERLAP));
  const cut = stretches.length === 0 ? section : combine('difference', section, stretches);
  const inferred = stretches.flatMap((stretch, gap) =>
    combine('intersection', section, [stretch]).map((polygon) => ({ polygon, gap })),
  );
  return {
    cut: cut.map((polygon, i) => ({
      ...({ kind: 'path', style: 'wall', ...shapeOf(polygon, planToSheet, curves), isClosed: true } as const),
      ...{ id: `wall-${i}`, data: { kind: 'wall' } },
    })),
    gaps: inferred.map(({ polygon, gap }, i) => ({
      ...({ kind: 'path', style: 'inferred', ...shapeOf(polygon, planToSheet, curves) } as const),
      isClosed: true,
      ...{ id: `gap-${i}`, data: { kind: 'gap', gap, ...placeData(storey.gaps[gap]) } },
    })),
  };
}

/** The rectangle along a gap, as wide as the wall to both sides. */
function stretchOf({ from, to }: Gap, reach: number): Polygon {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length === 0) return { outer: new Float64Array(0), holes: [] };
  const [nx, ny] = [(-dy / length) * reach, (dx / length) * reach];
  const outer = Float64Array.of(
    ...[from[0] - nx, from[1] - ny, to[0] - nx, to[1] - ny],
    ...[to[0] + nx, to[1] + ny, from[0] + nx, from[1] + ny],
  );
  return { outer: orientRing(outer, 'counter-clockwise'), holes: [] };
}

function drawSecondary(secondary: readonly SecondaryBoundary[], planToSheet: Affine): SheetItem[] {
  return secondary.flatMap(({ outline, operation, type }, i): SheetItem[] => {
    const rings = ringsOf([outline]).map((ring) => mapped(ring, planToSheet));
    const lines = HATCHES[operation].flatMap(({ angle, spacing }) => hatch(rings, angle, spacing));
    const data = { kind: 'secondary', operation, type };
    return [
      { kind: 'path', style: 'hatch', lines, isClosed: false },
      {
        ...({ kind: 'path', style: 'secondary', ...shapeOf(outline, planToSheet) } as const),
        ...{ isClosed: true, id: `secondary-${i}`, data },
      },
    ];
  });
}

/** A layer of footprints; none where no furniture is known. */
function drawFurniture(furniture: readonly Furniture[], planToSheet: Affine): SheetLayer[] {
  const items = furniture.map(
    ({ outline, height, room }, i): SheetItem => ({
      ...({
        kind: 'path',
        style: 'furniture',
        ...shapeOf(outline, planToSheet),
        isClosed: true,
      } as const),
      ...{ id: `furniture-${i}`, data: { kind: 'furniture', height: rounded(height, DATA_DIGITS), room } },
    }),
  );
  return items.length > 0 ? [{ name: 'furniture', isVisible: true, items }] : [];
}

/** Room names over areas; where no rooms are known, the area within the primary boundary. */
function drawLabels(storey: Storey, planToSheet: Affine, scale: number): SheetItem[] {
  const obstacles = storey.secondary.map(({ outline }) => outline);
  const rooms =
    storey.rooms.length > 0 ? storey.rooms : storey.primary.map((outline) => ({ name: '', outline }));
  return rooms.flatMap(({ name, outline }): SheetItem[] => {
    const area = `${areaOf([outline]).toFixed(1)} m²`;
    const lines = name === '' ? [area] : [name, area];
    const free = combine('difference', [outline], obstacles);
    const places = (free.length > 0 ? free : [outline]).map(labelPoint);
    const [px, py, distance] = places.reduce((best, place) => (place[2] > best[2] ? place : best));
    const width = Math.max(...lines.map((line) => textWidth(line, TEXT_SIZES.room)));
    const [x, y] = mapped(Float64Array.of(px, py), planToSheet);
    // Too narrow for a line of text: turned, since such rooms are mostly corridors.
    const isNarrow = (2 * distance * 1000) / scale < width + 2 * LABEL_BLANK;
    return isNarrow && lines.length === 1 && !isWiderThanDeep(mappedPolygon(outline, planToSheet))
      ? [
          {
            kind: 'text',
            size: 'label',
            x: x + TEXT_SIZES.label / 3,
            y,
            text: area,
            anchor: 'middle',
            isUpright: true,
          },
        ]
      : lines.map((text, i) => ({
          kind: 'text',
          size: i === 0 ? 'room' : 'label',
          x,
          y: y + TEXT_SIZES.room / 3 + (i - (lines.length - 1) / 2) * (TEXT_SIZES.room + 1),
          text,
          anchor: 'middle',
        }));
  });
}

/**
 * The rings of a polygon as drawn, in the decimals that the sheet is written with; rounded with y up, as in the plan.
 *
 * @param curves circles of the plan that it may follow
 */
function shapeOf(
  polygon: Polygon,
  planToSheet: Affine,
  curves: readonly Circle[] = circlesOf(polygon),
): Pick<SheetPath, 'lines' | 'arcs'> {
  const up = (x: number, y: number) => {
    const [across, down] = mapped(Float64Array.of(x, y), planToSheet);
    return [across, -down] as const;
  };
  const place = (x: number, y: number) => {
    const [across, above] = up(x, y);
    return [rounded(across, SHEET_DIGITS), rounded(above, SHEET_DIGITS)] as const;
  };
  const unitsPerMetre = Math.hypot(planToSheet[0], planToSheet[1]);
  const circles = curves.map(({ cx, cy, radius }): Circle => {
    const [across, above] = up(cx, cy);
    return { cx: across, cy: above, radius: radius * unitsPerMetre };
  });
  const written = roundedPolygons(polygon, place, { circles, metresPerUnit: 1 / unitsPerMetre });
  const lines: Float64Array[] = [];
  const arcs: RingArc[] = [];
  for (const { rounded: piece } of written) {
    for (const arc of piece.arcs ?? []) {
      const [x, y] = arc.centre;
      arcs.push({ ...arc, ring: lines.length + arc.ring, centre: [x, -y] });
    }
    for (const ring of ringsOf([piece])) lines.push(ring.map((value, i) => (i % 2 === 0 ? value : -value)));
  }
  return arcs.length > 0 ? { lines, arcs } : { lines };
}

function isWiderThanDeep(outline: Polygon): boolean {
  const { minX, minY, maxX, maxY } = extentOf([outline]);
  return maxX - minX > maxY - minY;
}

function legendOf(
  { walls, secondary, openings, furniture = [] }: Storey,
  gaps: readonly SheetItem[],
  drawn: readonly SheetItem[],
): LegendEntry[] {
  const operations = (['subtract', 'add', 'independent'] as const).filter((operation) =>
    secondary.some((boundary) => boundary.operation === operation),
  );
  return [
    ...(walls.length > 0 ? (['wall'] as const) : []),
    ...(gaps.length > 0 ? (['inferred'] as const) : []),
    ...operations,
    ...(['door', 'window', 'passage'] as const).filter(
      (kind) => drawn.length > 0 && openings.some(({ type }) => type === kind),
    ),
    ...(furniture.length > 0 ? (['furniture'] as const) : []),
  ];
}

function factsOf(
  { name, plan }: Product,
  storey: Storey,
  page: { scale: number; paper: string; turn: number },
): { title: string; lines: string[] } {
  const count = plan.storeys.length;
  const inner = areaOf(combine('union', storey.primary));
  const outer = areaOf(footprint(storey));
  const turned = page.turn === 0 ? '' : `, turned by ${Math.abs((page.turn * 180) / Math.PI).toFixed(1)}°`;
  const points = plan.source.pointsKept.toLocaleString('en-GB');
  return {
    title: name.trim() === '' ? 'Floor plan' : name,
    lines: [
      count === 1 ? 'Floor plan' : `Floor plan, storey ${storey.index} of 0 to ${count - 1}`,
      `Inside ${inner.toFixed(1)} m², with walls ${outer.toFixed(1)} m², height ${storey.height.toFixed(2)} m`,
      `Scale 1:${page.scale} on ${page.paper}${turned}, dimensions in metres`,
      `Source: ${plan.source.name}, ${points} points`,
      'Approximate: drawn from a point cloud',
    ],
  };
}

function mappedPolygon({ outer, holes }: Polygon, map: Affine): Polygon {
  return { outer: mapped(outer, map), holes: holes.map((hole) => mapped(hole, map)) };
}
