import { beforeAll, describe, expect, test } from 'vitest';
import { simulate, writePly } from '../../../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../../../fixtures/simulator/layouts.ts';
import { type PaperSliceName, paperSlice } from '../../../../fixtures/simulator/slices.ts';
import { createStrokeTest } from '../../../../src/cli/canvas-stroke.ts';
import { vertexCount } from '../../../../src/core/geometry/rings.ts';
import type { Options } from '../../../../src/core/params.ts';
import type { StageResults } from '../../../../src/core/stage-results.ts';
import type { Storey } from '../../../../src/core/types.ts';
import { blobSource } from '../../../../src/read/bytes/blob-source.ts';
import { Session } from '../../../../src/session/session.ts';
import {
  drawPicture,
  hasPicture,
  PICTURE_NAMES,
  PICTURES,
  type PictureName,
} from '../../../../src/write/pictures/pictures.ts';
import { parseXml, type XmlElement } from '../drawing/strict-xml.ts';

/** What the page's own parser lets through. */
const SHAPES = new Set(['svg', 'title', 'desc', 'g', 'rect', 'circle', 'path', 'text', 'tspan']);
const MOST_BYTES = 1_000_000;

async function run(bytes: BlobPart, name: string, options: Partial<Options>): Promise<Session> {
  const session = new Session({ strokeTest: createStrokeTest() });
  // A run that fails leaves its evidence.
  await session.load(blobSource(new Blob([bytes]), name), options).catch(() => {});
  return session;
}

function runSlice(name: PaperSliceName, options: Partial<Options> = {}): Promise<Session> {
  const { xy } = paperSlice(name, 1);
  const rows = Array.from({ length: xy.length / 2 }, (_, i) => `${xy[2 * i]},${xy[2 * i + 1]}`);
  return run(`x,y\n${rows.join('\n')}\n`, `${name}.csv`, options);
}

function runHome(options: Partial<Options> = {}): Promise<Session> {
  const scan = { voxel: 0.05, raysPerStation: 40_000 };
  const { positions } = simulate({ name: 'home', building: homeBuilding(11, { shape: 'L' }), scan });
  return run(writePly({ positions }, { type: 'double' }), '<home> & "co".ply', options);
}

const drawn = (results: Partial<StageResults>): PictureName[] =>
  PICTURE_NAMES.filter((name) => drawPicture(name, results) !== null);

const captionOf = (svg: string): string =>
  parseXml(svg)
    .byId('caption')!
    .all('tspan')
    .map(({ text }) => text)
    .join(' ');

const elementsOf = (root: XmlElement): XmlElement[] => [root, ...root.childNodes.flatMap(elementsOf)];

let hallway: Session;
let room: Session;
let home: Session;
beforeAll(async () => {
  [hallway, room, home] = await Promise.all([
    runSlice('hallway-1'),
    runSlice('room-2', { secondaryCount: 1, secondaryRounds: 2 }),
    runHome({ secondaryMethod: 'robust' }),
  ]);
}, 60_000);

const passes = ['radial', 'douglas-peucker', 'visvalingam'] as const;

test('a ready slice has a picture of every stage but those of heights and structures', () => {
  expect(drawn(hallway.evidence)).toEqual(['cloud', 'slice', 'hull', ...passes, 'plan', 'model']);
});

test('a room with a structure has Fig. 3 a to d', () => {
  expect(drawn(room.evidence)).toEqual([
    ...['cloud', 'slice', 'hull', ...passes],
    ...['region', 'clusters', 'secondary-outline', 'secondary', 'plan', 'model'],
  ]);
});

test('a scan has its levels', () => {
  expect(drawn(home.evidence).slice(0, 4)).toEqual(['cloud', 'levels', 'slice', 'hull']);
});

test('the cloud shows where its scanners stood, unless that is far away', () => {
  const { crop } = home.evidence;
  const withStations = (stations: [number, number, number][]) =>
    drawPicture('cloud', { ...home.evidence, crop: { ...crop!, stations } })!;
  const { positions } = crop!;
  const near: [number, number, number] = [positions[0], positions[1], 1.5];
  expect(withStations([near])).toContain('Scanner');
  expect(withStations([[1e4, 0, 0]])).not.toContain('Scanner');
});

