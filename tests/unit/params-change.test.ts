import { createHash } from 'node:crypto';
import { beforeAll, describe, expect, it } from 'vitest';
import { simulate, writePly } from '../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../fixtures/simulator/layouts.ts';
import { structureSlice } from '../../fixtures/simulator/slices.ts';
import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import { type Options, PARAM_NAMES, PARAMS, type ParamName } from '../../src/core/params.ts';
import { blobSource } from '../../src/read/bytes/blob-source.ts';
import { Session } from '../../src/session/session.ts';

interface Change {
  /** `scan`: a furnished home; `slice`: a room with a structure, two columns; `tower`: a small storey (class 6) on a wide one (2). */
  readonly on: 'scan' | 'slice' | 'tower';
  readonly from?: Partial<Options>;
  readonly to: Partial<Options>;
}

/** Rooms have walls of their own thickness and need no outline. */
const OUTLINE = { planMethod: 'outline' } as const;

/** For every parameter a change that must be seen in what is written. */
const CHANGES: Record<Exclude<ParamName, 'seed'>, Change> = {
  preset: { on: 'scan', to: { preset: 'paper' } },
  planMethod: { on: 'scan', to: { planMethod: 'outline' } },
  resolution: { on: 'scan', to: { resolution: 0.2 } },
  pointBudget: { on: 'scan', to: { pointBudget: 2000 } },
  classes: { on: 'tower', from: { up: 'z', unit: 'm' }, to: { classes: '2' } },
  unit: { on: 'scan', to: { unit: 'ft' } },
  metresPerUnit: { on: 'scan', to: { metresPerUnit: 0.8 } },
  pixelsPerMetre: { on: 'slice', to: { pixelsPerMetre: 50 } },
  up: { on: 'scan', to: { up: 'x' } },
  levelling: { on: 'scan', to: { levelling: false } },
  crop: { on: 'scan', to: { crop: '-1,-1,4,30' } },
  outlierNeighbours: {
    on: 'scan',
    from: { outlierDeviations: 1, wallReach: 0 },
    to: { outlierNeighbours: 40 },
  },
  outlierDeviations: { on: 'scan', from: { wallReach: 0 }, to: { outlierDeviations: 0 } },
  level: { on: 'scan', to: { level: '0:1' } },
  levelRule: { on: 'tower', from: { up: 'z', unit: 'm' }, to: { levelRule: 'count' } },
  keepFloorAndCeiling: { on: 'scan', to: { keepFloorAndCeiling: true } },
  wallReach: { on: 'scan', to: { wallReach: 0 } },
  samplesPer50M2: { on: 'scan', to: { samplesPer50M2: 1000 } },
  boundary: { on: 'scan', from: OUTLINE, to: { boundary: 'convex' } },
  openingLength: { on: 'scan', from: OUTLINE, to: { openingLength: 5 } },
  bridgeGap: { on: 'slice', from: { openingLength: 0.08 }, to: { bridgeGap: 0 } },
  alpha: { on: 'scan', from: { planMethod: 'outline', boundary: 'alpha-shape' }, to: { alpha: 3 } },
  concavity: { on: 'scan', from: { planMethod: 'outline', boundary: 'concaveman' }, to: { concavity: 6 } },
  noisePass: { on: 'scan', from: OUTLINE, to: { noisePass: false } },
  radialPass: {
    on: 'slice',
    from: { douglasPeuckerPass: false, visvalingamPass: false },
    to: { radialPass: false },
  },
  douglasPeuckerPass: { on: 'slice', to: { douglasPeuckerPass: false } },
  visvalingamPass: { on: 'slice', from: { visvalingamEpsilon: 0.05 }, to: { visvalingamPass: false } },
  cornerPass: { on: 'scan', from: OUTLINE, to: { cornerPass: false } },
  epsilon: { on: 'scan', from: { planMethod: 'outline', cornerPass: false }, to: { epsilon: 0.3 } },
  visvalingamEpsilon: { on: 'slice', to: { visvalingamEpsilon: 0.5 } },
  secondaryCount: { on: 'slice', to: { secondaryCount: 1 } },
  secondaryMethod: { on: 'slice', from: { secondaryCount: 1 }, to: { secondaryMethod: 'robust' } },
  secondaryCluster: { on: 'slice', from: { secondaryCount: 1 }, to: { secondaryCluster: 0 } },
  secondaryOperation: { on: 'slice', from: { secondaryCount: 1 }, to: { secondaryOperation: ['add'] } },
  secondarySample: {
    on: 'slice',
    from: { secondaryCount: 1, secondaryEpsilon: 0, strokeWidth: 0.001 },
    to: { secondarySample: 0.05 },
  },
  strokeWidth: { on: 'slice', from: { secondaryCount: 1 }, to: { strokeWidth: 0.3 } },
  secondaryEpsilon: { on: 'slice', from: { secondaryCount: 1 }, to: { secondaryEpsilon: 0.4 } },
  secondaryRounds: { on: 'slice', from: { secondaryCount: 1 }, to: { secondaryRounds: 2 } },
  furniture: { on: 'scan', to: { furniture: true } },
  wallThickness: { on: 'scan', from: OUTLINE, to: { wallThickness: 0.4 } },
  wallSide: { on: 'scan', from: OUTLINE, to: { wallSide: 'centre' } },
  wallHeight: { on: 'scan', to: { wallHeight: 1 } },
  doors: { on: 'slice', to: { doors: '300,60,0.9' } },
  roomNames: { on: 'scan', to: { roomNames: '1,1=Kitchen' } },
  floorSlab: { on: 'scan', to: { floorSlab: false } },
  ceilingSlab: { on: 'scan', to: { ceilingSlab: true } },
  slabThickness: { on: 'scan', to: { slabThickness: 0.5 } },
  displayUnits: { on: 'scan', to: { displayUnits: 'ft' } },
  paperSize: { on: 'scan', to: { paperSize: 'A0' } },
  sheetScale: { on: 'scan', to: { sheetScale: '1:200' } },
  project: { on: 'scan', to: { project: 'Town hall' } },
  sheetDate: { on: 'scan', to: { sheetDate: '22 November 2026' } },
  north: { on: 'scan', to: { north: 30 } },
  dimensions: { on: 'scan', to: { dimensions: 'none' } },
  drawPoints: { on: 'scan', to: { drawPoints: true } },
  dxfLayers: { on: 'scan', to: { dxfLayers: 'iso13567' } },
  glbPacking: { on: 'scan', to: { glbPacking: 'meshopt' } },
  dxfCoordinates: { on: 'scan', to: { dxfCoordinates: 'local' } },
  csg: { on: 'slice', from: { secondaryCount: 1, csg: 'slabs' }, to: { csg: 'bsp' } },
};

