import { areaOf } from '../../core/geometry/areas.ts';
import type { OpeningBox } from '../../solid/opening-boxes.ts';
import type { IfcModel } from './ifc-model.ts';
import { addOpening, type PlacedWall } from './ifc-openings.ts';
import { asBoolean, asRatio } from './ifc-properties.ts';
import type { Ref } from './step-file.ts';
import { OMITTED } from './step-text.ts';
import { contentOf, EVIDENCE, type StoreyModel } from './storey-model.ts';
import { netOf, type OpeningPart, type WallPart } from './storey-parts.ts';

/** @returns walls, and the doors and windows in them */
export function addWalls({ model, storey, place, walls, openings }: StoreyModel): Ref[] {
  const placed = new Map<number, PlacedWall>();
  const cuts = cutsOf(walls, openings);
  walls.forEach((part, i) => {
    if (part.pieces.length === 0) return;
    const own = model.shapes.place(place);
    const ref = model.thing(
      'IFCWALL',
      { role: 'wall', content: contentOf(storey, part.wall.outline), name: `Wall ${i + 1}` },
      ...[own, model.shapes.prisms(part.pieces, storey.height, 'wall'), OMITTED, '.NOTDEFINED.'],
    );
    placed.set(i, { ref, place: own, part });
    measureWall(model, ref, { part, height: storey.height, cuts: cuts[i] });
  });
  const numbers = { door: 0, window: 0, passage: 0 };
  const fillings = openings.flatMap((part) => {
    const { type } = part.opening;
    numbers[type]++;
    const name = `${type[0].toUpperCase()}${type.slice(1)} ${numbers[type]}`;
    return addOpening(model, { place, walls: placed }, part, name);
  });
  return [...[...placed.values()].map(({ ref }) => ref), ...fillings];
}

/** The boxes of the openings through each wall. */
function cutsOf(walls: readonly WallPart[], openings: readonly OpeningPart[]): OpeningBox[][] {
  const cuts = walls.map((): OpeningBox[] => []);
  for (const { box, walls: through } of openings) {
    if (box !== null) for (const i of through) cuts[i].push(box);
  }
  return cuts;
}

interface WallMeasures {
  readonly part: WallPart;
  readonly height: number;
  readonly cuts: readonly OpeningBox[];
}

/** Length is along the middle: a wall's foot over its thickness. */
function measureWall(
  model: IfcModel,
  ref: Ref,
  { part: { wall, pieces, isExternal }, height, cuts }: WallMeasures,
): void {
  const { thickness, confidence, isThicknessInferred } = wall;
  const { properties } = model;
  const foot = areaOf(pieces);
  const net = netOf(pieces, cuts, height);
  properties.quantities(ref, 'Qto_WallBaseQuantities', [
    ['Length', 'length', foot / thickness],
    ['Width', 'length', thickness],
    ['Height', 'length', height],
    ['GrossFootprintArea', 'area', foot],
    ['NetFootprintArea', 'area', net.foot],
    ['GrossSideArea', 'area', (foot / thickness) * height],
    ['NetSideArea', 'area', net.volume / thickness],
    ['GrossVolume', 'volume', foot * height],
    ['NetVolume', 'volume', net.volume],
  ]);
  if (isExternal !== undefined) {
    properties.properties(ref, 'Pset_WallCommon', [['IsExternal', asBoolean(isExternal)]]);
  }
  properties.properties(ref, EVIDENCE, [
    ['Confidence', asRatio(confidence)],
    ['ThicknessInferred', asBoolean(isThicknessInferred === true)],
  ]);
  if (thickness > 0) model.layer(ref, thickness);
}
