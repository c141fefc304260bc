import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { type SceneSpec, simulate, writePly } from '../../fixtures/simulator/index.ts';
import {
  columnRoomBuilding,
  corridorBuilding,
  homeBuilding,
  officeBuilding,
  roundHallBuilding,
} from '../../fixtures/simulator/layouts.ts';
import { MOBILE_SCAN } from '../../fixtures/simulator/scan.ts';

/** Eastings and northings of Munich in zone 32: large enough to cost float32 all its centimetres. */
const UTM_OFFSET = [691_870, 5_336_020, 519] as const;

/** A small corpus: every outline, both scanners, every kind of pose. Made when first asked for. */
export const CORPUS: readonly (() => SceneSpec)[] = [
  () => ({ name: 'home', building: homeBuilding(101), pose: { heading: 0.14 } }),
  () => ({
    name: 'home-l-feet-tilted',
    building: homeBuilding(102, { shape: 'L' }),
    pose: { heading: -0.44, unit: 'ft', tilt: 0.035, tiltTowards: 1 },
  }),
  () => ({
    name: 'home-u-utm',
    building: homeBuilding(103, { shape: 'U' }),
    pose: { heading: 0.3, offset: UTM_OFFSET },
  }),
  () => ({
    name: 'home-t-y-up-millimetres',
    building: homeBuilding(104, { shape: 'T' }),
    pose: { heading: 0.2, unit: 'mm', up: 'y' },
  }),
  () => ({ name: 'home-skew', building: homeBuilding(105, { skew: 0.05 }) }),
  () => ({
    name: 'home-mobile',
    building: homeBuilding(106, { clutter: 1.4 }),
    scan: MOBILE_SCAN,
    pose: { heading: 0.7 },
  }),
  () => ({ name: 'office', building: officeBuilding(107), scan: { noise: 0.01, voxel: 0.05 } }),
  () => ({ name: 'round-hall', building: roundHallBuilding(108), pose: { heading: -0.13 } }),
  () => ({ name: 'corridor', building: corridorBuilding(109), pose: { heading: 0.5 } }),
  () => ({ name: 'column-room', building: columnRoomBuilding(110, 'round'), pose: { heading: 0.05 } }),
  () => ({ name: 'house', building: homeBuilding(111, { storeys: 2 }), scan: { voxel: 0.05 } }),
];

const root = resolve(import.meta.dirname, '../..');

/** Folder with the corpus, written anew only when the simulator or this list has changed. */
export function corpusFolder(): string {
  const folder = join(root, '.cache', `corpus-${sourceHash()}`);
  if (existsSync(folder)) return folder;
  const draft = `${folder}.draft`;
  mkdirSync(draft, { recursive: true });
  for (const make of CORPUS) writeScene(draft, make());
  renameSync(draft, folder);
  return folder;
}

function writeScene(folder: string, spec: SceneSpec): void {
  const { name, positions, truth } = simulate(spec);
  const isFar = positions.some((value) => Math.abs(value) > 1e5);
  writeFileSync(join(folder, `${name}.ply`), writePly({ positions }, { type: isFar ? 'double' : 'float' }));
  writeFileSync(join(folder, `${name}.gt.json`), JSON.stringify(truth));
}

function sourceHash(): string {
  const simulator = join(root, 'fixtures/simulator');
  const files = readdirSync(simulator).sort();
  const paths = [import.meta.filename, ...files.map((file) => join(simulator, file))];
  const hash = createHash('sha256');
  for (const path of paths) hash.update(readFileSync(path));
  return hash.digest('hex').slice(0, 12);
}
