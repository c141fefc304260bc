import type { StageContext } from '../../core/context.ts';
import { areaOf, combine } from '../../core/geometry/areas.ts';
import type { Circle } from '../../core/geometry/circle.ts';
import { circlesOf } from '../../core/geometry/ring-arcs.ts';
import { perimeter, ringsOf } from '../../core/geometry/rings.ts';
import { rotationBy } from '../../core/geometry/square-turn.ts';
import {
  type Affine,
  chain,
  mapped,
  SHEET_DIGITS,
  type Sheet,
  type SheetItem,
  type SheetLayer,
  type SheetPath,
} from '../../core/sheet.ts';
import type { Furniture, Polygon, RingArc, SecondaryBoundary, Storey } from '../../core/types.ts';
import { footprint } from '../../solid/sections.ts';
import { rounded } from '../decimals.ts';
import type { Product } from '../plan-writer.ts';
import { printable } from '../printable.ts';
import { roundedPolygons } from '../rounded-polygons.ts';
import { cutWalls } from './cut-walls.ts';
import { drawOpenings, placeData } from './draw-openings.ts';
import { hatch } from './hatch.ts';
import { layOut } from './lay-out.ts';
import { formatArea, formatDimension } from './measure-words.ts';
import { drawRoomDimensions } from './room-dimensions.ts';
import { drawKey } from './room-key.ts';
import { drawnName } from './room-labels.ts';
import { HATCHES } from './secondary-hatch.ts';
import { sheetTurn } from './sheet-turn.ts';
import { drawTitleBlock, type LegendEntry, titleRows } from './title-block.ts';

/** Decimals of metres in data attributes: 0.1 mm. */
const DATA_DIGITS = 4;

/** What a sheet is drawn from. */
export type SheetFacts = Pick<Product, 'plan' | 'slice' | 'options' | 'name'>;

/** Draws every storey on a sheet of its own, lowest first. */
export function drawSheets(facts: SheetFacts, warn: StageContext['warn'] = () => {}): Sheet[] {
  return facts.plan.storeys.map((_, storey) => drawSheet(facts, storey, warn));
}

/** `1:100 on A3` for each sheet. */
export function saySheets(sheets: readonly Sheet[]): string {
  return [...new Set(sheets.map(({ scale, paper }) => `1:${scale} on ${paper.name}`))].join(', ');
}

/**
 * Draws one storey as an architect would: cut walls solid, inferred stretches dashed, secondary boundaries hatched by
 * what they do to the model, rooms with name and area, dimensions outside and inside, walls square to the sheet, scale
 * and paper chosen to fit.
 *
 * @param storey index into the plan's storeys
 * @param warn told where the scale asked for does not fit
 */
export function drawSheet(facts: SheetFacts, storey: number, warn: StageContext['warn'] = () => {}): Sheet {
  const { plan, slice, options } = facts;
  const drawn = plan.storeys[storey];
  const turn = sheetTurn(plan.storeys);
  const { page, outer, labels, key } = layOut(drawn, { turn, options }, warn);
  const { paper, scale, planToSheet: squareToSheet } = page;
  const planToSheet = chain(squareToSheet, rotationBy(turn));
  const unit = options.displayUnits;
  const walls = drawWalls(drawn, planToSheet);
  const openings = drawOpenings(drawn, planToSheet);
  warnOfCutNames(drawn, warn);
  const inner = drawRoomDimensions({
    ...{ rooms: options.dimensions === 'all' ? drawn.rooms.map(({ outline }) => outline) : [] },
    ...{ structures: drawn.secondary.map(({ outline }) => outline), planToSheet },
    furniture: (drawn.furniture ?? []).map(({ outline }) => outline),
    ...{ taken: labels.map(({ box }) => box), figure: (mm) => formatDimension((mm * scale) / 1000, unit) },
  });
  const words = titleWords(facts, drawn, { scale, paper: paper.name, turn });
  if (storey === 0) warnOfCutTitle(words.title, warn);
  const legend = legendOf(drawn, walls.gaps, openings);
  const block = drawTitleBlock({ ...words, ...headingOf(facts, turn), unit, legend }, paper, scale);
  const points: SheetItem[] = options.drawPoints
    ? [{ kind: 'points', xy: mapped(slice.xy, planToSheet) }]
    : [];
  const layers: SheetLayer[] = [
    { name: 'points', isVisible: options.drawPoints, items: points },
    ...drawFurniture(drawn.furniture ?? [], planToSheet),
    { name: 'walls', isVisible: true, items: walls.cut },
    { name: 'secondary', isVisible: true, items: drawSecondary(drawn.secondary, planToSheet) },
    { name: 'gaps', isVisible: true, items: walls.gaps },
    { name: 'openings', isVisible: true, items: openings },
    { name: 'dimensions', isVisible: true, items: [...outer, ...inner] },
    {
      name: 'labels',
      isVisible: true,
      items: [...labels.flatMap(({ items }) => items), ...drawKey(key, paper)],
    },
    { name: 'title', isVisible: true, items: block },
  ];
  const description = [words.title, ...words.lines].join('. ');
  return { paper, scale, storey, title: words.title, description, planToSheet, layers };
}

