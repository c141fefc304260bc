import type { Circle } from '../../core/geometry/circle.ts';
import { circlesOf } from '../../core/geometry/ring-arcs.ts';
import { type Bounds, ringsOf } from '../../core/geometry/rings.ts';
import { circlesIn, type SourceCoordinates } from '../../core/source-coordinates.ts';
import type { Polygon, Vec2 } from '../../core/types.ts';
import { arcStrokes } from '../arc-strokes.ts';
import { decimal, rounded } from '../decimals.ts';
import { roundedPolygons } from '../rounded-polygons.ts';
import type { DxfBlock } from './dxf-blocks.ts';
import { DXF_LAYERS, type LayerKind, type LayerNames } from './dxf-layers.ts';
import type { DxfTag, DxfTags, Extent } from './dxf-tags.ts';

/** Decimals of bulges and factors: 0.1 mm in the middle of an arc, or at the end of a line, of a kilometre. */
const FINE_DIGITS = 8;

/** Text is still read from the right where it leans back by less than this, radians. */
const LEANING = Math.PI / 6;

/** A vertex as written. */
interface PolylinePlace {
  readonly x: string;
  readonly y: string;
  /** Tangent of a quarter of the angle that the arc to the next vertex turns by, counter-clockwise; 0 where straight. */
  readonly bulge: string;
}

/** Text around a place. */
export interface DxfText {
  /** One a line. */
  readonly lines: readonly string[];
  /** Its middle, plan metres. */
  readonly at: Vec2;
  /** Of its letters, m. */
  readonly height: number;
  /** Radians, counter-clockwise. */
  readonly angle: number;
  /** Half of what it takes along itself and across, m, for the drawing's extent. */
  readonly half: Vec2;
}

/** A block put in place. */
export interface DxfInsert {
  readonly block: string;
  readonly at: Vec2;
  /** Factors along and across, m. */
  readonly scale: Vec2;
  readonly angle: number;
  readonly attributes: Readonly<Record<string, string>>;
  /** Of the attributes, which are not shown, m. */
  readonly textHeight: number;
}

/** Where a drawing lies and what its layers are called. */
export interface DrawingFacts {
  readonly to: SourceCoordinates;
  readonly metresPerUnit: number;
  readonly names: LayerNames;
}

type EntityWriter = (tags: DxfTags, owner: string) => void;

/** Collects the entities of model space, the blocks they need and their extent, which the header that comes first has. */
export class DxfDrawing {
  readonly blocks: DxfBlock[] = [];
  /** Those that something is on. */
  readonly used = new Set<LayerKind>();
  readonly metresPerUnit: number;
  readonly #to: SourceCoordinates;
  readonly #names: LayerNames;
  readonly #writers: EntityWriter[] = [];
  #box = [Infinity, Infinity, -Infinity, -Infinity];

  constructor({ to, metresPerUnit, names }: DrawingFacts) {
    this.#to = to;
    this.metresPerUnit = metresPerUnit;
    this.#names = names;
  }

