import { LOOK_FROM, LOOK_TO, type WallLook } from './wall-look.ts';

/** A pane is flat within this, m, beside its noise, in deviations. */
const FLATNESS = 0.02;
const DEVIATIONS = 2;
/** It shows in columns of this width, m, in so many next to each other: jambs run across the wall, not along it. */
const COLUMN = 0.1;
const FEWEST_COLUMNS = 4;

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

/** Those of some columns that have enough of them beside each other. */
function inRuns(columns: ReadonlySet<number>): Set<number> {
  const kept = new Set<number>();
  for (const first of columns) {
    if (columns.has(first - 1)) continue;
    let end = first;
    while (columns.has(end)) end++;
    if (end - first >= FEWEST_COLUMNS) for (let column = first; column < end; column++) kept.add(column);
  }
  return kept;
}
