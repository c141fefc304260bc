import { unzipSync } from 'fflate';
import readSheets from 'read-excel-file/node';
import { describe, expect, it } from 'vitest';
import type { FloorPlan } from '../../../../src/core/types.ts';
import { AREA_RULES, areaLines, roomLines } from '../../../../src/write/data/room-schedule.ts';
import { writeRoomsCsv } from '../../../../src/write/data/rooms-csv.ts';
import { writeRoomsXlsx } from '../../../../src/write/data/rooms-xlsx.ts';
import { planOf, rectangle, secondary } from '../../solid/plans.ts';
import { parseXml } from '../drawing/strict-xml.ts';
import { HOSTILE_NAMES, twoRooms } from './rooms-plans.ts';

const house = planOf(twoRooms(['Hall', 'Kitchen'], ['Bath', 'Bed']));
const sheetsOf = async (plan: FloorPlan) => {
  const sheets = await readSheets(Buffer.from(await writeRoomsXlsx({ plan })));
  return Object.fromEntries(sheets.map(({ sheet, data }) => [sheet, data]));
};

describe('the schedule', () => {
  it('measures rooms and counts what leads into them', () => {
    const [hall, kitchen] = roomLines(house);
    expect(hall).toMatchObject({ number: 1, storey: 0, name: 'Hall', doors: 1, windows: 1, passages: 0 });
    expect(kitchen).toMatchObject({ number: 2, doors: 1, windows: 0, passages: 1 });
    expect([hall.areaM2, hall.perimeterM, hall.volumeM3]).toEqual([12, 14, 30]);
    expect(roomLines(house).map(({ storey }) => storey)).toEqual([0, 0, 1, 1]);
  });

  it('adds up areas by its rules', () => {
    for (const area of areaLines(house)) {
      expect(area).toMatchObject({ rooms: 2, netInternalM2: 24, isPartlyInferred: true });
      expect(area.grossInternalM2).toBeCloseTo(6.2 * 4, 9);
      expect(area.grossExternalM2).toBeCloseTo(6.8 * 4.6, 4);
    }
  });

  it('counts a column with its room, and says so', () => {
    const [storey] = house.storeys;
    const column = secondary(rectangle(1, 1, 0.5, 0.5), 'subtract');
    const [area] = areaLines({ ...house, storeys: [{ ...storey, secondary: [column] }] });
    expect(area.netInternalM2).toBe(24);
    expect(AREA_RULES.netInternal).toContain('columns and shafts that stand free in a room are counted');
  });

  it('of an outline alone knows what is gross', () => {
    const [area] = areaLines(planOf());
    expect(area).toMatchObject({ rooms: 0, netInternalM2: null, volumeM3: null, isPartlyInferred: true });
    expect(area.grossInternalM2).toBeCloseTo(12, 9);
  });
});

describe('rooms.csv', () => {
  it('keeps its columns and has new ones at the end', () => {
    const [head, first] = writeRoomsCsv({ plan: house }).split('\n');
    expect(head).toBe(
      'name,storey,areaM2,heightM,confidence,number,perimeterM,volumeM3,doors,windows,passages',
    );
    expect(first).toBe('Hall,0,12,2.5,0.875,1,14,30,1,1,0');
  });
});

describe('rooms.xlsx, read by another program', () => {
  it('has every room with its measures', async () => {
    const { Rooms: rows } = await sheetsOf(house);
    expect(rows).toHaveLength(6);
    expect(rows[0].slice(0, 4)).toEqual(['No.', 'Storey', 'Room', 'Area (m²)']);
    for (const [i, line] of roomLines(house).entries()) {
      const [number, storey, name, area, around, height, volume, doors, windows, passages, sure] =
        rows[i + 1];
      expect([number, storey, name]).toEqual([line.number, line.storey, line.name]);
      expect([area, around, height]).toEqual([line.areaM2, line.perimeterM, line.heightM]);
      expect(volume).toBeCloseTo(line.volumeM3, 4);
      expect([doors, windows, passages, sure]).toEqual([line.doors, line.windows, line.passages, 0.875]);
    }
    expect(rows[5][3]).toBe(48);
    expect(rows[5][6]).toBeCloseTo(117.6, 4);
  });

  it('has totals of storeys and building, with their rules', async () => {
    const { Totals: rows } = await sheetsOf(house);
    expect(rows.slice(1, 3).map((row) => row.slice(0, 4))).toEqual([
      [0, 2, 24, 24.8],
      [1, 2, 24, 24.8],
    ]);
    expect(rows[3].slice(0, 4)).toEqual(['Building', 4, 48, 49.6]);
    expect(rows[3][4]).toBeCloseTo(62.56, 3);
    expect(rows[3][6]).toBe('partly inferred');
    const words = rows.slice(4).flat().join(' ');
    expect(words).toContain('between the inner faces');
    expect(words).toContain('approximate');
  });

  it('tells names as they are, and never reckons them', async () => {
    const plan = planOf(twoRooms([HOSTILE_NAMES[0], HOSTILE_NAMES[1]], [HOSTILE_NAMES[2], HOSTILE_NAMES[3]]));
    const { Rooms: rows } = await sheetsOf(plan);
    expect(rows.slice(1, 5).map((row) => row[2])).toEqual(HOSTILE_NAMES.slice(0, 4));
    const xml = sheetXml(await writeRoomsXlsx({ plan }));
    const formulas = [...xml.matchAll(/<f>(.*?)<\/f>/g)].map(([, formula]) => formula);
    expect(formulas.every((formula) => formula.startsWith('SUBTOTAL('))).toBe(true);
  });

  it('holds what a cell cannot: codes, forbidden letters, and texts of any length', async () => {
    const plan = planOf(twoRooms([HOSTILE_NAMES[4], HOSTILE_NAMES[5]]));
    const bytes = await writeRoomsXlsx({ plan });
    const xml = sheetXml(bytes);
    expect(xml).toContain('_x005F_x0041_ <');
    const longest = Math.max(...[...xml.matchAll(/<t [^>]*>([^<]*)</g)].map(([, text]) => text.length));
    expect(longest).toBe(32_767);
    for (const [name, part] of Object.entries(unzipSync(bytes))) {
      expect(() => parseXml(new TextDecoder().decode(part)), name).not.toThrow();
    }
  });

  it('is a file without rooms too, and the same file each time', async () => {
    const plan = planOf();
    const { Rooms: rooms, Totals: totals } = await sheetsOf(plan);
    expect(rooms).toHaveLength(1);
    expect(totals[1].slice(0, 4)).toEqual([0, 0, null, 12]);
    expect(totals[2].slice(0, 4)).toEqual(['Building', 0, null, 12]);
    expect(await writeRoomsXlsx({ plan })).toEqual(await writeRoomsXlsx({ plan }));
  });
});

function sheetXml(bytes: Uint8Array): string {
  return new TextDecoder().decode(unzipSync(bytes)['xl/worksheets/sheet1.xml']);
}
