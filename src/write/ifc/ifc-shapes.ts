import { ringsOf } from '../../core/geometry/rings.ts';
import type { Polygon, Ring, Vec2, Vec3 } from '../../core/types.ts';
import { rounded } from '../decimals.ts';
import { roundedPolygons } from '../rounded-polygons.ts';
import { LOOKS, type Look } from './ifc-looks.ts';
import type { Ref, StepFile } from './step-file.ts';
import { fixed, label, list, OMITTED, type StepValue } from './step-text.ts';

/** Decimals of a length, m: a wall of 5 cm is off by 0.02 % at most. */
export const LENGTH_DIGITS = 5;
/** … of a part of a unit vector: 10 µm at 10 km. */
const DIRECTION_DIGITS = 9;

/** Polygons as the file holds them: valid as rounded; those without area are left out. */
export function filePolygons(polygon: Polygon): Polygon[] {
  const place = (x: number, y: number) => [rounded(x, LENGTH_DIGITS), rounded(y, LENGTH_DIGITS)] as const;
  return roundedPolygons(polygon, place).map(({ rounded: { outer, holes } }) => ({ outer, holes }));
}

/**
 * Geometry as the Reference View takes it: swept solids of polylines.
 *
 * A curved wall is written by the chords the plan holds it in: so areas and volumes are the plan's in every reader, where
 * arcs would be cut into chords anew, by each as it likes.
 */
export class IfcShapes {
  readonly #file: StepFile;
  readonly #body: Ref;
  readonly #styles = new Map<Look, Ref>();
  readonly #layers = new Map<string, Ref[]>();

  /** @param body the context of bodies */
  constructor(file: StepFile, body: Ref) {
    this.#file = file;
    this.#body = body;
  }

  point(...coordinates: readonly number[]): Ref {
    const written = coordinates.map((value) => fixed(value, LENGTH_DIGITS));
    return this.#file.share('IFCCARTESIANPOINT', list(written));
  }

  direction(...parts: readonly number[]): Ref {
    return this.#file.share('IFCDIRECTION', list(parts.map((part) => fixed(part, DIRECTION_DIGITS))));
  }

  /** A system of axes at a place; z up and x as the plan's unless given. */
  axes(at: Vec3, { z, x }: { readonly z?: Vec3; readonly x?: Vec3 } = {}): Ref {
    const axis = z === undefined && x === undefined ? OMITTED : this.direction(...(z ?? [0, 0, 1]));
    const reference = z === undefined && x === undefined ? OMITTED : this.direction(...(x ?? [1, 0, 0]));
    return this.#file.share('IFCAXIS2PLACEMENT3D', this.point(...at), axis, reference);
  }

  /** @param x direction of the thing's own x axis seen from above; the parent's unless given */
  place(parent: Ref | null, at: Vec3 = [0, 0, 0], x?: Vec2): Ref {
    const axes = x === undefined ? this.axes(at) : this.axes(at, { x: [x[0], x[1], 0] });
    return this.#file.add('IFCLOCALPLACEMENT', parent ?? OMITTED, axes);
  }

  /** A prism over a polygon from its position up; the position is the thing's own place unless given. */
  prism(polygon: Polygon, height: number, position = this.axes([0, 0, 0])): Ref {
    const [outer, ...holes] = ringsOf([polygon]).map((ring) => this.#curve(ring));
    const profile =
      holes.length === 0
        ? this.#file.add('IFCARBITRARYCLOSEDPROFILEDEF', '.AREA.', OMITTED, outer)
        : this.#file.add('IFCARBITRARYPROFILEDEFWITHVOIDS', '.AREA.', OMITTED, outer, list(holes));
    const up = this.direction(0, 0, 1);
    return this.#file.add('IFCEXTRUDEDAREASOLID', ...[profile, position, up, fixed(height, LENGTH_DIGITS)]);
  }

  /** The shape of a thing made of prisms; omitted where they have no height. */
  prisms(polygons: readonly Polygon[], height: number, look: Look): StepValue {
    if (!(rounded(height, LENGTH_DIGITS) > 0)) return OMITTED;
    return this.body(polygons.map((polygon) => [this.prism(polygon, height), look] as const));
  }

  /** The shape of a thing made of solids, each with the look it has; omitted where there are none. */
  body(solids: readonly (readonly [solid: Ref, look: Look])[]): StepValue {
    if (solids.length === 0) return OMITTED;
    for (const [solid, look] of solids) {
      this.#file.add('IFCSTYLEDITEM', solid, list([this.#style(look)]), OMITTED);
    }
    const items = list(solids.map(([solid]) => solid));
    const shape = this.#file.add('IFCSHAPEREPRESENTATION', this.#body, "'Body'", "'SweptSolid'", items);
    const { layer } = LOOKS[solids[0][1]];
    const others = this.#layers.get(layer);
    if (others === undefined) this.#layers.set(layer, [shape]);
    else others.push(shape);
    return this.#file.add('IFCPRODUCTDEFINITIONSHAPE', OMITTED, OMITTED, list([shape]));
  }

  /** Writes the layers that all shapes are on. */
  end(): void {
    for (const [layer, shapes] of this.#layers) {
      this.#file.add('IFCPRESENTATIONLAYERASSIGNMENT', label(layer), OMITTED, list(shapes), OMITTED);
    }
  }

  #curve(ring: Ring): Ref {
    const places: StepValue[] = [];
    for (let i = 0; i < ring.length; i += 2) {
      places.push(list([fixed(ring[i], LENGTH_DIGITS), fixed(ring[i + 1], LENGTH_DIGITS)]));
    }
    const points = this.#file.add('IFCCARTESIANPOINTLIST2D', list(places));
    const round = list([...places.map((_, i) => `${i + 1}`), '1']);
    return this.#file.add('IFCINDEXEDPOLYCURVE', points, `(IFCLINEINDEX(${round}))`, '.F.');
  }

  #style(look: Look): Ref {
    const known = this.#styles.get(look);
    if (known !== undefined) return known;
    const { colour, transparency } = LOOKS[look];
    const rgb = this.#file.share('IFCCOLOURRGB', OMITTED, ...colour.map((part) => fixed(part, 3)));
    const rendering = this.#file.add(
      'IFCSURFACESTYLERENDERING',
      ...[rgb, fixed(transparency, 2), ...Array<StepValue>(6).fill(OMITTED), '.NOTDEFINED.'],
    );
    const style = this.#file.add('IFCSURFACESTYLE', label(look), '.BOTH.', list([rendering]));
    this.#styles.set(look, style);
    return style;
  }
}
