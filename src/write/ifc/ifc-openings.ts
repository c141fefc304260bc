import type { Polygon, Vec2, Vec3 } from '../../core/types.ts';
import type { Look } from './ifc-looks.ts';
import type { IfcModel } from './ifc-model.ts';
import type { Quantity } from './ifc-properties.ts';
import { asBoolean, asRatio } from './ifc-properties.ts';
import { LENGTH_DIGITS } from './ifc-shapes.ts';
import type { Ref } from './step-file.ts';
import { fixed, OMITTED } from './step-text.ts';
import { EVIDENCE } from './storey-model.ts';
import type { OpeningPart, WallPart } from './storey-parts.ts';

/** Members of what fills an opening, m. A scan does not show them: usual ones, for the eye. */
const LEAF = 0.04;
const FRAME = 0.06;
const GLASS = 0.02;

/** A wall in the file. */
export interface PlacedWall {
  readonly ref: Ref;
  readonly place: Ref;
  readonly part: WallPart;
}

/** Where openings are added. */
export interface OpeningHost {
  readonly place: Ref;
  /** By the index of their parts; without those that have no area. */
  readonly walls: ReadonlyMap<number, PlacedWall>;
}

/** An opening seen along itself: x from jamb to jamb, y to the left, z up. */
interface OpeningAxes {
  readonly at: Vec3;
  readonly x: Vec2;
  readonly depth: readonly [low: number, high: number];
}

/**
 * Cuts an opening out of every wall it goes through, an opening element each, since it may void one only, and fills the one
 * in the wall it takes most of with its door or window; passages stay open. Off every wall a door stands by itself.
 *
 * @returns elements for the storey to contain: the door or window
 */
export function addOpening(model: IfcModel, host: OpeningHost, part: OpeningPart, name: string): Ref[] {
  const axes = axesOf(part);
  const holes = part.walls.flatMap((i) => {
    const wall = host.walls.get(i);
    return wall === undefined ? [] : [{ wall, ...addHole(model, { part, axes, wall }, name) }];
  });
  if (part.opening.type === 'passage') return [];
  const [hole] = holes;
  const place =
    hole === undefined ? model.shapes.place(host.place, axes.at, axes.x) : model.shapes.place(hole.place);
  const filling = addFilling(model, { part, axes, place }, name);
  if (hole !== undefined) model.relation('IFCRELFILLSELEMENT', [hole.ref, filling], hole.ref, filling);
  const isExternal = hole?.wall.part.isExternal;
  const isDoor = part.opening.type === 'door';
  if (isExternal !== undefined) {
    const known = [['IsExternal', asBoolean(isExternal)]] as const;
    model.properties.properties(filling, isDoor ? 'Pset_DoorCommon' : 'Pset_WindowCommon', known);
  }
  const { confidence } = part.opening;
  model.properties.properties(filling, EVIDENCE, [['Confidence', asRatio(confidence)]]);
  return [filling];
}

function axesOf({ opening: { from, to, sill }, width, box }: OpeningPart): OpeningAxes {
  const x: Vec2 = [(to[0] - from[0]) / width, (to[1] - from[1]) / width];
  const aside: number[] = [];
  const outer = box?.base.outer ?? [];
  for (let i = 0; i < outer.length; i += 2) {
    aside.push((outer[i + 1] - from[1]) * x[0] - (outer[i] - from[0]) * x[1]);
  }
  const depth =
    box === null ? ([-LEAF / 2, LEAF / 2] as const) : ([Math.min(...aside), Math.max(...aside)] as const);
  return { at: [from[0], from[1], sill], x, depth };
}

interface Hole {
  readonly part: OpeningPart;
  readonly axes: OpeningAxes;
  readonly wall: PlacedWall;
}