const session: Partial<Record<Change['on'], Session>> = {};

beforeAll(async () => {
  const scan = { voxel: 0.06, raysPerStation: 20_000, stationsPerRoom: 1 };
  const pose = { tilt: 0.04 };
  const home = simulate({ name: 'home', building: homeBuilding(3), scan, pose });
  const { xy } = structureSlice();
  const rows = Array.from({ length: xy.length / 2 }, (_, i) => `${xy[2 * i]},${xy[2 * i + 1]}`);
  session.scan = await open(new Blob([writePly({ positions: home.positions })]), 'home.ply');
  const tower = [...squareWalls(5, 12_000, 0, 2), ...squareWalls(1, 4000, 2.5, 4)];
  session.tower = await open(new Blob([`x,y,z,class\n${tower.join('\n')}\n`]), 'tower.csv');
  session.slice = await open(new Blob([`x,y\n${rows.join('\n')}\n`]), 'room.csv');
});

/** Walls of a square: `count` points between two heights. */
function* squareWalls(half: number, count: number, low: number, high: number): Generator<string> {
  for (let i = 0; i < count; i++) {
    const along = (((i * 7919) % count) / count - 0.5) * 2 * half;
    const z = low + ((high - low) * i) / count;
    const [x, y] = [
      [along, -half],
      [half, along],
      [-along, half],
      [-half, -along],
    ][i % 4];
    yield `${x},${y},${z},${z < 2.25 ? 2 : 6}`;
  }
}

async function open(blob: Blob, name: string): Promise<Session> {
  const opened = new Session({ strokeTest: createStrokeTest() });
  await opened.load(blobSource(blob, name));
  return opened;
}

/** What shows a change: drawings tell of nearly all that comes before them. */
const formatsFor = (name: string) =>
  PARAMS[name as ParamName].stage === 'sheet' ? ['svg', 'dxf', 'glb'] : ['geojson', 'slice', 'glb'];

async function fingerprint(name: string, on: Change['on'], options: Partial<Options>): Promise<string> {
  await session[on]!.update(options);
  const hash = createHash('sha256');
  for (const format of formatsFor(name))
    for (const { content } of await session[on]!.write(format)) hash.update(content);
  return hash.digest('hex');
}

describe('every parameter changes what is written', () => {
  it.each(Object.entries(CHANGES))('%s', async (name, { on, from = {}, to }) => {
    expect(await fingerprint(name, on, { ...from, ...to })).not.toBe(await fingerprint(name, on, from));
  });

  it('covers the table', () => {
    expect(['seed', ...Object.keys(CHANGES)].sort()).toEqual([...PARAM_NAMES].sort());
  });
});
