import { FloorPlanError } from '../core/errors.ts';
import { writeDxf } from './dxf.ts';
import { writeFrameJson } from './frame-json.ts';
import { writeGeoJson } from './geojson.ts';
import { writeGlb } from './glb.ts';
import { writeMinimalSvg } from './minimal-svg.ts';
import { writePictures } from './pictures.ts';
import { writePlanJson } from './plan-json.ts';
import type { Product, WriteFormat, WrittenFile } from './plan-writer.ts';
import { writeRoomsCsv } from './rooms-csv.ts';
import { writeSliceCsv } from './slice-csv.ts';
import { writeSvg } from './svg.ts';

/** Every file a plan can be written as: export menu, `--formats`, README table and round-trip tests come from here. */
export const WRITE_FORMATS = {
  svg: {
    label: 'SVG drawing',
    doc: 'The drawn plan to scale, with layers and georeference.',
    extension: 'svg',
    mime: 'image/svg+xml',
    isPerStorey: true,
    base: 'plan',
    write: writeSvg,
  },
  'minimal-svg': {
    label: 'SVG paths',
    doc: "Paths only in metres, the paper's; ready to be extruded.",
    extension: 'minimal.svg',
    mime: 'image/svg+xml',
    isPerStorey: true,
    base: 'plan',
    write: writeMinimalSvg,
  },
  dxf: {
    label: 'DXF',
    doc: 'Layered polylines in source coordinates for CAD (AutoCAD 2000).',
    extension: 'dxf',
    mime: 'image/vnd.dxf',
    isPerStorey: true,
    base: 'plan',
    write: writeDxf,
  },
  geojson: {
    label: 'GeoJSON',
    doc: 'Boundaries, walls and rooms with their measures in source coordinates.',
    extension: 'geojson',
    mime: 'application/geo+json',
    isPerStorey: false,
    base: 'plan',
    write: writeGeoJson,
  },
  glb: {
    label: 'GLB model',
    doc: 'The 3D model in metres, y up.',
    extension: 'glb',
    mime: 'model/gltf-binary',
    isPerStorey: false,
    base: 'plan',
    write: writeGlb,
  },
  json: {
    label: 'Plan JSON',
    doc: 'The whole plan with frame, options and warnings.',
    extension: 'json',
    mime: 'application/json',
    isPerStorey: false,
    base: 'plan',
    write: writePlanJson,
  },
  frame: {
    label: 'Georeference',
    doc: "The paper's sidecar beside an SVG: frame, unit, scale and transforms.",
    extension: 'frame.json',
    mime: 'application/json',
    isPerStorey: true,
    base: 'plan',
    write: writeFrameJson,
  },
  slice: {
    label: 'Slice CSV',
    doc: 'The points the outline was found from, in source coordinates: one level of the whole scan, whatever its storeys.',
    extension: 'csv',
    mime: 'text/csv',
    isPerStorey: false,
    base: 'slice',
    write: writeSliceCsv,
  },
  rooms: {
    label: 'Rooms CSV',
    doc: 'One line a room: name, storey, area, height, confidence.',
    extension: 'csv',
    mime: 'text/csv',
    isPerStorey: false,
    base: 'rooms',
    write: writeRoomsCsv,
  },
  pictures: {
    label: 'Stage pictures',
    doc: 'What every stage made, a captioned SVG each: picture-01-cloud.svg to picture-15-model.svg; where a stage fails, those before it.',
    extension: 'svg',
    mime: 'image/svg+xml',
    isOnRequest: true,
    writeAll: writePictures,
  },
} as const satisfies Record<string, WriteFormat>;

export type WriteFormatName = keyof typeof WRITE_FORMATS;

export const WRITE_FORMAT_NAMES = Object.keys(WRITE_FORMATS) as readonly WriteFormatName[];

/** Formats that go along when a format is written to a folder: the paper puts a georeference beside an SVG. */
export const SIDECARS: Partial<Record<WriteFormatName, readonly WriteFormatName[]>> = {
  svg: ['frame'],
  'minimal-svg': ['frame'],
};

/**
 * Writes a plan as the files of one format: one, for drawn formats of a building of several storeys one a storey, for
 * pictures one a picture.
 *
 * @throws option/invalid for a name that is no format
 */
export function writeFiles(product: Product, format: string): WrittenFile[] {
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
  const row: WriteFormat = WRITE_FORMATS[format as WriteFormatName];
  if ('writeAll' in row) return [...row.writeAll(product)];
  const count = product.plan.storeys.length;
  if (!row.isPerStorey || count === 1) {
    return [{ name: `${row.base}.${row.extension}`, mime: row.mime, content: row.write(product, 0) }];
  }
  return product.plan.storeys.map((_, storey) => ({
    name: `${row.base}-${storey}.${row.extension}`,
    mime: row.mime,
    content: row.write(product, storey),
  }));
}
