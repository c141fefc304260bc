/** Our Structured3D scores against the official ones. */
import { existsSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { broadOutline, eroded, filled, MAP_SIZE, type Pixel } from './pixel-map.ts';
import { structured3dScores } from './structured3d.ts';

interface OfficialCase {
  readonly gt: Pixel[][];
  readonly pred: Pixel[][];
  readonly outwall: Pixel[];
  readonly expect: Readonly<Record<string, number>>;
}

const read = (path: string): OfficialCase[] => JSON.parse(readFileSync(path, 'utf8'));
const committed = resolve(import.meta.dirname, '../../fixtures/structured3d/cases.json');
const all = resolve(import.meta.dirname, '../../../shared/design/s3d_golden.json');

function scores({ gt, pred, outwall }: OfficialCase): Record<string, number> {
  const found = structured3dScores(gt, pred, broadOutline(outwall));
  return {
    room_prec: found.roomPrecision,
    room_rec: found.roomRecall,
    corner_prec: found.cornerPrecision,
    corner_rec: found.cornerRecall,
    angles_prec: found.anglePrecision,
    angles_rec: found.angleRecall,
  };
}

function agrees(official: OfficialCase): boolean {
  const found = scores(official);
  return Object.entries(official.expect).every(([name, value]) => Math.abs(found[name] - value) < 1e-9);
}

describe('Structured3D scores', () => {
  it('are the official ones', () => {
    const cases = read(committed);
    expect(cases.length).toBeGreaterThan(20);
    expect(cases.flatMap((official, i) => (agrees(official) ? [] : [i]))).toEqual([]);
  });

  it.skipIf(!existsSync(all))(
    `are the official ones in all scenes${existsSync(all) ? '' : ` (skipped: no ${all})`}`,
    () => {
      const wrong = read(all).flatMap((official, i) => (agrees(official) ? [] : [i]));
      // A room of scene 114 has an IoU of 0.492 here and in the independent reference; officially it is found.
      expect(wrong).toEqual([114]);
    },
  );

  const room: Pixel[] = [
    [10, 10],
    [110, 10],
    [110, 90],
    [10, 90],
  ];
  const nothing = new Uint8Array(MAP_SIZE ** 2);

  it('by hand: a corner 11 px off, another with a wrong angle', () => {
    const off: Pixel[] = [
      [10, 10],
      [121, 10],
      [110, 90],
      [10, 90],
    ];
    const found = structured3dScores([room], [off], nothing);
    // The slanted side spoils the angle at (110, 90) as well as the corner at (121, 10).
    expect(found).toMatchObject({ roomPrecision: 1, cornerPrecision: 3 / 4, anglePrecision: 2 / 4 });
    expect(structured3dScores([room], [], nothing)).toMatchObject({ roomPrecision: 0, roomRecall: 0 });
  });

  it('by hand: rooms that overlap by more than rounding are wrong', () => {
    const shifted = (by: number): Pixel[] => room.map(([x, y]): Pixel => [x + by, y]);
    const wanted = [room, shifted(104)];
    expect(structured3dScores(wanted, [room, shifted(97)], nothing).roomPrecision).toBe(1);
    expect(structured3dScores(wanted, [room, shifted(90)], nothing).roomPrecision).toBe(0);
  });

  it('pixel maps: a square with its outline, worn away by 2 px, and beyond the border by nothing', () => {
    const square: Pixel[] = [
      [0, 0],
      [9, 0],
      [9, 9],
      [0, 9],
    ];
    const sum = (map: Uint8Array): number => map.reduce((total, value) => total + value, 0);
    expect(sum(filled(square))).toBe(100);
    expect(sum(eroded(filled(square)))).toBe(64);
  });
});
