import { countOf } from '../../core/count-words.ts';
import { type ChosenLevel, storeyRange } from '../../core/level.ts';
import type { StageResults } from '../../core/stage-results.ts';
import type { Level, PointCloud } from '../../core/types.ts';
import { dots, element, path, pixels, text } from './marks.ts';
import { type Drawing, MARGIN } from './page.ts';
import { ACCENT, INK, MUTED, PALE } from './palette.ts';
import { sampler, shownShare } from './top-view.ts';

/** Left of the words, px: the side view; and its height, which no building's proportions would give. */
const VIEW_WIDTH = 356;
const VIEW_HEIGHT = 280;
const WORDS_AT = MARGIN + VIEW_WIDTH + 14;
const POINT = 1.4;
const SMALL = 11;
const BIG = 12;
/** Least distance of two lines of words, px. */
const LINE = 14;

/** Fig. 2: the cloud from the side with the three levels' bounding boxes, their cuts and the heights they stand for. */
export function drawLevels({ crop: cloud, outliers: kept, level }: Partial<StageResults>): Drawing | null {
  if (!cloud || !kept || !level || cloud.isFlat) return null;
  const side = sideView(cloud, kept);
  const references = referenceHeights(level.levels);
  const shownKept = side.points(side.low, side.high);
  const accented = side.points(...level.band);
  const boxes = level.levels.flatMap((one) => levelBox(one, side));
  return {
    height: MARGIN + VIEW_HEIGHT + 8,
    items: [
      dots(shownKept, { colour: PALE, size: POINT }),
      dots(accented, { colour: ACCENT, size: POINT, opacity: 0.8 }),
      ...boxes,
      ...(level.chosen === null ? bandBox(level.band, side) : []),
      ...referenceMarks(references, side),
      ...levelWords(level, side),
    ],
    counts: [
      countOf(kept.length, 'point'),
      `${level.band[0].toFixed(2)} to ${level.band[1].toFixed(2)} m chosen`,
      `heights × ${side.exaggeration.toFixed(1)}`,
    ],
  };
}

/** The cloud looked at along the shorter side of its plan; heights in metres above the floor. */
interface SideView {
  readonly low: number;
  readonly high: number;
  /** How much larger heights are drawn than lengths. */
  readonly exaggeration: number;
  y(height: number): number;
  /** Points between two heights, px. */
  points(low: number, high: number): Float64Array;
  /** Extent along the plan's longer side of the points between two heights, px; null where there are none. */
  extent(low: number, high: number): readonly [from: number, to: number] | null;
}

function sideView(cloud: PointCloud, kept: Uint32Array): SideView {
  const { positions } = cloud;
  const base = storeyRange(cloud, kept).floor;
  const { min, max } = boxOf(positions, kept);
  const axis = max[0] - min[0] >= max[1] - min[1] ? 0 : 1;
  const across = VIEW_WIDTH / Math.max(max[axis] - min[axis], Number.EPSILON);
  const up = VIEW_HEIGHT / Math.max(max[2] - min[2], Number.EPSILON);
  const x = (i: number): number => MARGIN + (positions[3 * i + axis] - min[axis]) * across;
  const y = (height: number): number => MARGIN + VIEW_HEIGHT - (height + base - min[2]) * up;
  const isWithin = (i: number, low: number, high: number): boolean => {
    const height = positions[3 * i + 2] - base;
    return height >= low && height <= high;
  };
  const isShown = sampler(shownShare(kept.length));
  const shown = kept.filter(() => isShown());
  return {
    low: min[2] - base,
    high: max[2] - base,
    exaggeration: up / across,
    y,
    points(low, high) {
      const within: number[] = [];
      for (const i of shown) if (isWithin(i, low, high)) within.push(x(i), y(positions[3 * i + 2] - base));
      return Float64Array.from(within);
    },
    extent(low, high) {
      let [from, to] = [Infinity, -Infinity];
      for (const i of kept) {
        if (!isWithin(i, low, high)) continue;
        from = Math.min(from, x(i));
        to = Math.max(to, x(i));
      }
      return from <= to ? [from, to] : null;
    },
  };
}

function boxOf(positions: Float32Array, kept: Uint32Array) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const i of kept) {
    for (let axis = 0; axis < 3; axis++) {
      min[axis] = Math.min(min[axis], positions[3 * i + axis]);
      max[axis] = Math.max(max[axis], positions[3 * i + axis]);
    }
  }
  return { min, max };
}

