import type { StageContext } from '../../core/context.ts';
import { type Bounds, boundsOfAll } from '../../core/geometry/rings.ts';
import { rotationBy } from '../../core/geometry/square-turn.ts';
import type { Options } from '../../core/params.ts';
import { type Affine, chain, mapped, type SheetItem, TEXT_SIZES } from '../../core/sheet.ts';
import type { Opening, Polygon, Storey, Warning } from '../../core/types.ts';
import { footprint } from '../../solid/sections.ts';
import { drawDimensions, extentOf, type Inside, NO_DIMENSIONS, planDimensions } from './dimensions.ts';
import { keyHeight } from './room-key.ts';
import { type PlacedLabels, placeLabels } from './room-labels.ts';
import { fitPage, type Page } from './sheet-page.ts';
import { textWidth } from './text-width.ts';

/** A key makes room for itself, whereupon more may need one. */
const KEY_ROUNDS = 3;

/** Where the plan stands on which paper, what is measured around it and what its rooms are called. */
export function layOut(
  drawn: Storey,
  { turn, options }: { turn: number; options: Options },
  warn: StageContext['warn'],
): { page: Page; outer: SheetItem[] } & PlacedLabels {
  const toSquare = rotationBy(turn);
  const covered = footprint(drawn).map((polygon) => mappedPolygon(polygon, toSquare));
  const extent = extentOf(covered.length > 0 ? covered : [{ outer: new Float64Array(2), holes: [] }]);
  const inside = turnedInside(drawn, toSquare);
  const unit = options.displayUnits;
  const measure = (scale: number) =>
    options.dimensions === 'none' ? NO_DIMENSIONS : planDimensions(covered, extent, scale, inside);
  // The steps worth a dimension depend on the scale and the scale on their space: the second guess settles it.
  const dimensions = measure(fitPage(extent, measure(1).surround, options).scale);
  let band = 0;
  for (let round = 1; ; round++) {
    const surround = { ...dimensions.surround, bottom: dimensions.surround.bottom + band };
    const warnings: Warning[] = [];
    const page = fitPage(extent, surround, options, (warning) => warnings.push(warning));
    const { planToSheet: squareToSheet } = page;
    const outer = drawDimensions(dimensions, extent, { planToSheet: squareToSheet, unit });
    const placed = placeLabels({
      ...{ storey: drawn, planToSheet: chain(squareToSheet, rotationBy(turn)), unit },
      ...{ extent: onSheet(extent, squareToSheet), taken: outer.flatMap(boxesOf) },
    });
    const needed = keyHeight(placed.key, page.paper);
    if (needed <= band || round === KEY_ROUNDS) {
      warnings.forEach(warn);
      return { page, outer, ...placed };
    }
    band = needed;
  }
}

function turnedInside({ rooms, openings }: Storey, turn: Affine): Inside {
  const at = ([x, y]: Opening['from']): Opening['from'] => {
    const [across, ahead] = mapped(Float64Array.of(x, y), turn);
    return [across, ahead];
  };
  return {
    rooms: rooms.map((room) => ({ ...room, outline: mappedPolygon(room.outline, turn) })),
    openings: openings.map((opening) => ({ ...opening, from: at(opening.from), to: at(opening.to) })),
  };
}

/** What an item takes of the sheet, mm. */
function boxesOf(item: SheetItem): Bounds[] {
  if (item.kind === 'path') return [boundsOfAll(item.lines)];
  if (item.kind === 'points') return [];
  const { x, y, text, isUpright } = item;
  const [half, high] = [textWidth(text, TEXT_SIZES[item.size]) / 2, TEXT_SIZES[item.size]];
  return isUpright
    ? [{ minX: x - high, maxX: x, minY: y - half, maxY: y + half }]
    : [{ minX: x - half, maxX: x + half, minY: y - high, maxY: y }];
}

/** A box of the plan as it lies on the sheet, whose y runs down. */
function onSheet({ minX, minY, maxX, maxY }: Bounds, planToSheet: Affine): Bounds {
  const [left, bottom, right, top] = mapped(Float64Array.of(minX, minY, maxX, maxY), planToSheet);
  return { minX: left, minY: top, maxX: right, maxY: bottom };
}

function mappedPolygon({ outer, holes }: Polygon, map: Affine): Polygon {
  return { outer: mapped(outer, map), holes: holes.map((hole) => mapped(hole, map)) };
}
