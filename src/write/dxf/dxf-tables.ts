import { rounded } from '../decimals.ts';
import { type DxfBlock, writeBlocks } from './dxf-blocks.ts';
import type { DxfLayer } from './dxf-layers.ts';
import type { DxfTag, DxfTags, Extent } from './dxf-tags.ts';

/** The text style: a face with letters of all scripts. */
const FONT = 'arial.ttf';
/** Applications that data of this drawing is of: AutoCAD, and the one whose data are descriptions of layers. */
const DESCRIPTIONS = 'AcAecLayerStandard';
export const DIMENSION_STYLE = 'PLAN';
/** Of dimensions inside rooms, which have no extension lines. */
export const ROOM_DIMENSION_STYLE = 'PLAN-ROOM';

export interface DxfHandles {
  /** Block record that owns the entities. */
  readonly modelSpace: string;
  readonly paperSpace: string;
  readonly modelLayout: string;
  readonly paperLayout: string;
  readonly plotStyle: string;
}

export interface DxfTableFacts {
  readonly layers: readonly DxfLayer[];
  readonly blocks: readonly DxfBlock[];
  /** Length of a dash in drawing units; gaps are a third of it. */
  readonly dash: number;
  readonly extent: Extent;
  readonly dimensions: DimensionStyle;
}

/** How dimensions are drawn; lengths in mm on paper. */
export interface DimensionStyle {
  /** Drawing units a millimetre on paper. */
  readonly scale: number;
  readonly textHeight: number;
  /** Between text and line. */
  readonly textGap: number;
  /** Half the length of an oblique tick along each axis. */
  readonly tick: number;
  /** Extension lines start so far from what is measured, and go so far past the line. */
  readonly extensionGap: number;
  readonly extensionOverhang: number;
  readonly decimals: number;
  /** Where figures are in feet and inches: inches a drawing unit. */
  readonly inchesPerUnit?: number;
}

/** A number without the noise of its last bits. */
const fine = (value: number) => rounded(value, 8);

/** Writes the TABLES and BLOCKS sections every AutoCAD 2000 drawing must have ([DXF2000] "Symbol table entries"). */
export function writeDxfTables(tags: DxfTags, facts: DxfTableFacts): DxfHandles {
  const { layers, blocks, dash, extent, dimensions } = facts;
  const handles: DxfHandles = {
    modelSpace: tags.handle(),
    paperSpace: tags.handle(),
    modelLayout: tags.handle(),
    paperLayout: tags.handle(),
    plotStyle: tags.handle(),
  };
  tags.section('TABLES', () => {
    writeViewport(tags, extent);
    writeLineTypes(tags, dash);
    writeLayers(tags, layers, handles.plotStyle);
    table(tags, 'STYLE', ['Standard'], (name, owner) => {
      record(tags, 'STYLE', 'AcDbTextStyleTableRecord', { name, owner });
      tags.add([40, '0.0'], [41, '1.0'], [50, '0.0'], [71, 0], [42, '2.5'], [3, FONT], [4, '']);
    });
    table(tags, 'VIEW', [], () => {});
    table(tags, 'UCS', [], () => {});
    table(tags, 'APPID', ['ACAD', DESCRIPTIONS], (name, owner) =>
      record(tags, 'APPID', 'AcDbRegAppTableRecord', { name, owner }),
    );
    writeDimensionStyles(tags, dimensions);
    const spaces = [
      { name: '*Model_Space', handle: handles.modelSpace, layout: handles.modelLayout },
      { name: '*Paper_Space', handle: handles.paperSpace, layout: handles.paperLayout },
    ];
    const others = blocks.map(({ name, handle }) => ({ name, handle, layout: '0' }));
    table(tags, 'BLOCK_RECORD', [...spaces, ...others], ({ name, handle, layout }, owner) => {
      tags.add([0, 'BLOCK_RECORD'], [5, handle], [330, owner], [100, 'AcDbSymbolTableRecord']);
      tags.add([100, 'AcDbBlockTableRecord'], [2, name], [340, layout]);
    });
  });
  writeBlocks(tags, { model: handles.modelSpace, paper: handles.paperSpace }, blocks);
  return handles;
}

