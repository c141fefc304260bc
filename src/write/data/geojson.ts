import { areaOf } from '../../core/geometry/areas.ts';
import { circlesOf } from '../../core/geometry/ring-arcs.ts';
import { ringsOf } from '../../core/geometry/rings.ts';
import { circlesIn, sourceCoordinates } from '../../core/source-coordinates.ts';
import type { FloorPlan, Opening, Polygon, Ring, Storey } from '../../core/types.ts';
import { arcStart, arcTurn } from '../arc-strokes.ts';
import { rounded } from '../decimals.ts';
import type { Product } from '../plan-writer.ts';
import { type FileCurves, roundedPolygons } from '../rounded-polygons.ts';

/** Decimals of metres and square metres in properties. */
const DIGITS = 4;
/** … and of radians: 0.1 mm at 100 m. */
const ANGLE_DIGITS = 6;

type Position = readonly [number, number];

/** How a file's coordinates are written. */
export interface Places {
  /** From plan metres to rounded coordinates. */
  place(x: number, y: number): Position;
  /** What arcs may be told of; absent where circles are none in those coordinates. */
  curvesOf?(polygon: Polygon): FileCurves;
  /** Decimals. */
  readonly digits: number;
}

/**
 * Writes plan.geojson: all storeys as features in the plan frame, source units and source coordinates to 0.1 mm, rings
 * closed and turned as RFC 7946 §3.1.6 asks (contract: plan.geojson).
 */
export function writeGeoJson({ plan }: Pick<Product, 'plan'>): string {
  const to = sourceCoordinates(plan.frame);
  const { unit, metresPerUnit, crs } = plan.frame;
  const frame = crs === undefined ? { unit, metresPerUnit } : { unit, metresPerUnit, crs };
  const features = planFeatures(plan, {
    place: (x, y) => [rounded(to.x(x), to.digits), rounded(to.y(y), to.digits)],
    curvesOf: (polygon) => ({ circles: circlesIn(to, metresPerUnit, circlesOf(polygon)), metresPerUnit }),
    digits: to.digits,
  });
  return collection({ frame }, features);
}

export type PlanFeature = Readonly<Record<'geometry' | 'properties', object>>;

/** Everything of a plan as features. */
export function planFeatures({ storeys }: Pick<FloorPlan, 'storeys'>, places: Places): PlanFeature[] {
  return storeys.flatMap((storey) => featuresOf(storey, places));
}

/** A feature a line: readable, and small differences stay small. @param members of the collection itself */
export function collection(members: object, features: readonly PlanFeature[]): string {
  const head = JSON.stringify({ type: 'FeatureCollection', ...members }).slice(0, -1);
  const lines = features.map((feature) => JSON.stringify(feature)).join(',\n');
  return `${head},"features":[\n${lines}\n]}\n`;
}

function featuresOf(storey: Storey, { place, curvesOf, digits }: Places): PlanFeature[] {
  const feature = (kind: string, geometry: object, properties: object) => ({
    type: 'Feature',
    geometry,
    properties: { kind, storey: storey.index, ...properties },
  });
  const areas = (kind: string, polygon: Polygon, propertiesOf: (piece: Polygon) => object) =>
    roundedPolygons(polygon, place, curvesOf?.(polygon)).map(({ piece, rounded }) =>
      feature(
        kind,
        { type: 'Polygon', coordinates: ringsOf([rounded]).map(closed) },
        { ...propertiesOf(piece), ...arcsOf(rounded, digits) },
      ),
    );
  const line = (...ends: readonly Opening['from'][]) => ({
    type: 'LineString',
    coordinates: ends.map(([x, y]) => place(x, y)),
  });
  return [
    ...storey.primary.flatMap((polygon) =>
      areas('primary-boundary', polygon, (piece) => ({ areaM2: number(areaOf([piece])) })),
    ),
    ...storey.secondary.flatMap(({ outline, operation, type }) =>
      areas('secondary-boundary', outline, () => ({ operation, type })),
    ),
    ...storey.rooms.flatMap(({ name, outline, height, confidence }) =>
      areas('room', outline, (piece) => ({
        name,
        areaM2: number(areaOf([piece])),
        heightM: number(height),
        confidence: number(confidence),
      })),
    ),
    ...storey.walls.flatMap(({ outline, thickness, confidence, isThicknessInferred }) =>
      areas('wall', outline, () => ({
        thicknessM: number(thickness),
        confidence: number(confidence),
        ...(isThicknessInferred && { inferred: true }),
      })),
    ),
    ...storey.gaps.map(({ from, to: end, width, room }) =>
      feature('inferred-stretch', line(from, end), { lengthM: number(width), ...(room && { room }) }),
    ),
    ...storey.openings.map(({ type, from, to: end, sill, head, confidence }) =>
      feature('opening', line(from, end), {
        type,
        widthM: number(Math.hypot(end[0] - from[0], end[1] - from[1])),
        sillM: number(sill),
        headM: number(head),
        confidence: number(confidence),
      }),
    ),
    ...(storey.furniture ?? []).flatMap(({ outline, height, confidence, room }) =>
      areas('furniture', outline, (piece) => ({
        room,
        areaM2: number(areaOf([piece])),
        heightM: number(height),
        confidence: number(confidence),
      })),
    ),
  ];
}

/** Arcs by the numbers of their first and last positions in a ring, angles from the centre to these in radians. */
function arcsOf(polygon: Polygon, digits: number): object {
  if (!polygon.arcs) return {};
  const rings = ringsOf([polygon]);
  const arcs = polygon.arcs.map((arc) => {
    const { ring, from, to, centre, radius } = arc;
    const start = arcStart(rings[ring], arc);
    const angles = [start, start + arcTurn(rings[ring], arc)].map((angle) => rounded(angle, ANGLE_DIGITS));
    const [x, y] = centre;
    return {
      ...{ ring, from, to, centre: [rounded(x, digits), rounded(y, digits)] },
      ...{ radius: rounded(radius, digits), angles },
    };
  });
  return { arcs };
}

/** Closed as RFC 7946 §3.1.6 asks: the first position comes again at the end. */
function closed(ring: Ring): Position[] {
  const positions = Array.from(
    { length: ring.length / 2 },
    (_, k): Position => [ring[2 * k], ring[2 * k + 1]],
  );
  return [...positions, positions[0]];
}

const number = (value: number): number => rounded(value, DIGITS);
