/** Names of layers: the U.S. National CAD Standard's, or of fixed fields as in ISO 13567. */
export type LayerNames = 'ncs' | 'iso13567';

interface LayerRow {
  readonly ncs: string;
  readonly iso13567: string;
  readonly doc: string;
  /** AutoCAD's index, of those that can be read on black and on white. */
  readonly colour: number;
  readonly lineType: 'Continuous' | 'DASHED';
  /** 1/100 mm, as the sheet draws them. */
  readonly weight: number;
  /** In the drawing where something is on it only. */
  readonly isOnRequest?: true;
}

/**
 * What a drawing is parted into.
 *
 * NCS: discipline A, major and minor group by the AIA's list; HIDD, SHFT, OTHR and VOID are minor groups of our own, which
 * the standard allows. ISO 13567-2: agent (2 characters, A- the architect), element (6), presentation (2: E- element,
 * T- text, D- dimensions, H- hatching) and status (E, existing); it leaves the elements' codes to a classification, and
 * here they are words, so that people can read them.
 */
export const DXF_LAYERS = {
  wallPattern: {
    ...{ ncs: 'A-WALL-PATT', iso13567: 'A-WALL--H-E', doc: 'Walls: fill of the cut' },
    ...{ colour: 253, lineType: 'Continuous', weight: 13 },
  },
  outline: {
    ...{ ncs: 'A-FLOR-OTLN', iso13567: 'A-FLOOR-E-E', doc: 'Primary boundary of the storey' },
    ...{ colour: 8, lineType: 'Continuous', weight: 18 },
  },
  wall: {
    ...{ ncs: 'A-WALL', iso13567: 'A-WALL--E-E', doc: 'Walls, cut at openings' },
    ...{ colour: 7, lineType: 'Continuous', weight: 50 },
  },
  inferred: {
    ...{ ncs: 'A-WALL-HIDD', iso13567: 'A-WALLHIE-E', doc: 'Walls that no point shows: inferred' },
    ...{ colour: 30, lineType: 'DASHED', weight: 25 },
  },
  column: {
    ...{ ncs: 'A-COLS', iso13567: 'A-COLUMNE-E', doc: 'Columns' },
    ...{ colour: 150, lineType: 'Continuous', weight: 35 },
  },
  shaft: {
    ...{ ncs: 'A-FLOR-SHFT', iso13567: 'A-SHAFT-E-E', doc: 'Shafts' },
    ...{ colour: 150, lineType: 'Continuous', weight: 35 },
  },
  other: {
    ...{ ncs: 'A-FLOR-OTHR', iso13567: 'A-OTHER-E-E', doc: 'Other structures that stand in the storey' },
    ...{ colour: 150, lineType: 'Continuous', weight: 35 },
  },
  door: {
    ...{ ncs: 'A-DOOR', iso13567: 'A-DOOR--E-E', doc: 'Doors' },
    ...{ colour: 92, lineType: 'Continuous', weight: 25 },
  },
  window: {
    ...{ ncs: 'A-GLAZ', iso13567: 'A-WINDOWE-E', doc: 'Windows' },
    ...{ colour: 140, lineType: 'Continuous', weight: 25 },
  },
  passage: {
    ...{ ncs: 'A-WALL-HEAD', iso13567: 'A-PASSAGE-E', doc: 'Passages without a leaf: their heads' },
    ...{ colour: 92, lineType: 'DASHED', weight: 25 },
  },
  room: {
    ...{ ncs: 'A-AREA', iso13567: 'A-SPACE-E-E', doc: 'Rooms: net areas, one closed polyline each' },
    ...{ colour: 9, lineType: 'Continuous', weight: 18 },
  },
  roomVoid: {
    ...{ ncs: 'A-AREA-VOID', iso13567: 'A-VOID--E-E', doc: 'What is no part of the room around it' },
    ...{ colour: 9, lineType: 'Continuous', weight: 18 },
  },
  roomLabel: {
    ...{ ncs: 'A-AREA-IDEN', iso13567: 'A-SPACE-T-E', doc: 'Rooms: name and area' },
    ...{ colour: 7, lineType: 'Continuous', weight: 25 },
  },
  dimension: {
    ...{ ncs: 'A-ANNO-DIMS', iso13567: 'A-------D-E', doc: 'Dimensions' },
    ...{ colour: 1, lineType: 'Continuous', weight: 18 },
  },
  note: {
    ...{ ncs: 'A-ANNO-TEXT', iso13567: 'A-------T-E', doc: 'Notes' },
    ...{ colour: 7, lineType: 'Continuous', weight: 25 },
  },
  furniture: {
    ...{ ncs: 'A-FURN', iso13567: 'A-FURNITE-E', doc: 'Furniture' },
    ...{ colour: 8, lineType: 'DASHED', weight: 18, isOnRequest: true },
  },
} as const satisfies Record<string, LayerRow>;

export type LayerKind = keyof typeof DXF_LAYERS;

export interface DxfLayer extends Pick<LayerRow, 'doc' | 'colour' | 'lineType' | 'weight'> {
  readonly name: string;
}

/** The layers of a drawing by a standard's names. @param used kinds that something is on */
export function layersOf(names: LayerNames, used: ReadonlySet<LayerKind>): DxfLayer[] {
  return (Object.entries(DXF_LAYERS) as [LayerKind, LayerRow][])
    .filter(([kind, { isOnRequest }]) => isOnRequest === undefined || used.has(kind))
    .map(([, { [names]: name, doc, colour, lineType, weight }]) => ({ name, doc, colour, lineType, weight }));
}