test('whether there is a picture is known without drawing it', async () => {
  const failed = await runSlice('room-2', { boundary: 'alpha-shape', alpha: 0.001 });
  for (const { evidence } of [hallway, room, home, failed]) {
    expect(PICTURE_NAMES.filter((name) => hasPicture(name, evidence))).toEqual(drawn(evidence));
  }
});

describe('every picture', () => {
  const everyOne = (): [PictureName, string, Session][] =>
    [hallway, room, home].flatMap((session) =>
      drawn(session.evidence).map((name): [PictureName, string, Session] => [
        name,
        drawPicture(name, session.evidence)!,
        session,
      ]),
    );

  test('is well-formed, of shapes and text alone, and small', () => {
    for (const [name, svg] of everyOne()) {
      expect(svg.length).toBeLessThan(MOST_BYTES);
      for (const { nodeName, attributes } of elementsOf(parseXml(svg))) {
        expect(SHAPES, name).toContain(nodeName);
        for (const [key, value] of attributes) {
          expect(key).not.toMatch(/^on|^style$|href/);
          expect(value, `${name} ${key}`).not.toMatch(/NaN|Infinity|undefined|url\(/);
        }
      }
    }
  });

  test('has each id once, its name, what it shows, and white paper', () => {
    for (const [name, svg] of everyOne()) {
      const root = parseXml(svg);
      const ids = elementsOf(root).flatMap((element) => element.getAttribute('id') ?? []);
      expect(new Set(ids).size, name).toBe(ids.length);
      expect(root.all('title')[0].text).toBe(PICTURES[name].label);
      expect(root.all('desc')[0].text).toContain(PICTURES[name].doc);
      expect(root.byId('paper')!.getAttribute('fill')).toBe('#FFFFFF');
    }
  });

  test('is the same when drawn again', () => {
    for (const [name, svg, session] of everyOne()) expect(drawPicture(name, session.evidence)).toBe(svg);
  });

  test('keeps its words on the page', () => {
    for (const [name, svg] of everyOne()) {
      const root = parseXml(svg);
      const [, , width, height] = root.getAttribute('viewBox')!.split(' ').map(Number);
      for (const text of root.all('text')) {
        const [x, y] = ['x', 'y'].map((key) => Number(text.getAttribute(key)));
        expect(x, name).toBeGreaterThanOrEqual(0);
        expect(x, name).toBeLessThan(width);
        expect(y, name).toBeGreaterThan(8);
        expect(y, name).toBeLessThan(height);
      }
      expect(captionOf(svg), name).not.toContain('…');
    }
  });
});

describe('counts are those of the results', () => {
  test('of the outline', () => {
    const { slice, boundary, regularise } = hallway.evidence;
    expect(captionOf(hallway.picture('slice')!)).toContain('1,799 points');
    expect(slice!.xy.length).toBe(2 * 1799);
    expect(captionOf(hallway.picture('hull')!)).toContain(`${vertexCount(boundary!.polygons)} vertices`);
    const [first, second] = regularise!.passes.map(({ polygons }) => vertexCount(polygons));
    expect(captionOf(hallway.picture('douglas-peucker')!)).toContain(`${first} → ${second} vertices`);
  });

  test('of clusters, of what the stroke drops and of the model', () => {
    const { clusters, searches } = room.evidence.secondary!;
    const svg = room.picture('clusters')!;
    const sizes = [0, 1].map((cluster) => clusters.filter((other) => other === cluster).length);
    sizes.forEach((size, cluster) => {
      expect(svg).toContain(`>${cluster}: ${size} points<`);
      const dots = parseXml(svg).byId(`cluster-${cluster}`)!.getAttribute('d')!;
      expect(dots.match(/h0/g)).toHaveLength(size);
    });
    const [{ rounds }] = searches;
    expect(rounds).toHaveLength(2);
    rounds.forEach(({ near, innermost }, i) => {
      const caption = captionOf(room.picture('secondary-outline', { round: i + 1 })!);
      expect(caption).toContain(`${near.length / 2} points`);
      expect(caption).toContain(`${(near.length - innermost.length) / 2} dropped`);
      expect(caption).toContain(`${innermost.length / 2} kept`);
    });
    const { indices } = room.evidence.solid!;
    expect(captionOf(room.picture('model')!)).toContain(`${indices.length / 3} triangles`);
  });

  test('of the levels', () => {
    const svg = home.picture('levels')!;
    for (const { points } of home.evidence.level!.levels) {
      expect(svg).toContain(`>${points.toLocaleString('en-GB')} points, `);
    }
    expect(svg.match(/, chosen</g)).toHaveLength(1);
  });
});

test('the stroke is as wide as the filter', () => {
  const root = parseXml(room.picture('secondary-outline')!);
  const scale = Number(root.getAttribute('data-pixels-per-metre'));
  // Ten of the paper's pixels at a hundred a metre.
  expect(Number(root.byId('stroke')!.getAttribute('stroke-width'))).toBeCloseTo(0.1 * scale, 1);
});

test('dots lie to scale: the extent of the slice in metres is that on the picture', () => {
  const root = parseXml(hallway.picture('slice')!);
  const scale = Number(root.getAttribute('data-pixels-per-metre'));
  let x = 0;
  const places = [
    ...root
      .byId('points')!
      .getAttribute('d')!
      .matchAll(/[Mm](-?[\d.]+)/g),
  ].map((found) => {
    x += Number(found[1]);
    return x;
  });
  const { xy } = hallway.evidence.slice!;
  const xs = xy.filter((_, i) => i % 2 === 0);
  const width = Math.max(...places) - Math.min(...places);
  expect(width / scale).toBeCloseTo(Math.max(...xs) - Math.min(...xs), 3);
});

test('a bridged gap is marked and can be picked by its number', async () => {
  const { evidence } = await run(roomWithGap(), 'gap.csv', {});
  expect(evidence.boundary!.gaps).toHaveLength(1);
  for (const name of ['hull', 'plan'] as const) {
    const gap = parseXml(drawPicture(name, evidence)!).byId('gap-0')!;
    expect(gap.getAttribute('data-pick')).toBe('gap:0');
  }
});

test('what nobody saw of a room is no bridged gap', () => {
  const { plan } = home.evidence;
  const [storey] = plan!.storeys;
  const gap = { from: [0, 0], to: [1, 0], width: 1 } as const;
  const withGap = (rooms: Storey['rooms']) =>
    drawPicture('plan', {
      ...home.evidence,
      plan: { ...plan!, storeys: [{ ...storey, rooms, gaps: [gap] }] },
    });
  expect(storey.rooms.length).toBeGreaterThan(0);
  expect(withGap(storey.rooms)).toContain('1 inferred stretch<');
  expect(withGap([])).toContain('1 bridged gap<');
});

/** A room of 6 m × 4 m whose lower wall is open over 1 m, in canvas pixels. */
function roomWithGap(): string {
  const rows = ['x,y'];
  for (let along = 0; along <= 600; along += 4) {
    rows.push(`${along},400`);
    if (along <= 250 || along >= 350) rows.push(`${along},0`);
    if (along <= 400) rows.push(`0,${along}`, `600,${along}`);
  }
  return `${rows.join('\n')}\n`;
}

test("a file's name and what it holds never get in", async () => {
  for (const { content } of await home.write('pictures')) expect(content).not.toMatch(/&lt;|&amp;|home/);
});

test('the time is told of a run in the session, never in the exported files', async () => {
  expect(captionOf(hallway.picture('hull')!)).toMatch(/ · Outline [\d.]+ ms$/);
  for (const { content } of await hallway.write('pictures'))
    expect(captionOf(content as string)).not.toMatch(/ ms$/);
});

test('exported pictures are numbered as in the table', async () => {
  const names = (await hallway.write('pictures')).map(({ name }) => name);
  expect(names.slice(0, 3)).toEqual(['picture-01-cloud.svg', 'picture-03-slice.svg', 'picture-04-hull.svg']);
});

describe('a run that fails leaves the pictures of the stages before', () => {
  test('at the level', async () => {
    const session = await runHome({ level: '50:60' });
    expect(session.result).toBeNull();
    expect(drawn(session.evidence)).toEqual(['cloud']);
    expect(session.picture('cloud')).not.toBeNull();
  });

  test('at the boundary', async () => {
    const session = await runSlice('room-1a', { boundary: 'alpha-shape', alpha: 0.001 });
    expect(session.result).toBeNull();
    expect(drawn(session.evidence)).toEqual(['cloud', 'slice']);
  });
});

test('nothing has run, nothing is drawn', () => {
  expect(drawn({})).toEqual([]);
  expect(new Session().picture('cloud')).toBeNull();
});
