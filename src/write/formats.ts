import { FloorPlanError } from '../core/errors.ts';
import type { WriteTools } from './drawing/raster.ts';
import type { Product, WriteFormat, WrittenFile } from './plan-writer.ts';
import type { ZipOrder } from './zip.ts';

/** Every file a plan can be written as: export menu, `--formats`, README table and round-trip tests come from here. */
export const WRITE_FORMATS = {
  svg: {
    label: 'SVG',
    group: 'drawing',
    doc: 'The drawn plan to scale, with layers and georeference.',
    extension: 'svg',
    mime: 'image/svg+xml',
    isPerStorey: true,
    base: 'plan',
    load: async () => (await import('./drawing/svg.ts')).writeSvg,
  },
  pdf: {
    label: 'PDF',
    group: 'drawing',
    doc: 'The drawn plan on one page of its paper, true to scale, with layers.',
    extension: 'pdf',
    mime: 'application/pdf',
    isPerStorey: true,
    base: 'plan',
    load: async () => (await import('./pdf/pdf.ts')).writePdf,
  },
  png: {
    label: 'PNG',
    group: 'drawing',
    doc: 'The drawn plan as a picture of 200 dots an inch, fewer on the largest papers; in Node it takes the package @napi-rs/canvas.',
    extension: 'png',
    mime: 'image/png',
    isPerStorey: true,
    isOnRequest: true,
    base: 'plan',
    load: async () => (await import('./drawing/png.ts')).writePng,
  },
  'minimal-svg': {
    label: 'SVG paths',
    group: 'drawing',
    doc: "Paths only in metres, the paper's; ready to be extruded.",
    extension: 'minimal.svg',
    mime: 'image/svg+xml',
    isPerStorey: true,
    base: 'plan',
    load: async () => (await import('./drawing/minimal-svg.ts')).writeMinimalSvg,
  },
  dxf: {
    label: 'DXF',
    group: 'drawing',
    doc: 'Rooms, walls, openings as blocks and dimensions for CAD (AutoCAD 2000), in source coordinates.',
    extension: 'dxf',
    mime: 'image/vnd.dxf',
    isPerStorey: true,
    base: 'plan',
    load: async () => (await import('./dxf/dxf.ts')).writeDxf,
  },
  geojson: {
    label: 'GeoJSON',
    group: 'data',
    doc: 'Boundaries, walls and rooms with their measures in source coordinates.',
    extension: 'geojson',
    mime: 'application/geo+json',
    isPerStorey: false,
    base: 'plan',
    load: async () => (await import('./data/geojson.ts')).writeGeoJson,
  },
  'geojson-wgs84': {
    label: 'GeoJSON WGS 84',
    group: 'data',
    doc: 'The same in longitude and latitude (RFC 7946), where the scan names its coordinate system.',
    extension: 'wgs84.geojson',
    mime: 'application/geo+json',
    needs: 'crs',
    isPerStorey: false,
    isOnRequest: true,
    base: 'plan',
    load: async () => (await import('./data/geojson-wgs84.ts')).writeGeoJsonWgs84,
  },
  glb: {
    label: 'GLB',
    group: 'model',
    doc: 'The 3D model in metres, y up.',
    extension: 'glb',
    mime: 'model/gltf-binary',
    isPerStorey: false,
    base: 'plan',
    load: async () => (await import('./model/glb.ts')).writeGlb,
  },
  'glb-points': {
    label: 'GLB with points',
    group: 'model',
    doc: 'The 3D model with an even sample of the scan in its colours.',
    extension: 'points.glb',
    mime: 'model/gltf-binary',
    needs: 'points',
    isPerStorey: false,
    isOnRequest: true,
    base: 'plan',
    load: async () => (await import('./model/glb.ts')).writeCloudGlb,
  },
  ifc: {
    label: 'IFC 4',
    group: 'model',
    doc: 'Spaces, walls, openings and slabs with quantities for BIM programs (Reference View).',
    extension: 'ifc',
    mime: 'application/x-step',
    isPerStorey: false,
    isOnRequest: true,
    base: 'plan',
    load: async () => (await import('./ifc/ifc.ts')).writeIfc,
  },
  obj: {
    label: 'OBJ',
    group: 'model',
    doc: 'The 3D model as named objects with a material file, z up, in source units and coordinates.',
    extension: 'obj',
    mime: 'model/obj',
    isOnRequest: true,
    loadAll: async () => (await import('./model/obj.ts')).writeObj,
  },
  stl: {
    label: 'STL',
    group: 'model',
    doc: 'Closed shells for print: millimetres, z up.',
    extension: 'stl',
    mime: 'model/stl',
    isPerStorey: false,
    isOnRequest: true,
    base: 'plan',
    load: async () => (await import('./model/stl.ts')).writeStl,
  },
  ply: {
    label: 'PLY',
    group: 'model',
    doc: 'The 3D model as a mesh in float64 source coordinates, z up.',
    extension: 'ply',
    mime: 'application/octet-stream',
    isPerStorey: false,
    isOnRequest: true,
    base: 'plan',
    load: async () => (await import('./model/ply.ts')).writePly,
  },
  json: {
    label: 'Plan JSON',
    group: 'data',
    doc: 'The whole plan with frame, options and warnings.',
    extension: 'json',
    mime: 'application/json',
    isPerStorey: false,
    base: 'plan',
    load: async () => (await import('./data/plan-json.ts')).writePlanJson,
  },
  frame: {
    label: 'Georeference',
    group: 'data',
    doc: "The paper's sidecar beside an SVG: frame, unit, scale and transforms.",
    extension: 'frame.json',
    mime: 'application/json',
    isPerStorey: true,
    base: 'plan',
    load: async () => (await import('./drawing/frame-json.ts')).writeFrameJson,
  },
  slice: {
    label: 'Slice CSV',
    group: 'data',
    doc: 'The points the outline was found from, in source coordinates: one level of the whole scan, whatever its storeys.',
    extension: 'csv',
    mime: 'text/csv',
    needs: 'points',
    isPerStorey: false,
    base: 'slice',
    load: async () => (await import('./data/slice-csv.ts')).writeSliceCsv,
  },
  rooms: {
    label: 'Rooms CSV',
    group: 'data',
    doc: 'One line a room: name, storey, area, height, confidence.',
    extension: 'csv',
    mime: 'text/csv',
    isPerStorey: false,
    base: 'rooms',
    load: async () => (await import('./data/rooms-csv.ts')).writeRoomsCsv,
  },
  'rooms-xlsx': {
    label: 'Rooms XLSX',
    group: 'data',
    doc: 'The rooms as a workbook, with net, gross internal and gross external areas by stated rules.',
    extension: 'xlsx',
    mime: 'application/vnd.openxmlformats-officedocument.spreadsheetml.sheet',
    isPerStorey: false,
    isOnRequest: true,
    base: 'rooms',
    load: async () => (await import('./data/rooms-xlsx.ts')).writeRoomsXlsx,
  },
  pictures: {
    label: 'Stage pictures',
    group: 'drawing',
    doc: 'What every stage made, a captioned SVG each: picture-01-cloud.svg to picture-15-model.svg; where a stage fails, those before it.',
    extension: 'svg',
    mime: 'image/svg+xml',
    isOnRequest: true,
    loadAll: async () => (await import('./pictures/pictures.ts')).writePictures,
  },
  zip: {
    label: 'All as ZIP',
    group: 'data',
    doc: 'Every format above in one file, but for stage pictures and points; or those chosen.',
    extension: 'zip',
    mime: 'application/zip',
    isPerStorey: false,
    isOnRequest: true,
    base: 'plan',
    load: async () => {
      const { writeZip } = await import('./zip.ts');
      return (product, _, tools) => writeZip(product, zipOrder(tools));
    },
  },
} as const satisfies Record<string, WriteFormat>;

