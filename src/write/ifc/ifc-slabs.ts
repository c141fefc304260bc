import { areaOf } from '../../core/geometry/areas.ts';
import { perimeter, ringsOf } from '../../core/geometry/rings.ts';
import type { Options } from '../../core/params.ts';
import type { Polygon } from '../../core/types.ts';
import { carve, footprint } from '../../solid/sections.ts';
import { filePolygons } from './ifc-shapes.ts';
import type { Ref } from './step-file.ts';
import { OMITTED } from './step-text.ts';
import { contentOf, type StoreyModel } from './storey-model.ts';

/**
 * Slabs as the parameters ask for them: the footprint, less the structures that are subtracted, but for columns, which stand
 * on it.
 */
export function addSlabs({ model, storey, place }: StoreyModel, options: Options): Ref[] {
  const { floorSlab, ceilingSlab, slabThickness } = options;
  if (!(floorSlab || ceilingSlab) || !(slabThickness > 0)) return [];
  const holes = storey.secondary.filter(
    ({ type, operation }) => type !== 'column' && operation === 'subtract',
  );
  const pieces = carve(footprint(storey), holes).flatMap(filePolygons);
  const slab = (piece: Polygon, kind: 'floor' | 'ceiling', i: number): Ref => {
    const isFloor = kind === 'floor';
    const low = isFloor ? -slabThickness : storey.height;
    const shape = model.shapes.prisms([piece], slabThickness, kind);
    const ref = model.thing(
      'IFCSLAB',
      {
        ...{ role: `${kind}-slab`, content: contentOf(storey, piece) },
        name: `${isFloor ? 'Floor' : 'Ceiling'} ${i + 1}`,
        ...(!isFloor && { objectType: 'CEILING' }),
      },
      ...[model.shapes.place(place, [0, 0, low]), shape, OMITTED, isFloor ? '.FLOOR.' : '.USERDEFINED.'],
    );
    const area = areaOf([piece]);
    const edge = ringsOf([piece]).reduce((sum, ring) => sum + perimeter(ring), 0);
    model.properties.quantities(ref, 'Qto_SlabBaseQuantities', [
      ['Width', 'length', slabThickness],
      ['Perimeter', 'length', edge],
      ['GrossArea', 'area', area],
      ['NetArea', 'area', area],
      ['GrossVolume', 'volume', area * slabThickness],
      ['NetVolume', 'volume', area * slabThickness],
    ]);
    return ref;
  };
  return [
    ...(floorSlab ? pieces.map((piece, i) => slab(piece, 'floor', i)) : []),
    ...(ceilingSlab ? pieces.map((piece, i) => slab(piece, 'ceiling', i)) : []),
  ];
}
