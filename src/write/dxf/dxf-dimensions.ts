import type { Bounds } from '../../core/geometry/rings.ts';
import type { Polygon, Vec2 } from '../../core/types.ts';
import { type Dimensions, type Inside, planDimensions } from '../sheet/dimensions.ts';
import { textWidth } from '../sheet/text-width.ts';
import { type DxfDrawing, degrees, legible } from './dxf-drawing.ts';
import { DIMENSION_STYLE, type DimensionStyle } from './dxf-tables.ts';
import type { DxfTags } from './dxf-tags.ts';

/** Distance of the first chain from the plan, and between chains, mm on paper. */
const FIRST_CHAIN = 10;
const NEXT_CHAIN = 8;

/** Types of a rotated dimension whose block is its own, and of one whose text has been put in place. */
const OWN_BLOCK = 32;
const PLACED = OWN_BLOCK + 128;

/** A side of the plan: the angle of its chains to the plan's square axes, and what leads outwards from it. */
const SIDES = {
  bottom: { isAcross: true, edge: 'minY', away: -1 },
  top: { isAcross: true, edge: 'maxY', away: 1 },
  left: { isAcross: false, edge: 'minX', away: -1 },
  right: { isAcross: false, edge: 'maxX', away: 1 },
} as const satisfies Record<
  keyof Dimensions['chains'],
  { isAcross: boolean; edge: keyof Bounds; away: 1 | -1 }
>;

export interface DimensionFacts {
  /** What a storey covers, turned square; metres. */
  readonly covered: readonly Polygon[];
  readonly extent: Bounds;
  /** Rooms and openings, turned as well. */
  readonly inside: Inside;
  /** The angle it was turned by, radians. */
  readonly turn: number;
  /** 100 for 1:100, which the texts are made for. */
  readonly scale: number;
  readonly style: DimensionStyle;
}

/** A distance between two places of a square plan, its line, and what extension lines go from; metres. */
interface Measured {
  readonly from: Vec2;
  readonly to: Vec2;
  /** Ends of the line. */
  readonly lineFrom: Vec2;
  readonly lineTo: Vec2;
  /** Outwards. */
  readonly out: Vec2;
  readonly angle: number;
}

/** Draws the chains around the plan as dimensions: their distances are measured by the CAD program. */
export function drawDxfDimensions(
  drawing: DxfDrawing,
  facts: DimensionFacts,
  nextHandle: () => string,
): void {
  const { covered, extent, inside, turn, scale, style } = facts;
  const { chains } = planDimensions(covered, extent, scale, inside);
  const metresPerMm = scale / 1000;
  const [cos, sin] = [Math.cos(-turn), Math.sin(-turn)];
  const back = (x: number, y: number): Vec2 => [cos * x - sin * y, sin * x + cos * y];
  let count = 0;
  for (const name of Object.keys(SIDES) as (keyof typeof SIDES)[]) {
    const { isAcross, edge, away } = SIDES[name];
    chains[name].forEach((places, k) => {
      const at = (place: number, mm: number) => {
        const aside = extent[edge] + away * mm * metresPerMm;
        return isAcross ? back(place, aside) : back(aside, place);
      };
      const line = FIRST_CHAIN + k * NEXT_CHAIN;
      for (let i = 0; i + 1 < places.length; i++) {
        count++;
        const [from, to] = [at(places[i], 0), at(places[i + 1], 0)];
        const [lineFrom, lineTo] = [at(places[i], line), at(places[i + 1], line)];
        const out = isAcross ? back(0, away) : back(away, 0);
        const angle = legible((isAcross ? 0 : Math.PI / 2) - turn);
        drawDimension(drawing, `*D${count}`, {
          ...{ measured: { from, to, lineFrom, lineTo, out, angle }, style, metresPerMm, nextHandle },
        });
      }
    });
  }
}

interface DrawnDimension {
  readonly measured: Measured;
  readonly style: DimensionStyle;
  readonly metresPerMm: number;
  readonly nextHandle: () => string;
}

/** A dimension and the block that shows it, for programs that do not draw it themselves. */
function drawDimension(
  drawing: DxfDrawing,
  name: string,
  { measured, style, metresPerMm, nextHandle }: DrawnDimension,
): void {
  const { from, to, lineFrom, lineTo, angle } = measured;
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const units = length / drawing.metresPerUnit;
  const height = style.textHeight * metresPerMm;
  const figure = units.toFixed(style.decimals);
  const width = textWidth(figure, height);
  // What is wider than its stretch stands on the line's other side, clear of its neighbours'.
  const isMoved = width > length;
  const above = (isMoved ? -1 : 1) * (style.textGap + style.textHeight / 2) * metresPerMm;
  const at: Vec2 = [
    (lineFrom[0] + lineTo[0]) / 2 - Math.sin(angle) * above,
    (lineFrom[1] + lineTo[1]) / 2 + Math.cos(angle) * above,
  ];
  const half: Vec2 = [width / 2, height / 2];
  const lines = linesOf(measured, style, metresPerMm).map(
    ([a, b]) => [drawing.point(10, a), drawing.point(11, b)] as const,
  );
  const text = drawing.textTags({ lines: [figure], at, height, angle, half });
  const points = [drawing.point(13, from), drawing.point(14, to)].flat();
  const [onLine, middle] = [drawing.point(10, lineTo), drawing.point(11, at)];
  const write = (tags: DxfTags, owner: string) => {
    for (const [a, b] of lines) {
      tags.entity('LINE', owner, '0');
      tags.add([100, 'AcDbLine'], ...a, ...b);
    }
    tags.entity('MTEXT', owner, '0');
    text(tags);
  };
  drawing.blocks.push({ name, handle: nextHandle(), flags: 1, write });
  drawing.add('dimension', (tags, owner, layer) => {
    tags.entity('DIMENSION', owner, layer);
    tags.add(
      [100, 'AcDbDimension'],
      [2, name],
      ...onLine,
      ...middle,
      [70, isMoved ? PLACED : OWN_BLOCK],
      [71, 5],
      [1, ''],
    );
    tags.add([42, drawing.length(length)], [3, DIMENSION_STYLE], [100, 'AcDbAlignedDimension'], ...points);
    tags.add([50, degrees(angle)], [100, 'AcDbRotatedDimension']);
  });
}

/** The line, the two that lead to it, and the ticks. */
function linesOf(
  { from, to, lineFrom, lineTo, out, angle }: Measured,
  { extensionGap, extensionOverhang, tick }: DimensionStyle,
  metresPerMm: number,
): (readonly [Vec2, Vec2])[] {
  const beside = ([x, y]: Vec2, mm: number): Vec2 => [
    x + out[0] * mm * metresPerMm,
    y + out[1] * mm * metresPerMm,
  ];
  const oblique = angle + Math.PI / 4;
  const reach = Math.SQRT2 * tick * metresPerMm;
  const [dx, dy] = [Math.cos(oblique) * reach, Math.sin(oblique) * reach];
  return [
    [lineFrom, lineTo],
    [beside(from, extensionGap), beside(lineFrom, extensionOverhang)],
    [beside(to, extensionGap), beside(lineTo, extensionOverhang)],
    ...[lineFrom, lineTo].map(([x, y]) => [[x - dx, y - dy] as const, [x + dx, y + dy] as const] as const),
  ];
}
