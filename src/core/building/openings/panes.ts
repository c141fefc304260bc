import { LOOK_FROM, LOOK_TO, type WallLook } from './wall-look.ts';

/** A pane is flat within this, m, beside its noise, in deviations. */
const FLATNESS = 0.02;
const DEVIATIONS = 2;
/** It shows in columns of this width, m, in so many along the wall: jambs run across it … */
const COLUMN = 0.1;
const FEWEST_COLUMNS = 4;
/** … with no more empty ones between two, as few rays come back. */
const MOST_EMPTY = 3;

/**
 * Points within a wall without those of panes: upright surfaces along the wall, as of glass, blinds, shutters.
 *
 * Glass sends some rays back. Its points stand at all heights all along an opening, where they would pass for jambs.
 * O(points).
 */
export function withoutPanes({ strip, noise }: WallLook, inside: readonly number[]): number[] {
  const { along, deep, high } = strip;
  const flat = Math.max(FLATNESS, DEVIATIONS * noise);
  // Layers overlap by half, so that one of them holds a pane whole.
  const columns = new Map<number, Set<number>>();
  for (const i of inside) {
    if (high[i] < LOOK_FROM || high[i] >= LOOK_TO) continue;
    const layer = Math.floor(deep[i] / flat);
    for (const own of [layer - 1, layer]) {
      const met = columns.get(own);
      if (met) met.add(Math.floor(along[i] / COLUMN));
      else columns.set(own, new Set([Math.floor(along[i] / COLUMN)]));
    }
  }
  for (const [layer, met] of columns) columns.set(layer, inRuns(met));
  return inside.filter((i) => {
    const layer = Math.floor(deep[i] / flat);
    const column = Math.floor(along[i] / COLUMN);
    return [layer - 1, layer].every((own) => !columns.get(own)?.has(column));
  });
}

/** The columns from the first to the last of those that are many and near each other. */
function inRuns(met: ReadonlySet<number>): Set<number> {
  const kept = new Set<number>();
  let run: number[] = [];
  for (const column of [...met].sort((a, b) => a - b).concat(Infinity)) {
    const last = run[run.length - 1] ?? column;
    if (column - last - 1 > MOST_EMPTY) {
      if (run.length >= FEWEST_COLUMNS) for (let own = run[0]; own <= last; own++) kept.add(own);
      run = [];
    }
    run.push(column);
  }
  return kept;
}