function addHole(model: IfcModel, { part, axes, wall }: Hole, name: string): { ref: Ref; place: Ref } {
  const { shapes } = model;
  const { width } = part;
  const { sill, head, from, to } = part.opening;
  const place = shapes.place(wall.place, axes.at, axes.x);
  const [low, high] = axes.depth;
  const solid = shapes.prism(rectangleAt([0, low], [width, high]), head - sill);
  const ref = model.thing(
    'IFCOPENINGELEMENT',
    { role: 'opening', content: [...from, ...to, sill, head].join(' '), name },
    ...[place, shapes.body([[solid, 'opening']]), OMITTED, '.OPENING.'],
  );
  model.relation('IFCRELVOIDSELEMENT', [wall.ref, ref], wall.ref, ref);
  model.properties.quantities(ref, 'Qto_OpeningElementBaseQuantities', [
    ...face(width, head - sill),
    ['Depth', 'length', high - low],
    ['Volume', 'volume', width * (head - sill) * (high - low)],
  ]);
  return { ref, place };
}

const face = (width: number, height: number): Quantity[] => [
  ['Width', 'length', width],
  ['Height', 'length', height],
  ['Area', 'area', width * height],
];

interface Filling {
  readonly part: OpeningPart;
  readonly axes: OpeningAxes;
  readonly place: Ref;
}

function addFilling(model: IfcModel, { part, axes, place }: Filling, name: string): Ref {
  const { width } = part;
  const { type, sill, head, from, to } = part.opening;
  const height = head - sill;
  const isDoor = type === 'door';
  const solids = isDoor ? leaf(model, part, axes) : pane(model, part, axes);
  const filling = model.thing(
    isDoor ? 'IFCDOOR' : 'IFCWINDOW',
    { role: type, content: [...from, ...to, sill].join(' '), name },
    ...[place, model.shapes.body(solids), OMITTED],
    ...[fixed(height, LENGTH_DIGITS), fixed(width, LENGTH_DIGITS)],
    // How it opens is not known.
    ...(isDoor ? ['.DOOR.', '.NOTDEFINED.', OMITTED] : ['.WINDOW.', '.NOTDEFINED.', OMITTED]),
  );
  const set = isDoor ? 'Qto_DoorBaseQuantities' : 'Qto_WindowBaseQuantities';
  model.properties.quantities(filling, set, [
    ...face(width, height),
    ['Perimeter', 'length', 2 * (width + height)],
  ]);
  return filling;
}

/** A closed leaf in the middle of the wall. */
function leaf(model: IfcModel, { width, opening }: OpeningPart, { depth }: OpeningAxes): Solids {
  const [low, high] = inMiddle(depth, LEAF);
  const outline = rectangleAt([0, low], [width, high]);
  return [[model.shapes.prism(outline, opening.head - opening.sill), 'door']];
}

type Solids = (readonly [solid: Ref, look: Look])[];

/** A frame around a pane of glass, in the middle of the wall; where it is too small for a frame, the pane. */
function pane({ shapes }: IfcModel, { width, opening }: OpeningPart, { depth }: OpeningAxes): Solids {
  const height = opening.head - opening.sill;
  /** Profiles that stand upright across the opening, pushed through it against its y axis. */
  const upright = (y: number) => shapes.axes([0, y, 0], { z: [0, -1, 0], x: [1, 0, 0] });
  const frame = inMiddle(depth, FRAME);
  const glass = inMiddle(depth, GLASS);
  const isFramed = Math.min(width, height) > 3 * FRAME;
  const edge = isFramed ? FRAME : 0;
  const light = rectangleAt([edge, edge], [width - edge, height - edge]);
  const solids: Solids = [[shapes.prism(light, glass[1] - glass[0], upright(glass[1])), 'glass']];
  if (isFramed) {
    const around = { outer: rectangleAt([0, 0], [width, height]).outer, holes: [reversedOf(light.outer)] };
    solids.push([shapes.prism(around, frame[1] - frame[0], upright(frame[1])), 'frame']);
  }
  return solids;
}

/** A rectangle's corners the other way round. */
const reversedOf = (r: Float64Array) => Float64Array.of(r[0], r[1], r[6], r[7], r[4], r[5], r[2], r[3]);

/** So thick a layer in the middle of the wall, thinner where the wall is. */
function inMiddle([low, high]: readonly [number, number], thickness: number): [number, number] {
  const half = Math.min(thickness, high - low) / 2;
  const middle = (low + high) / 2;
  return [middle - half, middle + half];
}

/** The rectangle between two corners. */
function rectangleAt([x0, y0]: Vec2, [x1, y1]: Vec2): Polygon {
  return { outer: Float64Array.of(x0, y0, x1, y0, x1, y1, x0, y1), holes: [] };
}