  get extent(): Extent {
    const [minX, minY, maxX, maxY] = Number.isFinite(this.#box[0]) ? this.#box : [0, 0, 1, 1];
    const { digits } = this.#to;
    const write = (value: number) => decimal(value, digits);
    return { min: [write(minX), write(minY)], max: [write(maxX), write(maxY)] };
  }

  /** The extent so far in plan metres; null while there is nothing. */
  get bounds(): Bounds | null {
    const [minX, minY, maxX, maxY] = this.#box;
    if (!Number.isFinite(minX)) return null;
    const [x0, y0] = [this.#to.x(0), this.#to.y(0)];
    const metres = (value: number, zero: number) => (value - zero) * this.metresPerUnit;
    return { minX: metres(minX, x0), minY: metres(minY, y0), maxX: metres(maxX, x0), maxY: metres(maxY, y0) };
  }

  writeEntities(tags: DxfTags, modelSpace: string): void {
    for (const write of this.#writers) write(tags, modelSpace);
  }

  /** Something written in model space by other rules than those here. */
  add(kind: LayerKind, write: (tags: DxfTags, owner: string, layer: string) => void): void {
    const layer = this.#layer(kind);
    this.#writers.push((tags, owner) => write(tags, owner, layer));
  }

  /** A length in drawing units. */
  length(metres: number): string {
    return decimal(metres / this.metresPerUnit, this.#to.digits);
  }

  /** A place of the plan as written. */
  place([planX, planY]: Vec2): readonly [x: string, y: string] {
    const [x, y] = [this.#to.x(planX), this.#to.y(planY)];
    this.#include(x, y);
    return [decimal(x, this.#to.digits), decimal(y, this.#to.digits)];
  }

  /** The three tags of a place: `code`, `code + 10` and z of 0. */
  point(code: number, at: Vec2): readonly DxfTag[] {
    const [x, y] = this.place(at);
    return [
      [code, x],
      [code + 10, y],
      [code + 20, '0.0'],
    ];
  }

  /**
   * Closed polylines of an area.
   *
   * @param curves circles it may follow
   * @param holes the layer of its holes, where that is another
   * @returns whether any area is left once rounded
   */
  polygon(
    kind: LayerKind,
    polygon: Polygon,
    { curves, holes = kind }: { curves?: readonly Circle[]; holes?: LayerKind } = {},
  ): boolean {
    const written = this.#ringsOf(polygon, curves);
    for (const rings of written) {
      rings.forEach((places, i) => {
        this.#polyline(i === 0 ? kind : holes, places);
      });
    }
    return written.length > 0;
  }

  /** An area filled. */
  fill(kind: LayerKind, polygon: Polygon, curves?: readonly Circle[]): void {
    for (const rings of this.#ringsOf(polygon, curves)) {
      this.add(kind, (tags, owner, layer) => {
        tags.entity('HATCH', owner, layer);
        tags.add([100, 'AcDbHatch'], [10, '0.0'], [20, '0.0'], [30, '0.0']);
        tags.add(
          [210, '0.0'],
          [220, '0.0'],
          [230, '1.0'],
          [2, 'SOLID'],
          [70, 1],
          [71, 0],
          [91, rings.length],
        );
        rings.forEach((places, i) => {
          // The outer ring is external, a hole outermost of what is within; both are polylines with bulges, closed.
          tags.add([92, i === 0 ? 3 : 18], [72, 1], [73, 1], [93, places.length]);
          for (const { x, y, bulge } of places) tags.add([10, x], [20, y], [42, bulge]);
          tags.add([97, 0]);
        });
        tags.add([75, 0], [76, 1], [98, 0]);
      });
    }
  }

  line(kind: LayerKind, from: Vec2, to: Vec2): void {
    const [begin, end] = [this.point(10, from), this.point(11, to)];
    this.add(kind, (tags, owner, layer) => {
      tags.entity('LINE', owner, layer);
      tags.add([100, 'AcDbLine'], ...begin, ...end);
    });
  }

  text(kind: LayerKind, text: DxfText): void {
    const tagsOf = this.textTags(text);
    this.add(kind, (tags, owner, layer) => {
      tags.entity('MTEXT', owner, layer);
      tagsOf(tags);
    });
  }

  /** What comes after the head of a text; middle on its place. */
  textTags({ lines, at, height, angle, half }: DxfText): (tags: DxfTags) => void {
    const [cos, sin] = [Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle))];
    const [reachX, reachY] = [cos * half[0] + sin * half[1], sin * half[0] + cos * half[1]];
    this.place([at[0] - reachX, at[1] - reachY]);
    this.place([at[0] + reachX, at[1] + reachY]);
    const place = this.point(10, at);
    return (tags) => {
      tags.add([100, 'AcDbMText'], ...place, [40, this.length(height)], [41, '0.0'], [71, 5], [72, 5]);
      tags.addLongText(lines);
      tags.add([7, 'Standard'], [50, degrees(angle)]);
    };
  }

  insert(kind: LayerKind, { block, at, scale, angle, attributes, textHeight }: DxfInsert): void {
    const place = this.point(10, at);
    const factor = (metres: number) => decimal(metres / this.metresPerUnit, FINE_DIGITS);
    this.add(kind, (tags, owner, layer) => {
      const handle = tags.entity('INSERT', owner, layer);
      tags.add([100, 'AcDbBlockReference'], [66, 1], [2, block], ...place);
      tags.add([41, factor(scale[0])], [42, factor(scale[1])], [43, '1.0'], [50, degrees(angle)]);
      for (const [name, value] of Object.entries(attributes)) {
        tags.entity('ATTRIB', handle, layer);
        tags.add([100, 'AcDbText'], ...place, [40, this.length(textHeight)], [1, value]);
        tags.add([100, 'AcDbAttribute'], [2, name], [70, 1]);
      }
      tags.entity('SEQEND', handle, layer);
    });
  }

  /** Rings of an area as rounded, outer ones first, with their arcs; none where rounding leaves no area. */
  #ringsOf(polygon: Polygon, curves: readonly Circle[] = circlesOf(polygon)): PolylinePlace[][][] {
    const { digits } = this.#to;
    const place = (x: number, y: number) =>
      [rounded(this.#to.x(x), digits), rounded(this.#to.y(y), digits)] as const;
    const { metresPerUnit } = this;
    const circles = circlesIn(this.#to, metresPerUnit, curves);
    return roundedPolygons(polygon, place, { circles, metresPerUnit }).map((written) =>
      ringsOf([written.rounded]).map((ring, k) => {
        for (let i = 0; i < ring.length; i += 2) this.#include(ring[i], ring[i + 1]);
        const arcs = (written.rounded.arcs ?? []).filter((arc) => arc.ring === k);
        return arcStrokes(ring, arcs).map(({ x, y, turn }) => ({
          ...{ x: decimal(x, digits), y: decimal(y, digits) },
          bulge: turn === 0 ? '0' : decimal(Math.tan(turn / 4), FINE_DIGITS),
        }));
      }),
    );
  }

  #polyline(kind: LayerKind, places: readonly PolylinePlace[]): void {
    this.add(kind, (tags, owner, layer) => {
      tags.entity('LWPOLYLINE', owner, layer);
      tags.add([100, 'AcDbPolyline'], [90, places.length], [70, 1], [43, '0.0'], [38, '0.0']);
      for (const { x, y, bulge } of places) {
        tags.add([10, x], [20, y]);
        if (bulge !== '0') tags.add([42, bulge]);
      }
    });
  }

  #layer(kind: LayerKind): string {
    this.used.add(kind);
    return DXF_LAYERS[kind][this.#names];
  }

  #include(x: number, y: number): void {
    const [minX, minY, maxX, maxY] = this.#box;
    this.#box = [Math.min(minX, x), Math.min(minY, y), Math.max(maxX, x), Math.max(maxY, y)];
  }
}

/** An angle as written: degrees from 0 to less than 360. */
export function degrees(radians: number): string {
  const angle = rounded((radians * 180) / Math.PI, FINE_DIGITS);
  return decimal(((angle % 360) + 360) % 360, FINE_DIGITS);
}

/** The same direction or its opposite, so that text along it is read from below or the right: above −60° up to 120°. */
export function legible(angle: number): number {
  const most = Math.PI / 2 + LEANING;
  return angle > most ? angle - Math.PI : angle <= most - Math.PI ? angle + Math.PI : angle;
}