/** Least, mean and greatest height: the cuts lie halfway between ([Stojanovic19] §3), so they give the mean back. */
function referenceHeights(
  levels: readonly Level[],
): readonly { readonly name: string; readonly height: number }[] {
  const [first, , last] = levels;
  return [
    { name: 'min', height: first.low },
    { name: 'mean', height: 2 * first.high - first.low },
    { name: 'max', height: last.high },
  ];
}

function levelBox({ low, high, chosen }: Level, side: SideView): string[] {
  const extent = side.extent(low, high);
  if (extent === null) return [];
  return [
    element('rect', {
      x: pixels(extent[0]),
      y: pixels(side.y(high)),
      width: pixels(extent[1] - extent[0]),
      height: pixels(side.y(low) - side.y(high)),
      fill: 'none',
      stroke: chosen ? ACCENT : MUTED,
      'stroke-width': chosen ? 2 : 1,
    }),
  ];
}

/** A height band of one's own beside the three levels. */
function bandBox([low, high]: ChosenLevel['band'], side: SideView): string[] {
  return [
    element('rect', {
      x: MARGIN,
      y: pixels(side.y(high)),
      width: VIEW_WIDTH,
      height: pixels(side.y(low) - side.y(high)),
      fill: ACCENT,
      'fill-opacity': 0.12,
      stroke: ACCENT,
      'stroke-width': 2,
    }),
  ];
}

function referenceMarks(references: ReturnType<typeof referenceHeights>, side: SideView): string[] {
  return references.flatMap(({ name, height }) => {
    const y = side.y(height);
    const line = Float64Array.of(MARGIN, y, MARGIN + VIEW_WIDTH + 6, y);
    const look = { fill: 'none', stroke: INK, 'stroke-width': 0.9, 'stroke-dasharray': '5 3' };
    return [path([line], false, { id: `reference-${name}`, ...look })];
  });
}

/** What was measured of each level beside it, and the reference heights among them. */
function levelWords(level: ChosenLevel, side: SideView): string[] {
  const references = referenceHeights(level.levels).map(({ name, height }) => ({
    y: side.y(height) + SMALL / 3,
    mark: (y: number) => [
      text(`${name} ${height.toFixed(2)} m`, WORDS_AT, y, { size: SMALL, colour: MUTED }),
    ],
    height: LINE,
  }));
  const levels = level.levels.map((one, k) => ({
    y: (side.y(one.low) + side.y(one.high)) / 2 - LINE,
    mark: (y: number) => levelLines(one, k, y),
    height: 3.4 * LINE,
  }));
  return stacked([...references, ...levels]);
}

function levelLines({ low, high, points, densityPerM2, chosen }: Level, k: number, y: number): string[] {
  const colour = chosen ? ACCENT : INK;
  const density = densityPerM2.toLocaleString('en-GB', { maximumFractionDigits: 0 });
  return [
    text(`Level ${k}${chosen ? ', chosen' : ''}`, WORDS_AT, y, { size: BIG, colour, isBold: true }),
    text(`${low.toFixed(2)} to ${high.toFixed(2)} m`, WORDS_AT, y + LINE, { size: SMALL, colour: MUTED }),
    text(`${countOf(points, 'point')}, ${density} per m²`, WORDS_AT, y + 2 * LINE, { size: SMALL, colour }),
  ];
}

interface Words {
  /** Base line of the first line, where it would best be, px. */
  readonly y: number;
  readonly height: number;
  mark(y: number): string[];
}

/** Words from bottom to top, pushed apart where they would overlap, the whole kept on the page. */
function stacked(words: readonly Words[]): string[] {
  const sorted = [...words].sort((a, b) => a.y - b.y);
  const places = sorted.map(({ y }) => y);
  for (let i = 1; i < places.length; i++) {
    places[i] = Math.max(places[i], places[i - 1] + sorted[i - 1].height);
  }
  const end = MARGIN + VIEW_HEIGHT + SMALL / 3;
  for (let i = places.length - 1; i >= 0; i--) {
    const next = i + 1 < places.length ? places[i + 1] : end + LINE;
    places[i] = Math.min(places[i], next - sorted[i].height);
  }
  return sorted.flatMap(({ mark }, i) => mark(places[i]));
}
