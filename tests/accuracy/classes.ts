import type { SceneSpec } from '../../fixtures/simulator/index.ts';
import { signedArea } from '../../fixtures/simulator/ring.ts';
import { DEFAULT_SCAN } from '../../fixtures/simulator/scan.ts';
import type { Truth } from '../../fixtures/simulator/truth.ts';

export const CLASSES = ['clean', 'hard', 'beyond'] as const;
export type SceneClass = (typeof CLASSES)[number];

/** How hard a scene is, written down with its truth. Metres, whatever the unit of the file. */
export interface SceneFacts {
  readonly class: SceneClass;
  readonly noise: number;
  readonly voxel: number;
  readonly scanner: 'static' | 'mobile';
  readonly ceilings: boolean;
  /** Share of the floor that furniture stands on. */
  readonly furnitureShare: number;
  /** Share of the wall faces, by length, that no ray met; measured. */
  readonly hiddenShare: number;
}

/** Truth with the facts of its scene, as the corpus writes it. */
export type CorpusTruth = Truth & { readonly scene?: SceneFacts };

/** What a scene may have at most to belong to its class; what has more is beyond. */
const LIMITS = {
  clean: { noise: 0.0101, furnitureShare: 0.2, hiddenShare: 0.06 },
  hard: { noise: 0.0221, furnitureShare: 0.4, hiddenShare: 0.3 },
} as const;

export function sceneFacts({ building, scan = {} }: SceneSpec, truth: Truth): SceneFacts {
  const { noise, voxel, pattern, ceilings } = { ...DEFAULT_SCAN, ...scan };
  const floors = building.storeys.flatMap(({ rooms }) => rooms.map(({ ring }) => signedArea(ring)));
  // Table tops and wall cupboards do not stand on the floor, but fill the room.
  const pieces = building.storeys.flatMap(({ furniture }) =>
    furniture
      .filter(({ top, bottom }) => top - bottom > 0.03 || bottom > 0.3)
      .map(({ ring }) => signedArea(ring)),
  );
  const storeys = 'storeys' in truth ? truth.storeys : [truth];
  const sum = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0);
  const furnitureShare = sum(pieces) / sum(floors);
  const hiddenShare = sum(storeys.map((storey) => storey.hiddenShare ?? 0)) / storeys.length;
  const figures = { noise, furnitureShare, hiddenShare };
  return { class: classOf(figures), ...figures, voxel, scanner: pattern, ceilings };
}

function classOf(figures: Pick<SceneFacts, 'noise' | 'furnitureShare' | 'hiddenShare'>): SceneClass {
  const fits = (name: 'clean' | 'hard'): boolean =>
    figures.noise <= LIMITS[name].noise &&
    figures.furnitureShare <= LIMITS[name].furnitureShare &&
    figures.hiddenShare <= LIMITS[name].hiddenShare;
  return fits('clean') ? 'clean' : fits('hard') ? 'hard' : 'beyond';
}
