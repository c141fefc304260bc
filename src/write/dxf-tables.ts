import type { DxfTag, DxfTags, Extent } from './dxf-tags.ts';

export interface DxfLayer {
  readonly name: string;
  /** AutoCAD's colour index. */
  readonly colour: number;
  readonly lineType: string;
  /** 1/100 mm */
  readonly weight: number;
}

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
  /** Length of a dash in drawing units; gaps are a third of it. */
  readonly dash: number;
  readonly extent: Extent;
}

/** Writes the TABLES and BLOCKS sections every AutoCAD 2000 drawing must have ([DXF2000] "Symbol table entries"). */
export function writeDxfTables(tags: DxfTags, { layers, dash, extent }: DxfTableFacts): DxfHandles {
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
    table(
      tags,
      'LAYER',
      [{ name: '0', colour: 7, lineType: 'Continuous', weight: 25 }, ...layers],
      (layer) => {
        record(tags, 'LAYER', 'AcDbLayerTableRecord', layer.name);
        tags.add([62, layer.colour], [6, layer.lineType], [370, layer.weight], [390, handles.plotStyle]);
      },
    );
    table(tags, 'STYLE', ['Standard'], (name) => {
      record(tags, 'STYLE', 'AcDbTextStyleTableRecord', name);
      tags.add([40, '0.0'], [41, '1.0'], [50, '0.0'], [71, 0], [42, '2.5'], [3, 'txt'], [4, '']);
    });
    table(tags, 'VIEW', [], () => {});
    table(tags, 'UCS', [], () => {});
    table(tags, 'APPID', ['ACAD'], (name) => record(tags, 'APPID', 'AcDbRegAppTableRecord', name));
    writeDimensionStyles(tags);
    const spaces = [
      ['*Model_Space', handles.modelSpace, handles.modelLayout],
      ['*Paper_Space', handles.paperSpace, handles.paperLayout],
    ] as const;
    table(tags, 'BLOCK_RECORD', spaces, ([name, handle, layout], owner) => {
      tags.add([0, 'BLOCK_RECORD'], [5, handle], [330, owner], [100, 'AcDbSymbolTableRecord']);
      tags.add([100, 'AcDbBlockTableRecord'], [2, name], [340, layout]);
    });
  });
  tags.section('BLOCKS', () => {
    writeBlock(tags, '*Model_Space', handles.modelSpace, false);
    writeBlock(tags, '*Paper_Space', handles.paperSpace, true);
  });
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
  if (name === 'DIMSTYLE') tags.add([100, 'AcDbDimStyleTable']);
  for (const each of records) write(each, owner);
  tags.add([0, 'ENDTAB']);
}

function record(tags: DxfTags, type: string, subclass: string, name: string): void {
  tags.add([0, type], [5, tags.handle()], [100, 'AcDbSymbolTableRecord'], [100, subclass]);
  tags.add([2, name], [70, 0]);
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
  table(tags, 'VPORT', ['*ACTIVE'], (name) => {
    record(tags, 'VPORT', 'AcDbViewportTableRecord', name);
    tags.add(...pair(10, 0, 0), ...pair(11, 1, 1));
    tags.add(...pair(12, Number(min[0]) + width / 2, Number(min[1]) + height / 2));
    tags.add([16, 0], [26, 0], [36, 1], [17, 0], [27, 0], [37, 0], [40, viewHeight], [41, aspect], [42, 50]);
  });
}

function writeLineTypes(tags: DxfTags, dash: number): void {
  const types = [
    { name: 'ByBlock', doc: '', pattern: [] },
    { name: 'ByLayer', doc: '', pattern: [] },
    { name: 'Continuous', doc: 'Solid line', pattern: [] },
    { name: 'DASHED', doc: 'Dashed 3:1', pattern: [dash, -dash / 3] },
  ];
  table(tags, 'LTYPE', types, ({ name, doc, pattern }) => {
    record(tags, 'LTYPE', 'AcDbLinetypeTableRecord', name);
    const total = pattern.reduce((sum, part) => sum + Math.abs(part), 0);
    tags.add([3, doc], [72, 65], [73, pattern.length], [40, total]);
    for (const part of pattern) tags.add([49, part], [74, 0]);
  });
}

function writeDimensionStyles(tags: DxfTags): void {
  table(tags, 'DIMSTYLE', ['Standard'], (name) => {
    // The one record whose handle has another code.
    tags.add([0, 'DIMSTYLE'], [105, tags.handle()], [100, 'AcDbSymbolTableRecord']);
    tags.add([100, 'AcDbDimStyleTableRecord'], [2, name], [70, 0]);
  });
}

function writeBlock(tags: DxfTags, name: string, owner: string, isPaper: boolean): void {
  const space: readonly DxfTag[] = isPaper ? [[67, 1]] : [];
  tags.add([0, 'BLOCK'], [5, tags.handle()], [330, owner], [100, 'AcDbEntity'], ...space, [8, '0']);
  tags.add([100, 'AcDbBlockBegin'], [2, name], [70, 0], [10, 0], [20, 0], [30, 0], [3, name], [1, '']);
  tags.add([0, 'ENDBLK'], [5, tags.handle()], [330, owner], [100, 'AcDbEntity'], ...space, [8, '0']);
  tags.add([100, 'AcDbBlockEnd']);
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
