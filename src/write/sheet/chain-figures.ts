import { TEXT_SIZES } from '../../core/sheet.ts';
import { textWidth } from './text-width.ts';

/** Half the length of an oblique tick along each axis, mm. */
export const TICK = 1.1;
/** Blank between a figure above its line and the ticks at either side, and between two figures below, mm. */
const BESIDE_TICK = 0.2;
const BETWEEN = 1;
/** A figure that stands below its line may be pushed aside so far, mm; where that is not enough, it is left out. */
const FARTHEST_PUSH = 4;

/** Where a figure of a chain stands. */
export interface FigurePlace {
  /** Its middle along the chain, mm. */
  readonly at: number;
  /** On the other side of the line. */
  readonly isBelow: boolean;
}

/** A figure below the line: the number and length of its stretch, where its middle should be, and its width, mm. */
interface Below {
  readonly stretch: number;
  readonly length: number;
  readonly middle: number;
  readonly width: number;
}

/**
 * Figures stand above the middle of their stretch, clear of its ticks; those too wide for it below, moved aside where
 * they would stand on one another, each as little as that takes; null for what finds no place.
 *
 * @param places of ticks along the chain, rising as it is read, mm
 * @param figures one a stretch
 */
export function placeFigures(places: readonly number[], figures: readonly string[]): (FigurePlace | null)[] {
  const below: Below[] = [];
  const placed = figures.map((figure, i): FigurePlace | null => {
    const width = textWidth(figure, TEXT_SIZES.label);
    const middle = (places[i] + places[i + 1]) / 2;
    const length = places[i + 1] - places[i];
    if (width + 2 * (TICK + BESIDE_TICK) <= length) return { at: middle, isBelow: false };
    below.push({ stretch: i, length, middle, width: width + BETWEEN });
    return null;
  });
  for (const { stretch, at } of placeBelow(below)) placed[stretch] = { at, isBelow: true };
  return placed;
}

/** Moved apart; of those that stand too far off their stretch then, the shortest stretches go without a figure. */
function placeBelow(figures: readonly Below[]): (Below & { at: number })[] {
  let left = [...figures];
  for (;;) {
    const groups = moveApart(left);
    const crowded = groups.find((group) =>
      group.some(({ at, middle }) => Math.abs(at - middle) > FARTHEST_PUSH),
    );
    if (crowded === undefined) return groups.flat();
    const shortest = crowded.reduce((least, each) => (each.length < least.length ? each : least));
    left = left.filter(({ stretch }) => stretch !== shortest.stretch);
  }
}

/** Groups that stand shoulder to shoulder, each about the mean of where its figures should be: isotonic regression. */
function moveApart(figures: readonly Below[]): (Below & { at: number })[][] {
  const groups: { figures: Below[]; from: number; width: number }[] = [];
  for (const figure of figures) {
    let group = { figures: [figure], from: figure.middle - figure.width / 2, width: figure.width };
    for (
      let last = groups.at(-1);
      last !== undefined && last.from + last.width > group.from;
      last = groups.at(-1)
    ) {
      groups.pop();
      const [a, b] = [last.figures.length, group.figures.length];
      const from = (a * last.from + b * (group.from - last.width)) / (a + b);
      group = { figures: [...last.figures, ...group.figures], from, width: last.width + group.width };
    }
    groups.push(group);
  }
  return groups.map(({ figures: own, from }) => {
    let end = from;
    return own.map((figure) => {
      end += figure.width;
      return { ...figure, at: end - figure.width / 2 };
    });
  });
}
