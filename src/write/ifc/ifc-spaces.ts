import { roomOfGap } from '../../core/find-room.ts';
import { areaOf, combine } from '../../core/geometry/areas.ts';
import { boundsOf, perimeter, ringsOf } from '../../core/geometry/rings.ts';
import { automaticName } from '../../core/room-names.ts';
import type { Room, Storey } from '../../core/types.ts';
import type { IfcModel } from './ifc-model.ts';
import { asBoolean, asIdentifier, asLength, asRatio } from './ifc-properties.ts';
import { filePolygons } from './ifc-shapes.ts';
import type { Ref } from './step-file.ts';
import { label, OMITTED } from './step-text.ts';
import { EVIDENCE, type StoreyModel } from './storey-model.ts';
import { areNear, doorwayWidths } from './storey-parts.ts';

/** A space a room, in their order, named by its number in the room schedule; one without area has no shape. */
export function addSpaces({ model, storey, place, openings, roomsBelow }: StoreyModel): Ref[] {
  const doorways = doorwayWidths(storey.rooms, openings);
  return storey.rooms.map((room, i) => {
    const number = `${roomsBelow + i + 1}`;
    const space = model.thing(
      'IFCSPACE',
      // Called otherwise, it stays the same space.
      { role: 'space', content: `${storey.index} ${automaticName(i)}`, name: number, longName: room.name },
      ...[model.shapes.place(place), model.shapes.prisms(filePolygons(room.outline), room.height, 'space')],
      ...[label(room.name), '.ELEMENT.', '.INTERNAL.', OMITTED],
    );
    measureSpace(model, space, { room, storey, doorways: doorways[i] });
    const unseen = storey.gaps.filter((gap) => roomOfGap(storey.rooms, gap) === i);
    model.properties.properties(space, 'Pset_SpaceCommon', [
      ['Reference', asIdentifier(number)],
      ['IsExternal', asBoolean(false)],
    ]);
    model.properties.properties(space, EVIDENCE, [
      ['Confidence', asRatio(room.confidence)],
      ['UnseenOutline', asLength(unseen.reduce((sum, { width }) => sum + width, 0))],
    ]);
    return space;
  });
}

/** Gross is with the columns and shafts in a room, net without; the net perimeter is less the doorways in it. */
function measureSpace(
  { properties }: IfcModel,
  space: Ref,
  { room, storey, doorways }: { room: Room; storey: Storey; doorways: number },
): void {
  const { outline, height } = room;
  const bounds = boundsOf(outline.outer);
  const structures = storey.secondary
    .map((structure) => structure.outline)
    .filter(({ outer }) => areNear(boundsOf(outer), bounds, 0));
  const whole = [{ outer: outline.outer, holes: [] }];
  const within = structures.length === 0 ? [] : combine('intersection', structures, whole);
  const gross = within.length === 0 ? areaOf([outline]) : areaOf(combine('union', [outline, ...within]));
  const net = within.length === 0 ? gross : areaOf(combine('difference', [outline], within));
  const around = ringsOf([outline]).reduce((sum, ring) => sum + perimeter(ring), 0);
  properties.quantities(space, 'Qto_SpaceBaseQuantities', [
    ['Height', 'length', height],
    ['GrossPerimeter', 'length', around],
    ['NetPerimeter', 'length', Math.max(0, around - doorways)],
    ['GrossFloorArea', 'area', gross],
    ['NetFloorArea', 'area', net],
    ['GrossVolume', 'volume', gross * height],
    ['NetVolume', 'volume', net * height],
  ]);
}
