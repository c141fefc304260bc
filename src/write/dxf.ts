import { circlesOf } from '../core/geometry/ring-arcs.ts';
import { ringsOf } from '../core/geometry/rings.ts';
import { circlesIn, type SourceCoordinates, sourceCoordinates } from '../core/source-coordinates.ts';
import type { FrameUnit, Polygon, Storey } from '../core/types.ts';
import { arcStrokes } from './arc-strokes.ts';
import { decimal, rounded } from './decimals.ts';
import { writeDxfObjects, writeDxfTables } from './dxf-tables.ts';
import { DxfTags, type Extent } from './dxf-tags.ts';
import type { Product } from './plan-writer.ts';
import { roundedPolygons } from './rounded-polygons.ts';

/** $INSUNITS by unit; pixels and units without a name are unitless. */
const INSERT_UNITS: Record<FrameUnit, number> = { m: 6, cm: 5, mm: 4, ft: 2, 'us-ft': 21, px: 0, custom: 0 };
/** Height of room names, m. */
const TEXT_HEIGHT = 0.2;

/** Decimals of bulges: 0.1 mm in the middle of an arc of a kilometre. */
const BULGE_DIGITS = 8;

/** Dashes of inferred lines, m: the sheet's 3 mm at 1:100. */
const DASH = 0.3;

/** Layers by AIA names; colours by AutoCAD's index, line weights in 1/100 mm as the sheet draws them. */
const DXF_LAYERS = [
  { name: 'A-WALL', colour: 7, lineType: 'Continuous', weight: 50 },
  { name: 'A-OUTLINE', colour: 8, lineType: 'Continuous', weight: 18 },
  { name: 'A-COLS', colour: 5, lineType: 'Continuous', weight: 35 },
  { name: 'A-GAP', colour: 30, lineType: 'DASHED', weight: 25 },
  { name: 'A-OPENING', colour: 3, lineType: 'Continuous', weight: 25 },
  { name: 'A-AREA', colour: 9, lineType: 'Continuous', weight: 18 },
  { name: 'A-FURN', colour: 8, lineType: 'DASHED', weight: 18 },
] as const;

type LayerName = (typeof DXF_LAYERS)[number]['name'];
/** In the drawing where something is on it only, since it is there on request. */
const ON_REQUEST: LayerName = 'A-FURN';

/**
 * Writes plan.dxf: an AutoCAD 2000 drawing of closed polylines on named layers, curved walls as arcs, z = 0, in source
 * units and coordinates, so it lies where the scan lies.
 */
export function writeDxf({ plan }: Product, storey: number): string {
  const to = sourceCoordinates(plan.frame);
  const entities = new Entities(to, 1 / plan.frame.metresPerUnit);
  drawStorey(plan.storeys[storey], entities);
  const tags = new DxfTags();
  // The format has no place for it that every CAD program reads or passes over, but comments.
  if (plan.frame.crs !== undefined) tags.addComment(`Coordinate system: ${plan.frame.crs}`);
  writeHeader(tags, plan.frame.unit, entities.extent);
  tags.section('CLASSES', () => {});
  const handles = writeDxfTables(tags, {
    layers: DXF_LAYERS.filter(({ name }) => name !== ON_REQUEST || entities.layers.has(name)),
    dash: DASH / plan.frame.metresPerUnit,
    extent: entities.extent,
  });
  tags.section('ENTITIES', () => {
    for (const write of entities.writers) write(tags, handles.modelSpace);
  });
  writeDxfObjects(tags, handles);
  return tags.end();
}

function writeHeader(tags: DxfTags, unit: FrameUnit, extent: Extent): void {
  const isImperial = unit === 'ft' || unit === 'us-ft';
  tags.section('HEADER', () => {
    tags.add([9, '$ACADVER'], [1, 'AC1015'], [9, '$DWGCODEPAGE'], [3, 'ANSI_1252']);
    tags.add([9, '$INSUNITS'], [70, INSERT_UNITS[unit]], [9, '$MEASUREMENT'], [70, isImperial ? 0 : 1]);
    tags.add([9, '$EXTMIN'], [10, extent.min[0]], [20, extent.min[1]], [30, '0.0']);
    tags.add([9, '$EXTMAX'], [10, extent.max[0]], [20, extent.max[1]], [30, '0.0']);
    tags.addHandleSeed();
  });
}

