import { circlesOf } from '../../core/geometry/ring-arcs.ts';
import { boundsOfAll, inBounds, near } from '../../core/geometry/rings.ts';
import { rotationBy } from '../../core/geometry/square-turn.ts';
import { mapped, TEXT_SIZES } from '../../core/sheet.ts';
import { sourceCoordinates } from '../../core/source-coordinates.ts';
import type { FloorPlan, Frame, FrameUnit, Polygon, Storey, Vec2 } from '../../core/types.ts';
import { footprint } from '../../solid/sections.ts';
import { decimal } from '../decimals.ts';
import type { Product } from '../plan-writer.ts';
import { TICK } from '../sheet/chain-figures.ts';
import { cutWalls } from '../sheet/cut-walls.ts';
import { EXTENSION, extentOf, type Inside, TEXT_GAP } from '../sheet/dimensions.ts';
import { INCHES_PER_FOOT, METRES_PER_FOOT } from '../sheet/measure-words.ts';
import { sheetTurn } from '../sheet/sheet-turn.ts';
import { CAPITAL, widthByCapitals } from '../sheet/text-width.ts';
import { type DimensionFacts, drawDxfDimensions } from './dxf-dimensions.ts';
import { DxfDrawing, type DxfText } from './dxf-drawing.ts';
import { roomLabel } from './dxf-labels.ts';
import { type LayerNames, layersOf } from './dxf-layers.ts';
import { drawOpeningBlocks } from './dxf-openings.ts';
import { type DimensionStyle, writeDxfObjects, writeDxfTables } from './dxf-tables.ts';
import { DxfTags, type Extent } from './dxf-tags.ts';

/** $INSUNITS by unit; pixels and units without a name are unitless. */
const INSERT_UNITS: Record<FrameUnit, number> = { m: 6, cm: 5, mm: 4, ft: 2, 'us-ft': 21, px: 0, custom: 0 };
/** Decimals of dimensions by unit: a centimetre or the next finer digit. */
const DIMENSION_DECIMALS: Record<FrameUnit, number> = {
  ...{ m: 2, cm: 0, mm: 0, ft: 2, 'us-ft': 2, px: 2, custom: 2 },
};

/** Texts, dimensions and dashes are made for prints of 1:100. */
const SCALE = 100;
/** Metres in the building of a millimetre on such a print. */
const PER_MM = SCALE / 1000;
/** Lengths in mm on a print, as the sheet has them; of text, its capitals. */
const TEXT_HEIGHT = CAPITAL * TEXT_SIZES.room;
const FIGURE_HEIGHT = CAPITAL * TEXT_SIZES.label;
const DASH = 3;
const NOTE_GAP = 8;
const DIMENSIONS = {
  ...{
    textHeight: FIGURE_HEIGHT,
    textGap: TEXT_GAP,
    tick: TICK,
    extensionGap: 0,
    extensionOverhang: EXTENSION,
  },
};

/**
 * Writes plan.dxf: an AutoCAD 2000 drawing in model space with z = 0, in the source's units and coordinates, so that it
 * lies where the scan lies, or near the origin.
 *
 * Rooms are closed polylines with a text in each, walls are cut at openings, openings are blocks with attributes,
 * dimensions are such, curved walls arcs; layers have the names of a standard.
 */
export function writeDxf({ plan, options }: Product, storey: number): string {
  const { dxfLayers: layers, dxfCoordinates: coordinates } = options;
  const { frame } = plan;
  const { metresPerUnit } = frame;
  const offset = coordinates === 'local' ? localOffset(plan) : null;
  const to = sourceCoordinates(offset === null ? frame : lessOffset(frame, offset));
  const tags = new DxfTags();
  const drawing = new DxfDrawing({ to, metresPerUnit, names: layers });
  const style: DimensionStyle = {
    ...{ ...DIMENSIONS, scale: PER_MM / metresPerUnit, decimals: DIMENSION_DECIMALS[frame.unit] },
    ...(options.displayUnits === 'ft' && {
      inchesPerUnit: (metresPerUnit / METRES_PER_FOOT) * INCHES_PER_FOOT,
    }),
  };
  const turn = sheetTurn(plan.storeys);
  const isInFeet = options.displayUnits === 'ft';
  const labels = drawStorey(drawing, plan.storeys[storey], { turn, frame, isInFeet });
  drawOpeningBlocks(drawing, plan.storeys[storey], () => tags.handle());
  drawDimensions(drawing, plan.storeys[storey], {
    ...{ which: options.dimensions, turn, style, labels, nextHandle: () => tags.handle() },
  });
  // The format has no place for it that every CAD program reads or passes over, but comments.
  if (frame.crs !== undefined) tags.addComment(`Coordinate system: ${frame.crs}`);
  if (offset !== null) {
    const note = offsetNote(frame, offset);
    tags.addComment(note);
    drawNote(drawing, note);
  }
  return finish(tags, drawing, { layers, style, unit: frame.unit });
}

