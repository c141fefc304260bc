import { doorGaps, recesses } from './door-gaps.ts';
import { narrowSpaces } from './narrow-spaces.ts';
import { secondaryCases } from './secondary-cases.ts';

/** Mean IoU of narrow rooms of one width, m, over seeds, noise and spacing. */
export interface NarrowSpaces {
  readonly width: number;
  readonly giftOpening: number;
  readonly alphaShape: number;
  readonly alphaShapeRegularised: number;
}

/** Wall rings with a door gap of one width, m: worst and mean error of the outline's area, a share of the true one. */
export interface DoorGaps {
  readonly width: number;
  readonly worst: number;
  readonly mean: number;
  /** The same with the safeguard switched off. */
  readonly worstWithout: number;
  readonly meanWithout: number;
}

/** Niches whose mouth is as wide and whose sides are scanned: IoU of the outline. */
export interface Recesses {
  readonly mouth: number;
  readonly lowest: number;
  readonly mean: number;
}

/** Shares of made-up rooms in which a method finds the structure with an IoU over 0.8. */
export interface CaseShares {
  readonly cases: number;
  readonly robust: number;
  readonly paper: number;
  readonly paperInner: number;
}

export interface StructureCases {
  readonly development: CaseShares;
  readonly keptBack: CaseShares;
  readonly byDifficulty: Readonly<Record<string, CaseShares>>;
}

/** Experiments beyond the six sets. */
export interface Experiments {
  readonly narrowSpaces: readonly NarrowSpaces[];
  readonly doorGaps: readonly DoorGaps[];
  readonly recesses: readonly Recesses[];
  readonly structureCases: StructureCases;
}

export async function runExperiments(): Promise<Experiments> {
  return {
    narrowSpaces: narrowSpaces(),
    doorGaps: doorGaps(),
    recesses: recesses(),
    structureCases: await secondaryCases(),
  };
}
