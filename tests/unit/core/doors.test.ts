import { describe, expect, it, test } from 'vitest';
import { formatDoors, parseDoors } from '../../../src/core/doors.ts';
import { FloorPlanError } from '../../../src/core/errors.ts';
import { parseParam, resolveOptions } from '../../../src/core/options.ts';
import { type DoorSite, placeDoors } from '../../../src/core/place-doors.ts';
import type { Gap, Opening, Ring, Warning } from '../../../src/core/types.ts';

const ring = (...coordinates: number[]): Ring => Float64Array.from(coordinates);

describe('the list of doors', () => {
  it.each([
    ['none', { gaps: false, cuts: [] }],
    ['gaps', { gaps: true, cuts: [] }],
    ['1,2,0.9', { gaps: false, cuts: [{ x: 1, y: 2, width: 0.9 }] }],
    [
      'gaps;691823.12,5336027.5,0.9;-3,4,1,2.1',
      {
        gaps: true,
        cuts: [
          { x: 691823.12, y: 5336027.5, width: 0.9 },
          { x: -3, y: 4, width: 1, height: 2.1 },
        ],
      },
    ],
  ])('%s is read and written', (text, doors) => {
    expect(parseDoors(text)).toEqual(doors);
    expect(formatDoors(doors)).toBe(text);
  });

  it('takes blanks and any order', () => {
    expect(formatDoors(parseDoors(' 1, 2 ,0.9 ; gaps '))).toBe('gaps;1,2,0.9');
  });

  it('takes sizes with a unit as the other lengths do, places as numbers only', () => {
    expect(parseDoors('1,2,90cm,7 ft').cuts).toEqual([{ x: 1, y: 2, width: 0.9, height: 2.1336 }]);
    expect(resolveOptions({ doors: 'gaps; 1,2,900 mm ;3,4,1m,2.1' }).doors).toBe('gaps;1,2,0.9;3,4,1,2.1');
    expect(parseParam('doors', '1,2,90cm')).toEqual({ doors: '1,2,0.9' });
    expect(() => parseDoors('1m,2,0.9')).toThrow(FloorPlanError);
    expect(() => parseDoors('1,2,90m')).toThrow(FloorPlanError);
  });

  it('takes the pixels of the paper once it knows how large they are', () => {
    const given = parseParam('doors', '1,2,90px');
    expect(given).toEqual({ doors: '1,2,90px' });
    expect(resolveOptions({ ...given, pixelsPerMetre: 50 }).doors).toBe('1,2,1.8');
    expect(() => parseDoors('1,2,90px')).toThrow(FloorPlanError);
  });

  it.each([
    ['', 1],
    ['doors', 1],
    ['gaps;', 2],
    ['1,2', 1],
    ['1,2,0.9;1,2,0.9,2,5', 2],
    ['1,,0.9', 1],
    ['1,2,0', 1],
    ['1,2,-1', 1],
    ['1,2,0.9,21', 1],
    ['1,2,NaN', 1],
    ['1e999,2,1', 1],
    ['none;1,2,1', 1],
  ])('refuses "%s", naming entry %i', (text, entry) => {
    let found: unknown;
    try {
      parseParam('doors', text);
    } catch (error) {
      found = error;
    }
    expect(found).toBeInstanceOf(FloorPlanError);
    expect(found).toMatchObject({ code: 'option/invalid', detail: { option: 'doors', entry } });
  });

  it('refuses what is no text', () => {
    expect(() => resolveOptions({ doors: 3 } as never)).toThrow(FloorPlanError);
  });
});

interface Site {
  readonly doors: string;
  readonly rings?: readonly Ring[];
  readonly gaps?: readonly Gap[];
  readonly frame?: Partial<DoorSite['frame']>;
  readonly given?: Parameters<typeof resolveOptions>[0];
  readonly height?: number;
}

function place({ doors, rings, gaps = [], frame = {}, given = {}, height = 2.5 }: Site) {
  const warnings: Warning[] = [];
  const outlines = (rings ?? [ring(0, 0, 6, 0, 6, 4, 0, 4)]).map((outer) => ({
    polygon: { outer, holes: [] },
    confidence: 0.7,
  }));
  const site = {
    outlines,
    gaps,
    frame: { planOrigin: [0, 0, 0], metresPerUnit: 1, ...frame } as DoorSite['frame'],
    height,
    options: resolveOptions({ ...given, doors }),
  };
  const openings = placeDoors(site, { warn: (warning) => warnings.push(warning) });
  return { openings, warnings, codes: warnings.map(({ code }) => code) };
}

const rounded = ({ from, to }: Opening) => [...from, ...to].map((value) => Math.round(value * 1e6) / 1e6 + 0);

test('a door lies on the axis of the nearest wall, centred at the foot of its place', () => {
  const { openings, codes } = place({ doors: '2,-0.3,0.9;5.9,2.2,1,2.2' });
  expect(codes).toEqual([]);
  expect(openings.map(rounded)).toEqual([
    [1.55, -0.1, 2.45, -0.1],
    [6.1, 1.7, 6.1, 2.7],
  ]);
  expect(openings).toMatchObject([
    { type: 'door', sill: 0, head: 2, confidence: 1 },
    { type: 'door', sill: 0, head: 2.2, confidence: 1 },
  ]);
});