/** Writes the OBJECTS section: dictionaries of groups, layouts and plot styles. */
export function writeDxfObjects(tags: DxfTags, handles: DxfHandles): void {
  const [root, groups, layouts, styles] = [tags.handle(), tags.handle(), tags.handle(), tags.handle()];
  const dictionary = (handle: string, owner: string, entries: readonly (readonly [string, string])[]) => {
    tags.add([0, 'DICTIONARY'], [5, handle], [330, owner], [100, 'AcDbDictionary'], [281, 1]);
    for (const [name, target] of entries) tags.add([3, name], [350, target]);
  };
  tags.section('OBJECTS', () => {
    dictionary(root, '0', [
      ['ACAD_GROUP', groups],
      ['ACAD_LAYOUT', layouts],
      ['ACAD_PLOTSTYLENAME', styles],
    ]);
    dictionary(groups, root, []);
    dictionary(layouts, root, [
      ['Model', handles.modelLayout],
      ['Layout1', handles.paperLayout],
    ]);
    tags.add([0, 'ACDBDICTIONARYWDFLT'], [5, styles], [330, root], [100, 'AcDbDictionary'], [281, 1]);
    tags.add([3, 'Normal'], [350, handles.plotStyle]);
    tags.add([100, 'AcDbDictionaryWithDefault'], [340, handles.plotStyle]);
    tags.add([0, 'ACDBPLACEHOLDER'], [5, handles.plotStyle], [330, styles]);
    const model = { name: 'Model', handle: handles.modelLayout, space: handles.modelSpace, order: 0 };
    const paper = { name: 'Layout1', handle: handles.paperLayout, space: handles.paperSpace, order: 1 };
    for (const layout of [model, paper]) writeLayout(tags, layouts, layout);
  });
}

/** A symbol table with its records; `write` makes one record and gets the table's handle as owner. */
function table<T>(
  tags: DxfTags,
  name: string,
  records: readonly T[],
  write: (record: T, owner: string) => void,
): void {
  const owner = tags.handle();
  tags.add([0, 'TABLE'], [2, name], [5, owner], [330, '0'], [100, 'AcDbSymbolTable'], [70, records.length]);
  if (name === 'DIMSTYLE') tags.add([100, 'AcDbDimStyleTable'], [71, records.length]);
  for (const each of records) write(each, owner);
  tags.add([0, 'ENDTAB']);
}

function record(
  tags: DxfTags,
  type: string,
  subclass: string,
  { name, owner }: { name: string; owner: string },
): void {
  tags.add([0, type], [5, tags.handle()], [330, owner], [100, 'AcDbSymbolTableRecord'], [100, subclass]);
  tags.add([2, name], [70, 0]);
}

/** Layer 0, which must be there, and the drawing's own with their descriptions. */
function writeLayers(tags: DxfTags, layers: readonly DxfLayer[], plotStyle: string): void {
  const zero: DxfLayer = { name: '0', doc: '', colour: 7, lineType: 'Continuous', weight: 25 };
  table(tags, 'LAYER', [zero, ...layers], ({ name, doc, colour, lineType, weight }, owner) => {
    record(tags, 'LAYER', 'AcDbLayerTableRecord', { name, owner });
    tags.add([62, colour], [6, lineType], [370, weight], [390, plotStyle]);
    if (doc !== '') tags.add([1001, DESCRIPTIONS], [1000, ''], [1000, doc]);
  });
}

/** Opens the drawing on its extent. */
function writeViewport(tags: DxfTags, { min, max }: Extent): void {
  const [width, height] = [Number(max[0]) - Number(min[0]), Number(max[1]) - Number(min[1])];
  const aspect = 1.6;
  const viewHeight = 1.2 * Math.max(height, width / aspect, 1e-3);
  const pair = (code: number, x: number, y: number): readonly DxfTag[] => [
    [code, x],
    [code + 10, y],
  ];
  table(tags, 'VPORT', ['*ACTIVE'], (name, owner) => {
    record(tags, 'VPORT', 'AcDbViewportTableRecord', { name, owner });
    tags.add(...pair(10, 0, 0), ...pair(11, 1, 1));
    tags.add(...pair(12, fine(Number(min[0]) + width / 2), fine(Number(min[1]) + height / 2)));
    tags.add(
      [16, 0],
      [26, 0],
      [36, 1],
      [17, 0],
      [27, 0],
      [37, 0],
      [40, fine(viewHeight)],
      [41, aspect],
      [42, 50],
    );
  });
}

