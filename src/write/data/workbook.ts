import { escapeXml } from '../xml.ts';

/** How a cell looks; the number of its row in {@link STYLES} is its number in the file. */
const STYLES = {
  plain: { format: 0, bold: 0, wrap: 0 },
  heading: { format: 0, bold: 1, wrap: 1 },
  text: { format: 49, bold: 0, wrap: 0 },
  whole: { format: 1, bold: 0, wrap: 0 },
  metres: { format: 2, bold: 0, wrap: 0 },
  percent: { format: 9, bold: 0, wrap: 0 },
  boldText: { format: 49, bold: 1, wrap: 0 },
  boldWhole: { format: 1, bold: 1, wrap: 0 },
  boldMetres: { format: 2, bold: 1, wrap: 0 },
} as const;

export type CellStyle = keyof typeof STYLES;

/** Null is an empty cell; a formula comes with its value, for programs that do not reckon. */
export interface Cell {
  readonly value: string | number | null;
  readonly style: CellStyle;
  readonly formula?: string;
}

export interface WorkSheet {
  readonly name: string;
  /** Widths of columns, characters. */
  readonly widths: readonly number[];
  readonly rows: readonly (readonly Cell[])[];
  /** The first row stays in sight and on every printed page. */
  readonly hasHead: boolean;
  /** How many rows from the first can be filtered by its cells. */
  readonly filtered?: number;
}

/** A cell holds no longer text, UTF-16 units (Excel's limit). */
const LONGEST_TEXT = 32_767;
const MAIN = 'http://schemas.openxmlformats.org/spreadsheetml/2006/main';
const OFFICE = 'http://schemas.openxmlformats.org/officeDocument/2006/relationships';
const PACKAGE = 'http://schemas.openxmlformats.org/package/2006';
const SHEET_ML = 'application/vnd.openxmlformats-officedocument.spreadsheetml';
const HEAD = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n';

/**
 * Writes sheets as an Office Open XML workbook (ECMA-376, transitional): texts are texts and never formulas, equal sheets
 * give equal bytes.
 */
export async function writeWorkbook(sheets: readonly WorkSheet[]): Promise<Uint8Array<ArrayBuffer>> {
  const { strToU8, zipSync } = await import('fflate');
  const parts: Record<string, string> = {
    '[Content_Types].xml': contentTypes(sheets.length),
    '_rels/.rels': relations([['officeDocument', 'xl/workbook.xml']]),
    'xl/workbook.xml': workbookXml(sheets),
    'xl/_rels/workbook.xml.rels': relations([
      ...sheets.map((_, i) => ['worksheet', `worksheets/sheet${i + 1}.xml`] as const),
      ['styles', 'styles.xml'],
    ]),
    'xl/styles.xml': stylesXml(),
  };
  sheets.forEach((sheet, i) => {
    parts[`xl/worksheets/sheet${i + 1}.xml`] = sheetXml(sheet, i === 0);
  });
  const bytes = Object.entries(parts).map(([name, text]) => [name, strToU8(HEAD + text)] as const);
  // A fixed date: equal plans give equal bytes.
  return zipSync(Object.fromEntries(bytes), { mtime: '1980-01-01T00:00:00' }) as Uint8Array<ArrayBuffer>;
}

/** `A1`, `AB7`: columns and rows from 0. */
export function cellName(column: number, row: number): string {
  const letters =
    column < 26
      ? String.fromCharCode(65 + column)
      : String.fromCharCode(64 + Math.floor(column / 26), 65 + (column % 26));
  return `${letters}${row + 1}`;
}

function contentTypes(count: number): string {
  const sheet = (i: number) =>
    `<Override PartName="/xl/worksheets/sheet${i + 1}.xml" ContentType="${SHEET_ML}.worksheet+xml"/>`;
  return [
    `<Types xmlns="${PACKAGE}/content-types">`,
    `<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>`,
    `<Default Extension="xml" ContentType="application/xml"/>`,
    `<Override PartName="/xl/workbook.xml" ContentType="${SHEET_ML}.sheet.main+xml"/>`,
    `<Override PartName="/xl/styles.xml" ContentType="${SHEET_ML}.styles+xml"/>`,
    ...Array.from({ length: count }, (_, i) => sheet(i)),
    '</Types>',
  ].join('');
}

function relations(targets: readonly (readonly [type: string, target: string])[]): string {
  const lines = targets.map(
    ([type, target], i) => `<Relationship Id="rId${i + 1}" Type="${OFFICE}/${type}" Target="${target}"/>`,
  );
  return `<Relationships xmlns="${PACKAGE}/relationships">${lines.join('')}</Relationships>`;
}

