import { sayCrs } from '../../core/source-coordinates.ts';
import type { FloorPlan } from '../../core/types.ts';
import { rounded } from '../decimals.ts';
import type { Product } from '../plan-writer.ts';
import { AREA_RULES, type AreaLine, areaLines, type RoomLine, roomLines, sum } from './room-schedule.ts';
import { type Cell, type CellStyle, cellName, type WorkSheet, writeWorkbook } from './workbook.ts';

/** Decimals of metres, square and cubic metres; shown are two. */
const DIGITS = 4;

interface Column {
  readonly label: string;
  readonly key: keyof RoomLine;
  readonly style: CellStyle;
  readonly width: number;
  /** Shown in bold under the last room. */
  readonly isSummed?: true;
}

const COLUMNS: readonly Column[] = [
  { label: 'No.', key: 'number', style: 'whole', width: 6 },
  { label: 'Storey', key: 'storey', style: 'whole', width: 8 },
  { label: 'Room', key: 'name', style: 'text', width: 30 },
  { label: 'Area (m²)', key: 'areaM2', style: 'metres', width: 14, isSummed: true },
  { label: 'Perimeter (m)', key: 'perimeterM', style: 'metres', width: 14 },
  { label: 'Height (m)', key: 'heightM', style: 'metres', width: 12 },
  { label: 'Volume (m³)', key: 'volumeM3', style: 'metres', width: 14, isSummed: true },
  { label: 'Doors', key: 'doors', style: 'whole', width: 8 },
  { label: 'Windows', key: 'windows', style: 'whole', width: 10 },
  { label: 'Passages', key: 'passages', style: 'whole', width: 10 },
  { label: 'Confidence', key: 'confidence', style: 'percent', width: 12 },
];

/**
 * Writes rooms.xlsx: the rooms with their measures, and the areas of storeys and building by rules told beside them. Sums
 * are formulas with their values; texts are never formulas.
 */
export async function writeRoomsXlsx({ plan }: Pick<Product, 'plan'>): Promise<Uint8Array<ArrayBuffer>> {
  const rooms = roomLines(plan).map(roundedLine);
  return writeWorkbook([roomsSheet(rooms), totalsSheet(plan, rooms)]);
}

function roundedLine(room: RoomLine): RoomLine {
  const entries = Object.entries(room).map(([key, value]) => [
    key,
    typeof value === 'number' ? rounded(value, DIGITS) : value,
  ]);
  return Object.fromEntries(entries);
}

function roomsSheet(rooms: readonly RoomLine[]): WorkSheet {
  const head = COLUMNS.map(({ label }) => text(label, 'heading'));
  const lines = rooms.map((room) => COLUMNS.map(({ key, style }): Cell => ({ value: room[key], style })));
  const last = COLUMNS.map(({ key, isSummed }, column): Cell => {
    if (key === 'name') return text('Total of the rooms shown', 'boldText');
    if (!isSummed) return { value: null, style: 'plain' };
    const range = `${cellName(column, 1)}:${cellName(column, rooms.length)}`;
    const value = rounded(sum(rooms.map((room) => room[key] as number)), DIGITS);
    // 109: the sum of the rows that a filter leaves.
    return { value, style: 'boldMetres', formula: `SUBTOTAL(109,${range})` };
  });
  return {
    name: 'Rooms',
    widths: COLUMNS.map(({ width }) => width),
    rows: rooms.length === 0 ? [head] : [head, ...lines, last],
    hasHead: true,
    ...(rooms.length > 0 && { filtered: rooms.length + 1 }),
  };
}

const TOTAL_LABELS = [
  'Storey',
  'Rooms',
  'Net internal area (m²)',
  'Gross internal area (m²)',
  'Gross external area (m²)',
  'Volume of rooms (m³)',
  'Note',
];

function totalsSheet(plan: FloorPlan, rooms: readonly RoomLine[]): WorkSheet {
  const areas = areaLines(plan);
  const storeys = areas.map((area, i) => storeyRow(area, plan.storeys[i].index, rooms));
  const notes = [
    ['Net internal area', AREA_RULES.netInternal],
    ['Gross internal area', AREA_RULES.grossInternal],
    ['Gross external area', AREA_RULES.grossExternal],
    ['Partly inferred', AREA_RULES.partlyInferred],
    ['Accuracy', AREA_RULES.approximate],
    ['Source', plan.source.name],
    ...(plan.frame.crs === undefined ? [] : [['Coordinate system', sayCrs(plan.frame.crs)]]),
  ].map(([label, words]) => [text(label, 'boldText'), text(words, 'text')]);
  return {
    name: 'Totals',
    widths: [22, 8, 16, 16, 16, 16, 18],
    rows: [
      TOTAL_LABELS.map((label) => text(label, 'heading')),
      ...storeys,
      buildingRow(areas, storeys),
      [],
      ...notes,
    ],
    hasHead: true,
  };
}

/** Sums of the sheet of rooms, where there are any. */
function storeyRow(area: AreaLine, storey: number, rooms: readonly RoomLine[]): Cell[] {
  const of = (key: keyof RoomLine) => {
    const column = COLUMNS.findIndex((candidate) => candidate.key === key);
    const [first, last] = [cellName(column, 1), cellName(column, rooms.length)];
    return `Rooms!${first}:${last}`;
  };
  const own = rooms.filter((room) => room.storey === storey);
  const summed = (key: 'areaM2' | 'volumeM3'): Cell =>
    own.length === 0
      ? { value: null, style: 'plain' }
      : {
          value: rounded(sum(own.map((room) => room[key])), DIGITS),
          style: 'metres',
          formula: `SUMIF(${of('storey')},${storey},${of(key)})`,
        };
  return [
    { value: storey, style: 'whole' },
    { value: area.rooms, style: 'whole' },
    summed('areaM2'),
    { value: rounded(area.grossInternalM2, DIGITS), style: 'metres' },
    { value: rounded(area.grossExternalM2, DIGITS), style: 'metres' },
    summed('volumeM3'),
    noteOf(area.isPartlyInferred),
  ];
}

/** The sums of the rows above; where no storey tells, nothing. */
function buildingRow(areas: readonly AreaLine[], storeys: readonly (readonly Cell[])[]): Cell[] {
  const summed = (column: number, style: CellStyle): Cell => {
    const values = storeys.map((row) => row[column].value).filter((value) => typeof value === 'number');
    if (values.length === 0) return { value: null, style: 'plain' };
    const range = `${cellName(column, 1)}:${cellName(column, storeys.length)}`;
    return { value: rounded(sum(values), DIGITS), style, formula: `SUM(${range})` };
  };
  return [
    text('Building', 'boldText'),
    summed(1, 'boldWhole'),
    ...[2, 3, 4, 5].map((column) => summed(column, 'boldMetres')),
    noteOf(areas.some(({ isPartlyInferred }) => isPartlyInferred)),
  ];
}

const noteOf = (isPartlyInferred: boolean): Cell => text(isPartlyInferred ? 'partly inferred' : '', 'text');

const text = (value: string, style: CellStyle): Cell => ({ value, style });