function drawStorey(storey: Storey, entities: Entities): void {
  for (const polygon of storey.primary) entities.polygon('A-OUTLINE', polygon);
  for (const { outline } of storey.walls) entities.polygon('A-WALL', outline);
  for (const { outline } of storey.secondary) entities.polygon('A-COLS', outline);
  for (const { name, outline } of storey.rooms) {
    entities.polygon('A-AREA', outline);
    entities.text('A-AREA', name, outline);
  }
  for (const { from, to } of storey.openings) entities.line('A-OPENING', from, to);
  for (const { from, to } of storey.gaps) entities.line('A-GAP', from, to);
  for (const { outline } of storey.furniture ?? []) entities.polygon('A-FURN', outline);
}

/** A vertex as written. */
interface PolylinePlace {
  readonly x: string;
  readonly y: string;
  /** Tangent of a quarter of the angle that the arc to the next vertex turns by, counter-clockwise. */
  readonly bulge?: string;
}

/** Collects entities and their extent, since the header that comes first needs it. */
class Entities {
  readonly writers: ((tags: DxfTags, owner: string) => void)[] = [];
  /** Those that something is on. */
  readonly layers = new Set<LayerName>();
  readonly #to: SourceCoordinates;
  readonly #unitsPerMetre: number;
  #box = [Infinity, Infinity, -Infinity, -Infinity];

  constructor(to: SourceCoordinates, unitsPerMetre: number) {
    this.#to = to;
    this.#unitsPerMetre = unitsPerMetre;
  }

  get extent(): Extent {
    const [minX, minY, maxX, maxY] = Number.isFinite(this.#box[0]) ? this.#box : [0, 0, 1, 1];
    const { digits } = this.#to;
    const write = (value: number) => decimal(value, digits);
    return { min: [write(minX), write(minY)], max: [write(maxX), write(maxY)] };
  }

  polygon(layer: LayerName, polygon: Polygon): void {
    const { digits } = this.#to;
    const place = (x: number, y: number) =>
      [rounded(this.#to.x(x), digits), rounded(this.#to.y(y), digits)] as const;
    const metresPerUnit = 1 / this.#unitsPerMetre;
    const circles = circlesIn(this.#to, metresPerUnit, circlesOf(polygon));
    for (const written of roundedPolygons(polygon, place, { circles, metresPerUnit })) {
      const { arcs = [] } = written.rounded;
      ringsOf([written.rounded]).forEach((ring, k) => {
        for (let i = 0; i < ring.length; i += 2) this.#include(ring[i], ring[i + 1]);
        const strokes = arcStrokes(
          ring,
          arcs.filter((arc) => arc.ring === k),
        );
        this.#polyline(
          layer,
          strokes.map(({ x, y, turn }) => ({
            x: decimal(x, digits),
            y: decimal(y, digits),
            ...(turn !== 0 && { bulge: decimal(Math.tan(turn / 4), BULGE_DIGITS) }),
          })),
          true,
        );
      });
    }
  }

  line(layer: LayerName, from: readonly [number, number], to: readonly [number, number]): void {
    const ends = [from, to].map((end) => {
      const [x, y] = this.#place(...end);
      return { x, y };
    });
    this.#polyline(layer, ends, false);
  }

  text(layer: LayerName, text: string, { outer }: Polygon): void {
    if (text === '') return;
    const [x, y] = this.#place(outer[0], outer[1]);
    const height = decimal(TEXT_HEIGHT * this.#unitsPerMetre, this.#to.digits);
    this.writers.push((tags, owner) => {
      tags.entity('TEXT', owner, layer);
      tags.add([100, 'AcDbText'], [10, x], [20, y], [30, '0.0'], [40, height]);
      tags.addText(1, text);
      tags.add([100, 'AcDbText']);
    });
  }

  #polyline(layer: LayerName, places: readonly PolylinePlace[], isClosed: boolean): void {
    this.layers.add(layer);
    this.writers.push((tags, owner) => {
      tags.entity('LWPOLYLINE', owner, layer);
      tags.add([100, 'AcDbPolyline'], [90, places.length], [70, isClosed ? 1 : 0], [43, '0.0'], [38, '0.0']);
      for (const { x, y, bulge } of places) {
        tags.add([10, x], [20, y]);
        if (bulge !== undefined) tags.add([42, bulge]);
      }
    });
  }

  #place(planX: number, planY: number): [x: string, y: string] {
    const [x, y] = [this.#to.x(planX), this.#to.y(planY)];
    this.#include(x, y);
    return [decimal(x, this.#to.digits), decimal(y, this.#to.digits)];
  }

  #include(x: number, y: number): void {
    const [minX, minY, maxX, maxY] = this.#box;
    this.#box = [Math.min(minX, x), Math.min(minY, y), Math.max(maxX, x), Math.max(maxY, y)];
  }
}