function writeLineTypes(tags: DxfTags, dash: number): void {
  const types = [
    { name: 'ByBlock', doc: '', pattern: [] },
    { name: 'ByLayer', doc: '', pattern: [] },
    { name: 'Continuous', doc: 'Solid line', pattern: [] },
    { name: 'DASHED', doc: 'Dashed 3:1', pattern: [dash, -dash / 3] },
  ];
  table(tags, 'LTYPE', types, ({ name, doc, pattern }, owner) => {
    record(tags, 'LTYPE', 'AcDbLinetypeTableRecord', { name, owner });
    const total = pattern.reduce((sum, part) => sum + Math.abs(part), 0);
    tags.add([3, doc], [72, 65], [73, pattern.length], [40, fine(total)]);
    for (const part of pattern) tags.add([49, fine(part)], [74, 0]);
  });
}

/** The style every drawing has, and that of this one's chains: oblique ticks, text along the line and above it. */
function writeDimensionStyles(tags: DxfTags, style: DimensionStyle): void {
  const own: readonly DxfTag[] = [
    ...([
      [40, style.scale],
      [41, style.textHeight],
      [42, style.extensionGap],
    ] as const),
    ...([
      [44, style.extensionOverhang],
      [140, style.textHeight],
      [142, style.tick],
    ] as const),
    ...([
      [147, style.textGap],
      [73, 0],
      [74, 0],
      [77, 1],
    ] as const),
    // The text moves without its line where it does not fit.
    ...figureTags(style),
    [279, 2],
  ];
  const styles = ['Standard', DIMENSION_STYLE, ROOM_DIMENSION_STYLE];
  table(tags, 'DIMSTYLE', styles, (name, owner) => {
    // The one record whose handle has another code.
    tags.add([0, 'DIMSTYLE'], [105, tags.handle()], [330, owner], [100, 'AcDbSymbolTableRecord']);
    tags.add([100, 'AcDbDimStyleTableRecord'], [2, name], [70, 0], ...(name === 'Standard' ? [] : own));
    if (name === ROOM_DIMENSION_STYLE) tags.add([75, 1], [76, 1]);
  });
}

/** Decimal figures with a point, as many digits each; or feet, inches and eighths, their zeros as the sheet has them. */
function figureTags({ decimals, inchesPerUnit }: DimensionStyle): readonly DxfTag[] {
  if (inchesPerUnit === undefined) {
    return [
      [78, 0],
      [271, decimals],
      [277, 2],
      [278, 46],
    ];
  }
  return [
    [78, 3],
    [144, inchesPerUnit],
    [271, 3],
    [276, 2],
    [277, 4],
  ];
}

function writeLayout(
  tags: DxfTags,
  owner: string,
  { name, handle, space, order }: { name: string; handle: string; space: string; order: number },
): void {
  tags.add([0, 'LAYOUT'], [5, handle], [330, owner], [100, 'AcDbPlotSettings'], [1, ''], [2, 'none_device']);
  tags.add([4, ''], [6, ''], [70, order === 0 ? 1024 : 0], [72, 0], [73, 0], [74, 5], [7, '']);
  tags.add([100, 'AcDbLayout'], [1, name], [70, 1], [71, order]);
  tags.add([10, 0], [20, 0], [11, 420], [21, 297], [12, 0], [22, 0], [32, 0], [14, 0], [24, 0], [34, 0]);
  tags.add([15, 420], [25, 297], [35, 0], [146, 0], [13, 0], [23, 0], [33, 0]);
  tags.add([16, 1], [26, 0], [36, 0], [17, 0], [27, 1], [37, 0], [76, 0], [330, space]);
}