test('walls centred on the outline carry the axis there', () => {
  const { openings } = place({ doors: '2,0.05,0.9', given: { wallSide: 'centre' } });
  expect(openings.map(rounded)).toEqual([[1.55, 0, 2.45, 0]]);
});

test("places are in the source's unit and coordinates, sizes in metres", () => {
  const frame = { planOrigin: [691_000_000, 5_336_000_000, 0], metresPerUnit: 0.001 } as const;
  const { openings } = place({ doors: '691002000,5335999900,0.9', frame });
  expect(openings.map(rounded)).toEqual([[1.55, -0.1, 2.45, -0.1]]);
});

test('a door is no higher than its wall', () => {
  expect(place({ doors: '2,0,0.9,3', height: 1.8 }).openings[0].head).toBe(1.8);
});

test('a courtyard has walls on its own side', () => {
  const hole = ring(2, 1, 2, 3, 4, 3, 4, 1);
  const { openings } = place({ doors: '3,1.05,0.6', rings: [hole] });
  expect(openings.map(rounded)).toEqual([[3.3, 1.1, 2.7, 1.1]]);
});

test('a place off every wall is left out and told with its distance', () => {
  const { openings, warnings } = place({ doors: '3,2,0.9' });
  expect(openings).toEqual([]);
  expect(warnings).toMatchObject([{ code: 'plan/door-off-wall' }]);
  expect(warnings[0].message).toContain('the nearest is 2.00 m away');
  expect(place({ doors: '3,2,0.9', rings: [] }).codes).toEqual(['plan/door-off-wall']);
});

test('a door at a corner is clipped to its wall, and told', () => {
  const { openings, warnings } = place({ doors: '0.3,0,1' });
  expect(openings.map(rounded)).toEqual([[0, -0.1, 0.8, -0.1]]);
  expect(warnings).toMatchObject([{ code: 'plan/door-too-wide' }]);
  expect(warnings[0].message).toContain('it was cut 0.80 m wide');
});

test('a door does not reach into the wall behind a corner', () => {
  // Centred walls reach half their thickness into the room.
  const centred = place({ doors: '0.3,0,1', given: { wallSide: 'centre' } });
  expect(centred.openings.map(rounded)).toEqual([[0.1, 0, 0.8, 0]]);
  // An outer wall behind a corner that juts into the room stands in the way.
  const ell = ring(0, 0, 6, 0, 6, 2, 3, 2, 3, 4, 0, 4);
  const jutting = place({ doors: '3.2,2,0.8', rings: [ell] });
  expect(jutting.openings.map(rounded)).toEqual([[3.6, 2.1, 3.2, 2.1]]);
  // Nor where its place lies in that wall.
  const within = place({ doors: '3.15,2.1,0.8', rings: [ell] });
  expect(within.openings.map(rounded)).toEqual([[3.55, 2.1, 3.2, 2.1]]);
});

test('a wall too short for any door takes none', () => {
  const niche = ring(0, 0, 6, 0, 6, 4, 3.3, 4, 3.3, 4.6, 3, 4.6, 3, 4, 0, 4);
  const facts = { doors: '3.15,4.6,0.9', rings: [niche] };
  const { openings, warnings } = place({ ...facts, given: { wallThickness: 0.4, wallSide: 'centre' } });
  expect(openings).toEqual([]);
  expect(warnings).toMatchObject([{ code: 'plan/door-too-wide' }]);
  expect(warnings[0].message).toContain('it was not cut');
  expect(place(facts).openings.map(rounded)).toEqual([[3.3, 4.7, 3, 4.7]]);
});

test('a curved wall and a wall of kinks take a door along their run', () => {
  const circle = Float64Array.from({ length: 240 }, (_, i) => {
    const angle = (2 * Math.PI * Math.floor(i / 2)) / 120;
    return 3 * (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle));
  });
  const [round] = place({ doors: '3,0,0.9', rings: [circle] }).openings;
  expect(Math.hypot(round.to[0] - round.from[0], round.to[1] - round.from[1])).toBeCloseTo(0.9, 6);
  expect(Math.abs(round.to[0] - round.from[0])).toBeLessThan(0.1);
  const kinked: number[] = [];
  for (let i = 0; i < 100; i++) kinked.push(0.06 * i, i % 2 === 0 ? 0 : 0.03);
  const [along] = place({ doors: '3,0,0.9', rings: [ring(...kinked, 6, 4, 0, 4)] }).openings;
  expect(along.to[0] - along.from[0]).toBeCloseTo(0.9, 1);
});

test('bridged gaps as wide as doors become doors, as sure as their wall', () => {
  const gap = (from: number, width: number): Gap => ({ from: [from, 0], to: [from + width, 0], width });
  const gaps = [gap(0.2, 0.5), gap(1, 0.9), gap(2.5, 3.2)];
  const { openings, codes } = place({ doors: 'gaps;5,4,0.8', gaps });
  expect(codes).toEqual([]);
  expect(openings.map(rounded)).toEqual([
    [1, -0.1, 1.9, -0.1],
    [5.4, 4.1, 4.6, 4.1],
  ]);
  expect(openings.map(({ confidence }) => confidence)).toEqual([0.7, 1]);
  expect(place({ doors: 'none', gaps }).openings).toEqual([]);
});
