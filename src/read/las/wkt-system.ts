import { type CoordinateSystem, epsgOf } from './coordinate-system.ts';
import type { VariableRecord } from './variable-records.ts';
import { parseWkt, type WktNode } from './wkt.ts';

const WKT = 2112;

const PROJECTED = ['PROJCS', 'PROJCRS', 'PROJECTEDCRS'];
const GEOGRAPHIC = ['GEOGCS', 'GEOGCRS', 'GEOGRAPHICCRS'];
/** ISO 19162 has one keyword for degrees and for Earth-centred axes. */
const GEODETIC = ['GEODCRS', 'GEODETICCRS'];
const VERTICAL = ['VERT_CS', 'VERTCRS', 'VERTICALCRS'];
const LOCAL = ['LOCAL_CS', 'ENGCRS', 'ENGINEERINGCRS'];
const WRAPPERS = ['COMPD_CS', 'COMPOUNDCRS', 'BOUNDCRS', 'SOURCECRS'];

/** The coordinate system that a WKT record tells, of either generation of WKT; null where there is none. */
export function wktSystem(records: readonly VariableRecord[]): CoordinateSystem | null {
  const record = records.find(({ id }) => id === WKT);
  if (!record) return null;
  const text = new TextDecoder().decode(record.bytes).replace(/\0.*$/s, '').trim();
  if (text === '') return null;
  const root = parseWkt(text);
  if (!root) return { kind: 'unknown', crs: text };
  const parts = partsOf(root);
  const plane = parts.find(({ keyword }) => !VERTICAL.includes(keyword));
  const height = parts.find(({ keyword }) => VERTICAL.includes(keyword));
  const kind = plane ? kindOf(plane) : 'unknown';
  const isLinear = kind === 'projected' || kind === 'unknown';
  const metresPerUnit = plane && isLinear ? unitOf(plane) : undefined;
  const metresPerHeightUnit = height && unitOf(height);
  return {
    kind,
    crs: codeOf(root) ?? (plane && codeOf(plane)) ?? text,
    ...(metresPerUnit && { metresPerUnit }),
    ...(metresPerHeightUnit && { metresPerHeightUnit }),
  };
}

/** The systems a compound or bound one is made of. */
function partsOf(node: WktNode): WktNode[] {
  if (WRAPPERS.includes(node.keyword)) return node.children.flatMap(partsOf);
  return [...PROJECTED, ...GEOGRAPHIC, ...GEODETIC, ...VERTICAL, ...LOCAL, 'GEOCCS'].includes(node.keyword)
    ? [node]
    : [];
}

function kindOf({ keyword, children }: WktNode): CoordinateSystem['kind'] {
  if (PROJECTED.includes(keyword)) return 'projected';
  if (GEOGRAPHIC.includes(keyword)) return 'geographic';
  if (keyword === 'GEOCCS') return 'geocentric';
  if (!GEODETIC.includes(keyword)) return 'unknown';
  const axes = children.find((child) => child.keyword === 'CS');
  const isCartesian = String(axes?.values[0]).toLowerCase() === 'cartesian';
  return isCartesian ? 'geocentric' : 'geographic';
}

/** Metres a unit: of the system itself, else of its first axis. */
function unitOf({ children }: WktNode): number | undefined {
  const axis = children.find(({ keyword }) => keyword === 'AXIS');
  const unit = [...children, ...(axis?.children ?? [])].find(({ keyword }) =>
    ['UNIT', 'LENGTHUNIT'].includes(keyword),
  );
  const factor = unit?.values[1];
  return typeof factor === 'number' && factor > 0 ? factor : undefined;
}

/** The code a system bears itself, not those of its parts. */
function codeOf({ children }: WktNode): string | undefined {
  const authority = children.find(({ keyword }) => keyword === 'AUTHORITY' || keyword === 'ID');
  if (!authority || String(authority.values[0]).toUpperCase() !== 'EPSG') return undefined;
  return epsgOf(Number(authority.values[1]));
}
