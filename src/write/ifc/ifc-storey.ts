import type { Options } from '../../core/params.ts';
import type { Storey } from '../../core/types.ts';
import type { IfcModel } from './ifc-model.ts';
import { LENGTH_DIGITS } from './ifc-shapes.ts';
import { addSlabs } from './ifc-slabs.ts';
import { addSpaces } from './ifc-spaces.ts';
import { addFurniture, addStructures } from './ifc-structures.ts';
import { addWalls } from './ifc-walls.ts';
import type { Ref } from './step-file.ts';
import { fixed, OMITTED } from './step-text.ts';
import type { StoreyModel } from './storey-model.ts';
import { openingParts, wallParts } from './storey-parts.ts';

/**
 * Adds a storey and what is on it. Its things stand in its own coordinates: x and y the plan's, z above its floor.
 *
 * @param elevation of its floor above the building's zero, m
 */
export function addStorey(
  model: IfcModel,
  {
    storey,
    options,
    building,
    elevation,
    roomsBelow,
  }: { storey: Storey; options: Options; building: Ref; elevation: number; roomsBelow: number },
): Ref {
  const place = model.shapes.place(building, [0, 0, elevation]);
  const name = `Storey ${storey.index}`;
  const ref = model.thing(
    'IFCBUILDINGSTOREY',
    { role: 'storey', content: `${storey.index}`, name },
    ...[place, OMITTED, OMITTED, '.ELEMENT.', fixed(elevation, LENGTH_DIGITS)],
  );
  const walls = wallParts(storey);
  const openings = openingParts(storey, walls);
  const part: StoreyModel = { model, storey, place, roomsBelow, walls, openings };
  const spaces = addSpaces(part);
  model.aggregate(ref, spaces);
  const elements = [...addWalls(part), ...addStructures(part), ...addSlabs(part, options)];
  model.contain(ref, [...elements, ...addFurniture(part, spaces)]);
  return ref;
}
