import type { Building } from '../../fixtures/simulator/building.ts';
import type { SceneSpec } from '../../fixtures/simulator/index.ts';
import type { Pose } from '../../fixtures/simulator/pose.ts';
import { type Random, seededRandom } from '../../fixtures/simulator/random.ts';
import { DEFAULT_SCAN, MOBILE_SCAN, type ScanOptions } from '../../fixtures/simulator/scan.ts';
import { withOutdoors, withPanes } from '../../fixtures/simulator/surroundings.ts';
import { variedBuilding } from '../../fixtures/simulator/varied-buildings.ts';
import { RECIPES, type Recipe } from './recipes.ts';

/** Keeps a scan near half a million points. */
const MOST_RAYS = 560_000;

export interface CorpusScene {
  readonly name: string;
  readonly spec: () => SceneSpec;
  /** Kept back while working, so that nobody tunes to it. */
  readonly isHeldBack: boolean;
}

/** The seeds of a series lie in a thousand of their own. */
const SERIES_SEEDS = 1000;

/**
 * Every recipe twice. Of series 0 the even seed is worked with, the odd seed is kept back; all of another series may be looked
 * at: buildings of the same kinds that nobody has seen.
 */
export function corpusOf(series: number): readonly CorpusScene[] {
  return Object.entries(RECIPES).flatMap(([name, recipe], i) =>
    [100 + 2 * i, 101 + 2 * i].map((place) => {
      const seed = SERIES_SEEDS * series + place;
      return {
        name: `${name}-${seed}`,
        spec: () => specOf(name, recipe, seed),
        isHeldBack: series === 0 && seed % 2 === 1,
      };
    }),
  );
}

export const CORPUS = corpusOf(0);

/** The scene of a name, of any series. @throws Error where no series has it */
export function sceneNamed(name: string): CorpusScene {
  const seed = Number(/\d+$/.exec(name)?.[0]);
  const scene = corpusOf(Math.floor(seed / SERIES_SEEDS)).find((candidate) => candidate.name === name);
  if (scene === undefined) throw new Error(`the corpus has no scene ${name}`);
  return scene;
}

function specOf(name: string, recipe: Recipe, seed: number): SceneSpec {
  const random = seededRandom(seed, `corpus-${name}`);
  const building = variedBuilding(name, seed, recipe.sketch, recipe.variety);
  return {
    name: `${name}-${seed}`,
    building: recipe.hasGarden ? inGarden(building) : building,
    scan: scanOf(recipe, seed, random.fork('scan')),
    pose: poseOf(recipe, random.fork('pose')),
  };
}

function inGarden({ name, storeys }: Building): Building {
  return { name, storeys: storeys.map((storey) => withPanes(withOutdoors(storey))) };
}

function scanOf({ scan = {}, isMobile = false, variety }: Recipe, seed: number, random: Random): ScanOptions {
  const storeys = variety.storeys ?? 1;
  const { noiseMm: noise = [4, 8], voxelCm: voxel = [2.5, 4], ...rest } = scan;
  return {
    ...(isMobile ? MOBILE_SCAN : DEFAULT_SCAN),
    seed,
    noise: random.between(...noise) / 1000,
    voxel: random.between(...voxel) / 100,
    drift: isMobile ? 0.004 : random.pick([0, 0.002, 0.004]),
    mostRays: Math.floor(MOST_RAYS / storeys),
    ...rest,
  };
}

/** Eastings and northings of Munich in zone 32: large enough to cost float32 all its centimetres. */
const UTM_OFFSET = [691_870, 5_336_020, 519] as const;

function poseOf({ pose = {} }: Recipe, random: Random): Partial<Pose> {
  const heading = random.chance(0.15) ? 0 : random.between(-Math.PI, Math.PI);
  const offset = [random.between(-30, 30), random.between(-30, 30), random.between(-3, 3)] as const;
  const { isUtm = false, tiltDeg = 0, ...rest } = pose;
  return {
    heading,
    offset: isUtm ? UTM_OFFSET : offset,
    tilt: (tiltDeg * Math.PI) / 180,
    tiltTowards: random.between(-Math.PI, Math.PI),
    ...rest,
  };
}