function warnOfCutNames({ rooms }: Storey, warn: StageContext['warn']): void {
  const cut = rooms.flatMap(({ name }) => (drawnName(name) === printable(name) ? [] : [drawnName(name)]));
  if (cut.length === 0) return;
  const others = cut.length > 1 ? ` and of ${cut.length - 1} more` : '';
  warn({
    code: 'sheet/name-cut',
    message: `The name of the room “${cut[0]}”${others} is too long for the drawing, which shows its beginning.`,
    hint: 'Give the room a shorter name.',
  });
}

function warnOfCutTitle(title: string, warn: StageContext['warn']): void {
  const { rows } = titleRows(title);
  if (rows.join(' ') === printable(title)) return;
  warn({
    code: 'sheet/name-cut',
    message: `The title is too long for the drawing, which shows “${rows.join(' ')}”.`,
    hint: 'Give the project a shorter name.',
  });
}

/**
 * Cut walls, and the stretches of wall along gaps, which no point supports; openings and secondary boundaries are left
 * free.
 */
function drawWalls(storey: Storey, planToSheet: Affine): { cut: SheetItem[]; gaps: SheetItem[] } {
  const { cut, inferred } = cutWalls(storey);
  const curves = storey.walls.flatMap(({ outline }) => circlesOf(outline));
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

/** The title and the lines under it. */
function titleWords(
  { name, plan, options }: SheetFacts,
  storey: Storey,
  page: { scale: number; paper: string; turn: number },
): { title: string; lines: string[] } {
  const unit = options.displayUnits;
  const count = plan.storeys.length;
  const inner = formatArea(areaOf(combine('union', storey.primary)), unit);
  const outer = formatArea(areaOf(footprint(storey)), unit);
  const height = unit === 'm' ? `${storey.height.toFixed(2)} m` : formatDimension(storey.height, unit);
  const turned = page.turn === 0 ? '' : `, turned by ${Math.abs((page.turn * 180) / Math.PI).toFixed(1)}°`;
  const points = plan.source.pointsKept.toLocaleString('en-GB');
  const date = options.sheetDate.trim();
  const project = options.project.trim();
  return {
    title: project || (name.trim() === '' ? 'Floor plan' : name),
    lines: [
      [count === 1 ? 'Floor plan' : `Floor plan, storey ${storey.index} (0 to ${count - 1})`, date]
        .filter((part) => part !== '')
        .join(', '),
      `Inside ${inner}, with walls ${outer}, height ${height}`,
      `Scale 1:${page.scale} on ${page.paper}${turned}, ${unit === 'm' ? 'metres' : 'feet and inches'}`,
      `Source: ${plan.source.name}, ${points} points`,
      accuracyNote(storey),
    ],
  };
}

/** How far the drawing can be trusted: the share of what rooms are bounded by that no point shows. */
function accuracyNote({ rooms, primary, gaps }: Storey): string {
  const bounds = rooms.length > 0 ? rooms.map(({ outline }) => outline) : primary;
  const length = ringsOf(bounds).reduce((sum, ring) => sum + perimeter(ring), 0);
  const inferred = gaps.reduce((sum, { width }) => sum + width, 0);
  if (inferred === 0 || length === 0) return 'Approximate: from a point cloud';
  const share = Math.max(1, Math.round((100 * Math.min(inferred, length)) / length));
  return `Approximate: from a point cloud; ${share} % inferred, dashed`;
}

/** What the arrow shows: north where it is known, else the scan's y axis. Radians counter-clockwise from up. */
function headingOf({ plan, options }: SheetFacts, turn: number): { heading: number; headingName: string } {
  if (options.north !== 'auto') return { heading: turn - (options.north * Math.PI) / 180, headingName: 'N' };
  return { heading: turn, headingName: plan.frame.crs === undefined ? 'y' : 'N' };
}
