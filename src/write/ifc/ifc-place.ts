import type { Frame, Vec3 } from '../../core/types.ts';
import type { IfcModel } from './ifc-model.ts';
import { asIdentifier, asLabel, asReal, asText, type Property } from './ifc-properties.ts';
import type { Ref } from './step-file.ts';
import { label, OMITTED, real } from './step-text.ts';

/** Without a coordinate system the site stands at its source coordinates up to here, m: float32 keeps 0.1 mm. */
const NEAR = 1000;

/** Systems of latitude and longitude or of the earth's centre: no map to place a building on. */
const NO_MAP = new Set([4258, 4267, 4269, 4326, 4936, 4937, 4978, 4979, 7843, 7844]);

/** Feet: what a map in them is measured in. Everything else is a metric map's. */
const FEET: Partial<Record<Frame['unit'], string>> = { ft: 'FOOT', 'us-ft': 'US SURVEY FOOT' };

/**
 * Ties the model to the earth where the scan's coordinate system is a map projection with an EPSG code; geometry stays near
 * zero, and the float64 origin stands in the map conversion.
 *
 * Feet stay the map's unit, with the scale from metres to them; other units are written as metres. The model's axes are
 * the map's, turned by nothing.
 *
 * @returns where the site stands: zero, or without a map the source's origin where that is near
 */
export function placeModel({ file, context }: IfcModel, frame: Frame): Vec3 {
  const { planOrigin, metresPerUnit, unit, crs } = frame;
  const metres = planOrigin.map((value) => value * metresPerUnit) as unknown as Vec3;
  const code = crs === undefined ? null : mapCode(crs);
  if (code === null) return Math.max(...metres.map(Math.abs)) <= NEAR ? metres : [0, 0, 0];
  const metre = file.share('IFCSIUNIT', '*', '.LENGTHUNIT.', OMITTED, '.METRE.');
  const feet = FEET[unit];
  const mapUnit = feet === undefined ? metre : footUnit(file, feet, metresPerUnit);
  const [east, north, height] = feet === undefined ? metres : planOrigin;
  const system = file.add(
    'IFCPROJECTEDCRS',
    ...[label(`EPSG:${code}`), OMITTED, OMITTED, OMITTED, OMITTED, OMITTED, mapUnit],
  );
  const scale = feet === undefined ? 1 : 1 / metresPerUnit;
  const place = [east, north, height, 1, 0, scale].map(real);
  file.add('IFCMAPCONVERSION', context, system, ...place);
  return [0, 0, 0];
}

/** The way back to the source in full, whatever placed the model. */
export function sourceProperties(frame: Frame, facts: { name: string; format: string }): Property[] {
  const { planOrigin, metresPerUnit, unit, up, crs } = frame;
  return [
    ['File', asText(facts.name)],
    ['Format', asLabel(facts.format)],
    ['Unit', asLabel(unit)],
    ['MetresPerUnit', asReal(metresPerUnit)],
    ['UpAxis', asLabel(up)],
    ['OriginX', asReal(planOrigin[0])],
    ['OriginY', asReal(planOrigin[1])],
    ['OriginZ', asReal(planOrigin[2])],
    ...(crs === undefined ? [] : [['CoordinateSystem', crsValue(crs)] as const]),
  ];
}

const crsValue = (crs: string) =>
  mapCode(crs) === null ? asText(crs) : asIdentifier(`EPSG:${mapCode(crs)}`);

function footUnit(file: IfcModel['file'], name: string, metresPerUnit: number): Ref {
  const metre = file.share('IFCSIUNIT', '*', '.LENGTHUNIT.', OMITTED, '.METRE.');
  const length = file.add('IFCDIMENSIONALEXPONENTS', '1', '0', '0', '0', '0', '0', '0');
  const measure = file.add('IFCMEASUREWITHUNIT', `IFCLENGTHMEASURE(${real(metresPerUnit)})`, metre);
  return file.add('IFCCONVERSIONBASEDUNIT', length, '.LENGTHUNIT.', label(name), measure);
}

/** The EPSG code of a map projection: of `EPSG:25832`, or of what WKT says of its projected system. */
function mapCode(crs: string): number | null {
  const named = /^\s*(?:EPSG:|urn:ogc:def:crs:EPSG:[^:]*:)(\d+)\s*$/i.exec(crs);
  const code = named === null ? codeInWkt(crs) : Number(named[1]);
  return code === null || NO_MAP.has(code) ? null : code;
}

/** The authority's code that stands right in the projected system, not in a part of it. */
function codeInWkt(wkt: string): number | null {
  const start = /\b(?:PROJCS|PROJCRS|PROJECTEDCRS)\s*[[(]/i.exec(wkt);
  if (start === null) return null;
  let depth = 1;
  let own = '';
  for (const [part] of wkt.slice(start.index + start[0].length).matchAll(/"[^"]*"|[[(]|[\])]|[^"[\]()]+/g)) {
    if (part === '[' || part === '(') depth++;
    if (part === ']' || part === ')') depth--;
    if (depth === 0) break;
    // Of the nodes within, only their names and what stands right in them.
    if (depth <= 2) own += part;
  }
  const code = /\b(?:AUTHORITY|ID)\s*[[(]\s*"EPSG"\s*,\s*"?(\d+)/i.exec(own);
  return code === null ? null : Number(code[1]);
}
