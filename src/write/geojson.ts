import { orientRing } from '../core/geometry/rings.ts';
import { conflictingEdges } from '../core/geometry/simplicity.ts';
import { type SourceCoordinates, sourceCoordinates } from '../core/source-coordinates.ts';
import type { Polygon, Ring, Storey } from '../core/types.ts';
import { areaOf, separatePinches } from '../solid/planar.ts';
import { rounded } from './decimals.ts';
import type { Product } from './plan-writer.ts';

/** Decimals of metres and square metres in properties. */
const DIGITS = 4;

type Position = readonly [number, number];

/**
 * Writes plan.geojson: all storeys as features in the plan frame, source units and source coordinates to 0.1 mm, rings
 * closed and turned as RFC 7946 §3.1.6 asks (contract: plan.geojson).
 */
export function writeGeoJson({ plan }: Product): string {
  const to = sourceCoordinates(plan.frame);
  const features = plan.storeys.flatMap((storey) => featuresOf(storey, to));
  const { unit, metresPerUnit, crs } = plan.frame;
  const frame = crs === undefined ? { unit, metresPerUnit } : { unit, metresPerUnit, crs };
  // A feature a line: readable, and small differences stay small.
  const lines = features.map((feature) => JSON.stringify(feature)).join(',\n');
  return `{"type":"FeatureCollection","frame":${JSON.stringify(frame)},"features":[\n${lines}\n]}\n`;
}

function featuresOf(storey: Storey, to: SourceCoordinates): object[] {
  const feature = (kind: string, geometry: object, properties: object) => ({
    type: 'Feature',
    geometry,
    properties: { kind, storey: storey.index, ...properties },
  });
  const areas = (kind: string, polygon: Polygon, propertiesOf: (piece: Polygon) => object) =>
    roundedPieces(polygon, to).map(({ piece, geometry }) => feature(kind, geometry, propertiesOf(piece)));
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
    ...storey.walls.flatMap(({ outline, thickness, confidence }) =>
      areas('wall', outline, () => ({ thicknessM: number(thickness), confidence: number(confidence) })),
    ),
    ...storey.openings.map(({ type, from, to: end, sill, head, confidence }) =>
      feature(
        'opening',
        { type: 'LineString', coordinates: [position(from[0], from[1], to), position(end[0], end[1], to)] },
        {
          type,
          widthM: number(Math.hypot(end[0] - from[0], end[1] - from[1])),
          sillM: number(sill),
          headM: number(head),
          confidence: number(confidence),
        },
      ),
    ),
  ];
}

interface RoundedPiece {
  readonly piece: Polygon;
  readonly geometry: object;
}

/** A polygon whose rings stay valid when rounded, itself; another, cut where its rings all but touch. */
function roundedPieces(polygon: Polygon, to: SourceCoordinates): RoundedPiece[] {
  const rings = roundedRings(polygon, to);
  const isSound = conflictingEdges(rings.map((ring) => Float64Array.from(ring.slice(1).flat()))).length === 0;
  const pieces = isSound ? [polygon] : separatePinches([polygon]);
  return pieces.flatMap((piece) => {
    const coordinates = isSound ? rings : roundedRings(piece, to);
    return coordinates.length === 0 ? [] : [{ piece, geometry: { type: 'Polygon', coordinates } }];
  });
}

/** None where rounding leaves no area. */
function roundedRings({ outer, holes }: Polygon, to: SourceCoordinates): Position[][] {
  const shell = closedRing(orientRing(outer, 'counter-clockwise'), to);
  if (shell === null) return [];
  const inner = holes.map((hole) => closedRing(orientRing(hole, 'clockwise'), to));
  return [shell, ...inner.filter((hole) => hole !== null)];
}

/** Vertices that rounding made one are written once. */
function closedRing(ring: Ring, to: SourceCoordinates): Position[] | null {
  const positions: Position[] = [];
  for (let i = 0; i < ring.length; i += 2) {
    const next = position(ring[i], ring[i + 1], to);
    if (!isSame(next, positions.at(-1))) positions.push(next);
  }
  while (positions.length > 1 && isSame(positions[0], positions.at(-1))) positions.pop();
  return positions.length < 3 ? null : [...positions, positions[0]];
}

const isSame = (a: Position, b: Position | undefined): boolean => a[0] === b?.[0] && a[1] === b[1];

const position = (x: number, y: number, to: SourceCoordinates): Position => [
  rounded(to.x(x), to.digits),
  rounded(to.y(y), to.digits),
];

const number = (value: number): number => rounded(value, DIGITS);