function workbookXml(sheets: readonly WorkSheet[]): string {
  const list = sheets.map(
    ({ name }, i) => `<sheet name="${escapeXml(name)}" sheetId="${i + 1}" r:id="rId${i + 1}"/>`,
  );
  const names = sheets.flatMap((sheet, i) => definedNames(sheet, i));
  const defined = names.length === 0 ? '' : `<definedNames>${names.join('')}</definedNames>`;
  return `<workbook xmlns="${MAIN}" xmlns:r="${OFFICE}"><sheets>${list.join('')}</sheets>${defined}<calcPr fullCalcOnLoad="1"/></workbook>`;
}

function definedNames({ name, hasHead, filtered, widths }: WorkSheet, i: number): string[] {
  const sheet = `'${escapeXml(name)}'!`;
  const define = (what: string, range: string, more = '') =>
    `<definedName name="_xlnm.${what}" localSheetId="${i}"${more}>${sheet}${range}</definedName>`;
  const last = cellName(widths.length - 1, (filtered ?? 1) - 1).replace(/(\D+)(\d+)/, '$$$1$$$2');
  return [
    ...(filtered === undefined ? [] : [define('_FilterDatabase', `$A$1:${last}`, ' hidden="1"')]),
    ...(hasHead ? [define('Print_Titles', '$1:$1')] : []),
  ];
}

function stylesXml(): string {
  const xfs = Object.values(STYLES).map(({ format, bold, wrap }) => {
    const alignment = wrap ? '<alignment vertical="top" wrapText="1"/>' : '<alignment vertical="top"/>';
    return `<xf numFmtId="${format}" fontId="${bold}" fillId="0" borderId="0" xfId="0" applyNumberFormat="1" applyFont="1" applyAlignment="1">${alignment}</xf>`;
  });
  const font = (bold: string) => `<font>${bold}<sz val="11"/><name val="Calibri"/><family val="2"/></font>`;
  return [
    `<styleSheet xmlns="${MAIN}">`,
    `<fonts count="2">${font('')}${font('<b/>')}</fonts>`,
    '<fills count="2"><fill><patternFill patternType="none"/></fill><fill><patternFill patternType="gray125"/></fill></fills>',
    '<borders count="1"><border><left/><right/><top/><bottom/><diagonal/></border></borders>',
    '<cellStyleXfs count="1"><xf numFmtId="0" fontId="0" fillId="0" borderId="0"/></cellStyleXfs>',
    `<cellXfs count="${xfs.length}">${xfs.join('')}</cellXfs>`,
    '<cellStyles count="1"><cellStyle name="Normal" xfId="0" builtinId="0"/></cellStyles>',
    '</styleSheet>',
  ].join('');
}

function sheetXml({ widths, rows, hasHead, filtered }: WorkSheet, isFirst: boolean): string {
  const pane = hasHead
    ? '<pane ySplit="1" topLeftCell="A2" activePane="bottomLeft" state="frozen"/><selection pane="bottomLeft"/>'
    : '';
  const columns = widths.map(
    (width, i) => `<col min="${i + 1}" max="${i + 1}" width="${width}" customWidth="1"/>`,
  );
  const last = cellName(widths.length - 1, (filtered ?? 1) - 1);
  return [
    `<worksheet xmlns="${MAIN}"><sheetPr><pageSetUpPr fitToPage="1"/></sheetPr>`,
    `<sheetViews><sheetView ${isFirst ? 'tabSelected="1" ' : ''}workbookViewId="0">${pane}</sheetView></sheetViews>`,
    `<cols>${columns.join('')}</cols>`,
    `<sheetData>${rows.map(rowXml).join('')}</sheetData>`,
    filtered === undefined ? '' : `<autoFilter ref="A1:${last}"/>`,
    '<pageMargins left="0.5" right="0.5" top="0.6" bottom="0.6" header="0.3" footer="0.3"/>',
    '<pageSetup paperSize="9" orientation="landscape" fitToHeight="0"/></worksheet>',
  ].join('');
}

function rowXml(cells: readonly Cell[], row: number): string {
  const all = cells.map((cell, column) => cellXml(cell, cellName(column, row)));
  return `<row r="${row + 1}">${all.join('')}</row>`;
}

function cellXml({ value, style, formula }: Cell, name: string): string {
  if (value === null) return '';
  const place = `<c r="${name}" s="${Object.keys(STYLES).indexOf(style)}"`;
  if (typeof value === 'string') {
    return `${place} t="inlineStr"><is><t xml:space="preserve">${textXml(value)}</t></is></c>`;
  }
  return `${place}>${formula === undefined ? '' : `<f>${escapeXml(formula)}</f>`}<v>${value}</v></c>`;
}

/** Cut to what a cell holds, between letters; `_x0041_` would be read as a letter of that code ([ECMA-376] 22.9.2.19). */
function textXml(text: string): string {
  const short = text.slice(0, LONGEST_TEXT).replace(/[\uD800-\uDBFF]$/, '');
  return escapeXml(short.replace(/_(?=x[0-9a-f]{4}_)/gi, '_x005F_'));
}