/** All of the file, once it is known what is drawn. */
function finish(
  tags: DxfTags,
  drawing: DxfDrawing,
  { layers, style, unit }: { layers: LayerNames; style: DimensionStyle; unit: FrameUnit },
): string {
  writeHeader(tags, unit, drawing.extent);
  tags.section('CLASSES', () => {});
  const handles = writeDxfTables(tags, {
    ...{ layers: layersOf(layers, drawing.used), blocks: drawing.blocks, extent: drawing.extent },
    ...{ dash: (DASH * PER_MM) / drawing.metresPerUnit, dimensions: style },
  });
  tags.section('ENTITIES', () => drawing.writeEntities(tags, handles.modelSpace));
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

/** What labels of rooms need beside them. */
interface Labelling {
  readonly turn: number;
  readonly frame: Frame;
  readonly isInFeet: boolean;
}

/** @returns the labels of rooms, as they were drawn */
function drawStorey(drawing: DxfDrawing, storey: Storey, labelling: Labelling): readonly DxfText[] {
  const curves = storey.walls.flatMap(({ outline }) => circlesOf(outline));
  const { cut, inferred } = cutWalls(storey);
  for (const polygon of cut) drawing.fill('wallPattern', polygon, curves);
  for (const polygon of storey.primary) drawing.polygon('outline', polygon);
  for (const polygon of cut) drawing.polygon('wall', polygon, { curves });
  for (const { polygon } of inferred) drawing.polygon('inferred', polygon, { curves });
  // Where no wall stands along a gap, as in the paper's outline alone, its line says so.
  const shown = new Set(inferred.map(({ gap }) => gap));
  storey.gaps.forEach(({ from, to }, gap) => {
    if (!shown.has(gap)) drawing.line('inferred', from, to);
  });
  for (const { outline, type } of storey.secondary) drawing.polygon(type, outline);
  for (const { outline } of storey.furniture ?? []) drawing.polygon('furniture', outline);
  return drawRooms(drawing, storey, labelling);
}

/** Every room with its text; where none are known, the area within the primary boundary. */
function drawRooms(
  drawing: DxfDrawing,
  { rooms, primary, secondary, furniture = [] }: Storey,
  labelling: Labelling,
): readonly DxfText[] {
  const labels: DxfText[] = [];
  const structures = secondary.map(({ outline }) => inBounds(outline));
  const movable = furniture.map(({ outline }) => inBounds(outline));
  const label = (name: string, outline: Polygon) => {
    const obstacles = near(structures, outline);
    const height = TEXT_HEIGHT * PER_MM;
    const facts = { name, outline, height, ...labelling };
    const besides = near(movable, outline);
    const clear = besides.length > 0 ? roomLabel({ ...facts, obstacles: [...obstacles, ...besides] }) : null;
    const isWhole = clear?.height === height && clear.angle === -labelling.turn;
    const text = isWhole ? clear : roomLabel({ ...facts, obstacles });
    drawing.text('roomLabel', text);
    labels.push(text);
  };
  for (const { name, outline } of rooms) {
    if (drawing.polygon('room', outline, { holes: 'roomVoid' })) label(name, outline);
  }
  const outlines = rooms.length > 0 ? [] : primary.filter(({ outer }) => outer.length > 0);
  for (const outline of outlines) label('', outline);
  return labels;
}

interface Dimensioning extends Pick<DimensionFacts, 'which' | 'turn' | 'style' | 'labels'> {
  readonly nextHandle: () => string;
}

function drawDimensions(
  drawing: DxfDrawing,
  storey: Storey,
  { nextHandle, turn, ...facts }: Dimensioning,
): void {
  const toSquare = rotationBy(turn);
  const squared = ({ outer, holes }: Polygon): Polygon => ({
    outer: mapped(outer, toSquare),
    holes: holes.map((hole) => mapped(hole, toSquare)),
  });
  const covered = footprint(storey).map(squared);
  if (covered.length === 0) return;
  const at = (place: Vec2): Vec2 => {
    const [x, y] = mapped(Float64Array.from(place), toSquare);
    return [x, y];
  };
  const inside: Inside = {
    rooms: storey.rooms.map((room) => ({ ...room, outline: squared(room.outline) })),
    openings: storey.openings.map((opening) => ({ ...opening, from: at(opening.from), to: at(opening.to) })),
  };
  const structures = storey.secondary.map(({ outline }) => squared(outline));
  const furniture = (storey.furniture ?? []).map(({ outline }) => squared(outline));
  const extent = extentOf(covered);
  const square = { covered, extent, inside, structures, furniture, turn, scale: SCALE };
  drawDxfDimensions(drawing, { ...facts, ...square }, nextHandle);
}

/** Whole units near the lower left corner of the building, the same for all its storeys. */
function localOffset({ frame, storeys }: FloorPlan): Vec2 {
  const { planOrigin, metresPerUnit } = frame;
  const rings = storeys.flatMap((storey) => footprint(storey).map(({ outer }) => outer));
  const { minX, minY } = rings.length > 0 ? boundsOfAll(rings) : { minX: 0, minY: 0 };
  return [Math.floor(planOrigin[0] + minX / metresPerUnit), Math.floor(planOrigin[1] + minY / metresPerUnit)];
}

function lessOffset(frame: Frame, [x, y]: Vec2): Frame {
  const { planOrigin } = frame;
  return { ...frame, planOrigin: [planOrigin[0] - x, planOrigin[1] - y, planOrigin[2]] };
}

/** What local coordinates lack of the source's; east and north where those are known to be such. */
function offsetNote({ crs }: Frame, [x, y]: Vec2): string {
  const [first, second] = crs === undefined ? ['X', 'Y'] : ['E', 'N'];
  return `Offset: add ${first} ${decimal(x, 0)}, ${second} ${decimal(y, 0)}`;
}

/** A line of text below all that is drawn. */
function drawNote(drawing: DxfDrawing, note: string): void {
  const { minX, minY } = drawing.bounds ?? { minX: 0, minY: 0 };
  const height = TEXT_HEIGHT * PER_MM;
  const half: Vec2 = [widthByCapitals(note, height) / 2, height / 2];
  const at: Vec2 = [minX + half[0], minY - NOTE_GAP * PER_MM];
  drawing.text('note', { lines: [note], at, height, angle: 0, half });
}
