import type { Options } from '../../src/core/params.ts';
import { type OutlineScore, scoreOf } from './outlines.ts';
import { type PaperSet, runSet } from './paper-sets.ts';

type PassOption = 'radialPass' | 'douglasPeuckerPass' | 'visvalingamPass';

const PASSES: readonly (readonly [option: PassOption, label: string])[] = [
  ['radialPass', 'radial distance'],
  ['douglasPeuckerPass', 'Douglas-Peucker'],
  ['visvalingamPass', 'Visvalingam'],
];

/** Some of the three passes: none, each alone, each pair, all. */
export interface PassCombination {
  readonly label: string;
  readonly given: Partial<Options>;
}

export const PASS_COMBINATIONS: readonly PassCombination[] = [
  ...combinations(),
  { label: 'all three, then corners (ours)', given: { cornerPass: true } },
];

/** Every combination of passes on one set, in the order of {@link PASS_COMBINATIONS}. */
export async function scorePasses(set: PaperSet): Promise<readonly OutlineScore[]> {
  const scores: OutlineScore[] = [];
  for (const { given } of PASS_COMBINATIONS) {
    const results = await runSet(set, { ...given, secondaryCount: 0 });
    scores.push(scoreOf(set, results.regularise.polygons, results));
  }
  return scores;
}

function combinations(): PassCombination[] {
  const all = Array.from({ length: 2 ** PASSES.length }, (_, bits) =>
    PASSES.filter((_, i) => bits & (1 << i)),
  );
  return all
    .sort((a, b) => a.length - b.length)
    .map((chosen) => ({
      label: chosen.length === 0 ? 'none' : chosen.map(([, label]) => label).join(' + '),
      given: Object.fromEntries(PASSES.map((pass) => [pass[0], chosen.includes(pass)])),
    }));
}