export type WriteFormatName = keyof typeof WRITE_FORMATS;

export const WRITE_FORMAT_NAMES = Object.keys(WRITE_FORMATS) as readonly WriteFormatName[];

/** Large, and about how the plan came about rather than the plan. */
const NOT_ZIPPED: readonly string[] = ['pictures', 'glb-points', 'zip'];

/** @param chosen names; without them everything but {@link NOT_ZIPPED} */
function zipOrder(tools: WriteTools, chosen?: readonly string[]): ZipOrder {
  const isPacked = (name: string) => chosen?.includes(name) ?? !NOT_ZIPPED.includes(name);
  const formats = Object.entries<WriteFormat>(WRITE_FORMATS).filter(([name]) => isPacked(name));
  return {
    formats: formats.map(([name, { label, doc }]) => ({ name, label, doc })),
    write: (product, name) => writeFiles(product, name, tools),
  };
}

/** What {@link zipOf} begins with. */
const ZIP_OF = 'zip:';

/** The format that packs others: `zip:svg,dxf`. */
export function zipOf(names: readonly string[]): string {
  return ZIP_OF + names.join(',');
}

/** Formats that go along when a format is written to a folder: the paper puts a georeference beside an SVG. */
export const SIDECARS: Partial<Record<WriteFormatName, readonly WriteFormatName[]>> = {
  svg: ['frame'],
  'minimal-svg': ['frame'],
};

/**
 * Writes a plan as the files of one format: one, for drawn formats of a building of several storeys one a storey, for
 * pictures one a picture; or those of several formats in one ZIP ({@link zipOf}).
 *
 * @throws option/invalid for a name that is no format
 */
export async function writeFiles(
  product: Product,
  format: string,
  tools: WriteTools = {},
): Promise<WrittenFile[]> {
  if (format.startsWith(ZIP_OF)) return [await writeChosen(product, format.slice(ZIP_OF.length), tools)];
  const row: WriteFormat = WRITE_FORMATS[knownFormat(format)];
  if ('loadAll' in row) return [...(await row.loadAll())(product)];
  const write = await row.load();
  const { base, extension, mime } = row;
  const storeys = row.isPerStorey ? product.plan.storeys.length : 1;
  const files: WrittenFile[] = [];
  for (let storey = 0; storey < storeys; storey++) {
    const name = storeys === 1 ? base : `${base}-${storey}`;
    files.push({ name: `${name}.${extension}`, mime, content: await write(product, storey, tools) });
  }
  return files;
}

async function writeChosen(product: Product, names: string, tools: WriteTools): Promise<WrittenFile> {
  const chosen = names
    .split(',')
    .map(knownFormat)
    .filter((name) => name !== 'zip');
  const { base, extension, mime } = WRITE_FORMATS.zip;
  const { writeZip } = await import('./zip.ts');
  const content = await writeZip(product, zipOrder(tools, chosen));
  return { name: `${base}.${extension}`, mime, content };
}

function knownFormat(format: string): WriteFormatName {
  if (!Object.hasOwn(WRITE_FORMATS, format)) {
    throw new FloorPlanError(
      'option/invalid',
      `Format: expected one of ${WRITE_FORMAT_NAMES.join(', ')}, found "${format}"`,
      {
        hint: 'Choose one of these names.',
        detail: { option: 'formats' },
      },
    );
  }
  return format as WriteFormatName;
}
