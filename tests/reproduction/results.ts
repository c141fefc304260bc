import { type AlphaRange, alphaRange } from './alpha-range.ts';
import type { Experiments } from './experiments.ts';
import { type MeshSizes, meshSizes } from './meshes.ts';
import { type OutlineScore, scoreOutlines } from './outlines.ts';
import type { PaperSet } from './paper-sets.ts';
import { scorePasses } from './passes.ts';
import { scoreStructures } from './structures.ts';

/** Everything measured on one set but its times. */
export interface SetResults {
  /** In the order of `OUTLINE_METHODS`, `PASS_COMBINATIONS` and `STRUCTURE_METHODS`. */
  readonly outlines: readonly OutlineScore[];
  readonly passes: readonly OutlineScore[];
  readonly structures: readonly number[];
  readonly meshes: MeshSizes;
  readonly alpha: AlphaRange | null;
}

/** What the page tells beside the times; the same on every run. */
export interface Results extends Experiments {
  readonly sets: Readonly<Record<string, SetResults>>;
}

export async function measureSet(set: PaperSet): Promise<SetResults> {
  return {
    outlines: await scoreOutlines(set),
    passes: await scorePasses(set),
    structures: set.isRoom ? await scoreStructures(set) : [],
    meshes: await meshSizes(set),
    alpha: set.isRoom ? alphaRange(set) : null,
  };
}

/** As JSON to the ten-thousandth: more is noise, and machines may differ in the last digit. */
export function toJson(value: unknown): string {
  const rounded = (_: string, entry: unknown) =>
    typeof entry === 'number' ? Math.round(entry * 1e4) / 1e4 : entry;
  return `${JSON.stringify(value, rounded, 1)}\n`;
}
