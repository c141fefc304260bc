import type { FloorPlan } from '../../core/types.ts';
import type { Product } from '../plan-writer.ts';
import { IfcModel } from './ifc-model.ts';
import { placeModel, sourceProperties } from './ifc-place.ts';
import { addStorey } from './ifc-storey.ts';
import type { Ref } from './step-file.ts';
import { cutLabel, DERIVED, label, list, OMITTED, text } from './step-text.ts';

/** The clock is no input of a plan, and equal plans give equal bytes; a date may be given for the sheet. */
const NO_DAY = '1970-01-01';
const DAY = /^\d{4}-(0[1-9]|1[0-2])-(0[1-9]|[12]\d|3[01])$/;

/**
 * Writes plan.ifc: IFC 4, Reference View, of project, site, building and storeys with their spaces, walls, openings, doors,
 * windows, columns, slabs and furniture, each with its quantities (contract: plan.ifc).
 *
 * Metres near zero; the float64 origin is in the map conversion where the coordinate system is a map's with an EPSG code,
 * else the site's place where that is near zero, and in full among the site's properties always. The building's zero is the
 * floor of its lowest storey. Linear in walls and rooms, openings times walls where they are near.
 */
export function writeIfc({ name, plan, options }: Pick<Product, 'name' | 'plan' | 'options'>): string {
  const { source, frame } = plan;
  const model = new IfcModel([source.name, source.bytes, source.pointsKept, ...frame.planOrigin].join(' '));
  const { file, shapes } = model;
  const project = addProject(model, options.project.trim() || name);
  const sitePlace = shapes.place(null, placeModel(model, frame));
  const site = model.thing(
    'IFCSITE',
    { role: 'site', content: '', name: 'Site' },
    ...[sitePlace, OMITTED, OMITTED, '.ELEMENT.', ...Array<string>(5).fill(OMITTED)],
  );
  model.properties.properties(site, 'Grundriss_Source', sourceProperties(frame, source));
  const zero = plan.storeys[0]?.floor ?? 0;
  const buildingPlace = shapes.place(sitePlace, [0, 0, zero]);
  const building = model.thing(
    'IFCBUILDING',
    { role: 'building', content: '', name },
    ...[buildingPlace, OMITTED, OMITTED, '.ELEMENT.', OMITTED, OMITTED, OMITTED],
  );
  model.aggregate(project, [site]);
  model.aggregate(site, [building]);
  model.aggregate(building, addStoreys(model, plan, buildingPlace));
  model.end();
  return file.end({
    description: 'ViewDefinition [ReferenceView_V1.2]',
    fileName: 'plan.ifc',
    timeStamp: `${DAY.test(options.sheetDate) ? options.sheetDate : NO_DAY}T00:00:00`,
    program: 'Grundriss',
    schema: 'IFC4',
  });
}

function addStoreys(model: IfcModel, { storeys, options }: FloorPlan, building: Ref): Ref[] {
  let roomsBelow = 0;
  return storeys.map((storey) => {
    const elevation = storey.floor - storeys[0].floor;
    const ref = addStorey(model, { storey, options, building, elevation, roomsBelow });
    roomsBelow += storey.rooms.length;
    return ref;
  });
}

function addProject({ file, guids, context }: IfcModel, name: string): Ref {
  const si = (kind: string, unit: string) => file.share('IFCSIUNIT', DERIVED, kind, OMITTED, unit);
  const units = file.add(
    'IFCUNITASSIGNMENT',
    list([
      si('.LENGTHUNIT.', '.METRE.'),
      si('.AREAUNIT.', '.SQUARE_METRE.'),
      si('.VOLUMEUNIT.', '.CUBIC_METRE.'),
      si('.PLANEANGLEUNIT.', '.RADIAN.'),
    ]),
  );
  const longName = cutLabel(name);
  const description = longName === OMITTED ? text('Approximate: from a point cloud') : longName;
  return file.add(
    'IFCPROJECT',
    ...[guids.next('project', ''), OMITTED, label(name), description, OMITTED, OMITTED, OMITTED],
    ...[list([context]), units],
  );
}
