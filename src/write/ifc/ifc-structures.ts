import { roomOfFurniture } from '../../core/find-room.ts';
import { areaOf } from '../../core/geometry/areas.ts';
import type { Furniture, SecondaryBoundary } from '../../core/types.ts';
import { asLabel, asRatio } from './ifc-properties.ts';
import { filePolygons } from './ifc-shapes.ts';
import type { Ref } from './step-file.ts';
import { OMITTED } from './step-text.ts';
import { contentOf, EVIDENCE, type StoreyModel } from './storey-model.ts';

/**
 * Columns are IfcColumn. Of a shaft or another structure only the outside was seen, and no class of the schema says that: each
 * is an IfcBuildingElementProxy whose object type names it, a block as high as the storey.
 */
export function addStructures({ model, storey, place }: StoreyModel): Ref[] {
  return storey.secondary.flatMap((structure, i) => {
    const pieces = filePolygons(structure.outline);
    if (pieces.length === 0) return [];
    const { type, operation } = structure;
    const isColumn = type === 'column';
    const ref = model.thing(
      isColumn ? 'IFCCOLUMN' : 'IFCBUILDINGELEMENTPROXY',
      {
        ...{ role: type, content: contentOf(storey, structure.outline) },
        name: `${NAMES[type]} ${i + 1}`,
        ...(!isColumn && { objectType: OBJECT_TYPES[type] }),
      },
      ...[model.shapes.place(place), model.shapes.prisms(pieces, storey.height, 'structure'), OMITTED],
      isColumn ? '.COLUMN.' : '.USERDEFINED.',
    );
    const area = areaOf(pieces);
    if (isColumn) {
      model.properties.quantities(ref, 'Qto_ColumnBaseQuantities', [
        ['Length', 'length', storey.height],
        ['CrossSectionArea', 'area', area],
        ['GrossVolume', 'volume', area * storey.height],
        ['NetVolume', 'volume', area * storey.height],
      ]);
    }
    model.properties.properties(ref, EVIDENCE, [['Operation', asLabel(operation)]]);
    return [ref];
  });
}

const NAMES: Record<SecondaryBoundary['type'], string> = {
  column: 'Column',
  shaft: 'Shaft',
  other: 'Structure',
};
const OBJECT_TYPES = { shaft: 'SHAFT', other: 'STRUCTURE', column: 'COLUMN' } as const;

/** Puts furniture into its rooms. @returns what stands in no known room */
export function addFurniture({ model, storey, place }: StoreyModel, spaces: readonly Ref[]): Ref[] {
  const left: Ref[] = [];
  const inRooms = storey.rooms.map((): Ref[] => []);
  (storey.furniture ?? []).forEach((thing: Furniture, i) => {
    const pieces = filePolygons(thing.outline);
    if (pieces.length === 0) return;
    const ref = model.thing(
      'IFCFURNITURE',
      { role: 'furniture', content: contentOf(storey, thing.outline), name: `Furniture ${i + 1}` },
      ...[
        model.shapes.place(place),
        model.shapes.prisms(pieces, thing.height, 'furniture'),
        OMITTED,
        '.NOTDEFINED.',
      ],
    );
    model.properties.properties(ref, EVIDENCE, [['Confidence', asRatio(thing.confidence)]]);
    const room = roomOfFurniture(storey.rooms, thing);
    (inRooms[room] ?? left).push(ref);
  });
  inRooms.forEach((things, i) => {
    model.contain(spaces[i], things);
  });
  return left;
}
