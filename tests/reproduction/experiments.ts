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

/** Wall rings with a door gap: what it costs of the outline's area, a share of the true one. */
export interface DoorGaps {
  readonly byWidth: readonly GapsOfWidth[];
  readonly byOpeningLength: readonly GapsAtOpeningLength[];
}

export interface GapsOfWidth {
  /** m. */
  readonly width: number;
  readonly worst: number;
  readonly mean: number;
  /** The same with the safeguard switched off. */
  readonly worstWithout: number;
  readonly meanWithout: number;
}

export interface GapsAtOpeningLength {
  /** m. */
  readonly openingLength: number | 'auto';
  /** By room. */
  readonly worst: Readonly<Record<string, number>>;
  /** Worst error of the area of the same rooms without a gap: noise, and what so long an edge leaves closed. */
  readonly own: number;
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
  readonly doorGaps: DoorGaps;
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
