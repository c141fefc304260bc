import { distance, interpolate, type XY } from '../../fixtures/simulator/ring.ts';
import type { Truth, TruthStorey } from '../../fixtures/simulator/truth.ts';
import type { Polygon } from './regions.ts';

/** The parts of plan.geojson that the measure looks at. */
export interface PlanFile {
  readonly features: readonly {
    readonly geometry: Geometry | null;
    readonly properties: Readonly<Record<string, unknown>>;
  }[];
}

interface Geometry {
  readonly type: string;
  readonly coordinates: unknown;
}

export interface OpeningFacts {
  readonly kind: string;
  readonly from: XY;
  readonly to: XY;
  readonly centre: XY;
  readonly width: number;
  readonly sill: number;
  readonly head: number;
}

export interface WallFacts {
  readonly outline: Polygon;
  readonly thickness: number;
  /** Its thickness is assumed, not measured. */
  readonly isInferred: boolean;
}

export type Stretch = readonly [from: XY, to: XY];

/** One storey of a plan or of the truth: metres, relative to an origin that both share. */
export interface StoreyFacts {
  readonly primary: readonly Polygon[];
  readonly rooms: readonly Polygon[];
  /** A room each, where known; m. */
  readonly roomHeights: readonly number[];
  readonly structures: readonly Polygon[];
  readonly openings: readonly OpeningFacts[];
  /** Outer face of the outer walls; of the truth only. */
  readonly outer: readonly Polygon[];
  /** Of the plan only. */
  readonly walls: readonly WallFacts[];
  /** Stretches of wall faces that no point supports; null where nobody knows. */
  readonly hidden: readonly Stretch[] | null;
}

export interface StoreyPair {
  readonly plan: StoreyFacts;
  readonly truth: StoreyFacts;
}

type Coordinates = readonly (readonly number[])[];

/** Lays a plan beside the truth, storey by storey; both shrink to metres about a corner of the truth. */
export function pairStoreys(plan: PlanFile, truth: Truth): StoreyPair[] {
  const unit = truth.unit ?? 1;
  if (!('storeys' in truth)) return [pair(plan, truth, unit)];
  return truth.storeys.map((storey, i) => {
    const features = plan.features.filter(({ properties }) => (properties.storey ?? 0) === i);
    return pair({ features }, storey, unit);
  });
}

function pair(plan: PlanFile, truth: TruthStorey, unit: number): StoreyPair {
  const [originX, originY] = truth.interior_outline[0][0];
  const toMetres = ([x, y]: readonly number[]): XY => [(x - originX) / unit, (y - originY) / unit];
  return { plan: planFacts(plan, toMetres), truth: truthFacts(truth, toMetres, unit) };
}

type ToMetres = (position: readonly number[]) => XY;

function openRing(ring: Coordinates, toMetres: ToMetres): XY[] {
  const first = ring[0];
  const last = ring[ring.length - 1];
  const isClosed = ring.length > 1 && first[0] === last[0] && first[1] === last[1];
  return (isClosed ? ring.slice(0, -1) : ring).map(toMetres);
}

function truthFacts(truth: TruthStorey, toMetres: ToMetres, unit: number): StoreyFacts {
  const polygon = (rings: readonly Coordinates[]): Polygon => rings.map((ring) => openRing(ring, toMetres));
  return {
    primary: [polygon(truth.interior_outline)],
    rooms: truth.rooms.map(polygon),
    roomHeights: (truth.heights ?? truth.rooms.map(() => truth.height)).map((height) => height / unit),
    structures: truth.columns.map(polygon),
    openings: truth.openings.map(({ kind, seg, z0, z1 }) => {
      const [from, to] = seg.map(toMetres);
      return {
        kind,
        from,
        to,
        centre: interpolate(from, to, 0.5),
        width: distance(from, to),
        sill: z0 / unit,
        head: z1 / unit,
      };
    }),
    outer: [polygon(truth.outer)],
    walls: [],
    hidden: truth.hidden?.map(([a, b]): Stretch => [toMetres(a), toMetres(b)]) ?? null,
  };
}

function planFacts({ features }: PlanFile, toMetres: ToMetres): StoreyFacts {
  const ofKind = (kind: string) =>
    features.flatMap(({ geometry, properties }) =>
      geometry && properties.kind === kind ? [{ geometry, properties }] : [],
    );
  const polygonOf = ({ type, coordinates }: Geometry, kind: string): Polygon => {
    if (type !== 'Polygon') throw new Error(`${kind}: expected a Polygon, found ${type}`);
    return (coordinates as readonly Coordinates[]).map((ring) => openRing(ring, toMetres));
  };
  const polygons = (kind: string): Polygon[] => ofKind(kind).map(({ geometry }) => polygonOf(geometry, kind));
  return {
    primary: polygons('primary-boundary'),
    rooms: polygons('room'),
    roomHeights: ofKind('room').map(({ properties }) => Number(properties.heightM)),
    structures: polygons('secondary-boundary'),
    openings: ofKind('opening').map(({ geometry, properties }) => {
      const line = (geometry.coordinates as Coordinates).map(toMetres);
      return {
        kind: String(properties.type),
        from: line[0],
        to: line[line.length - 1],
        centre: centroidOfLine(line),
        width: lengthOf(line),
        sill: Number(properties.sillM),
        head: Number(properties.headM),
      };
    }),
    outer: [],
    walls: ofKind('wall').map(({ geometry, properties }) => ({
      outline: polygonOf(geometry, 'wall'),
      thickness: Number(properties.thicknessM),
      isInferred: properties.inferred === true,
    })),
    hidden: ofKind('inferred-stretch').flatMap(({ geometry }) => {
      const line = (geometry.coordinates as Coordinates).map(toMetres);
      return line.slice(1).map((point, i): Stretch => [line[i], point]);
    }),
  };
}

function lengthOf(line: readonly XY[]): number {
  return line.slice(1).reduce((sum, point, i) => sum + distance(line[i], point), 0);
}

function centroidOfLine(line: readonly XY[]): XY {
  const total = lengthOf(line);
  let [x, y] = [0, 0];
  for (let i = 1; i < line.length; i++) {
    const share = distance(line[i - 1], line[i]) / total;
    const [mx, my] = interpolate(line[i - 1], line[i], 0.5);
    x += mx * share;
    y += my * share;
  }
  return [x, y];
}
