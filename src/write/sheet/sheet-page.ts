import type { StageContext } from '../../core/context.ts';
import type { Bounds } from '../../core/geometry/rings.ts';
import type { Options } from '../../core/params.ts';
import type { Affine, Paper } from '../../core/sheet.ts';
import type { Warning } from '../../core/types.ts';

/** Room around the plan for dimension chains, mm a side. */
export interface Surround {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

export interface Page {
  readonly paper: Paper;
  readonly scale: number;
  readonly planToSheet: Affine;
}

/** Blank edge of the sheet, mm. */
export const MARGIN = 12;
/** A plan up to this much wider than deep stands on upright paper: beside the model and on a phone it shows larger. */
const UPRIGHT = 1.25;
/** Height of the strip with title, scale bar and legend, mm. */
export const STRIP = 34;

const PAPERS = [
  { name: 'A4', short: 210, long: 297 },
  { name: 'A3', short: 297, long: 420 },
  { name: 'A2', short: 420, long: 594 },
  { name: 'A1', short: 594, long: 841 },
  { name: 'A0', short: 841, long: 1189 },
] as const;

/**
 * Each scale with the largest paper (index) it is worth. A home goes on A4: it prints anywhere, and on a screen its
 * texts stay legible with the whole sheet in view.
 */
const SCALES = [
  [20, 0],
  [50, 0],
  [100, 1],
  [200, 2],
  [500, 4],
  [1000, 4],
  [2000, 4],
] as const;

/** What a person asked of the page. */
export type PageChoice = Pick<Options, 'paperSize' | 'sheetScale'>;

/** How one looks for a page: a scale, and the papers (indices) it may take. */
interface Try {
  readonly scale: number;
  readonly smallest: number;
  readonly largest: number;
}

/**
 * Chooses scale and paper: the largest scale whose plan fits a paper worth it, on the smallest such paper, and puts
 * the plan in the middle of the space above the strip. Larger than 1:2000 on A0, the scale goes on in steps of 1-2-5.
 *
 * @param warn told where the scale asked for fits no paper that may be taken; the next smaller one that does is taken
 */
export function fitPage(
  extent: Bounds,
  surround: Surround,
  choice: PageChoice,
  warn: StageContext['warn'] = () => {},
): Page {
  for (const tried of pagesToTry(choice)) {
    const paper = smallestPaper(extent, surround, tried);
    if (paper === null) continue;
    const asked = choice.sheetScale;
    if (asked !== 'auto' && asked !== `1:${tried.scale}`) warn(doesNotFit(asked, paper.name, tried.scale));
    return pageOf(paper, tried.scale, extent, surround);
  }
  throw new Error('Scales without end fit any plan.');
}

function* pagesToTry({ paperSize, sheetScale }: PageChoice): Generator<Try> {
  const last = PAPERS.length - 1;
  const size = PAPERS.findIndex(({ name }) => name === paperSize);
  const asked = sheetScale === 'auto' ? 0 : Number(sheetScale.slice('1:'.length));
  const [smallest, most] = size < 0 ? [0, last] : [size, size];
  for (const [scale, worth] of SCALES) {
    if (scale < asked) continue;
    yield { scale, smallest, largest: size < 0 && scale !== asked ? worth : most };
  }
  for (let power = 1000; ; power *= 10) {
    for (const step of [5, 10, 20]) yield { scale: step * power, smallest, largest: most };
  }
}

function doesNotFit(asked: string, paper: string, scale: number): Warning {
  return {
    code: 'sheet/scale-too-large',
    message: `At ${asked} the plan does not fit the paper; it is drawn 1:${scale} on ${paper}.`,
    hint: 'Choose a larger paper or another scale.',
  };
}

function smallestPaper(
  { minX, minY, maxX, maxY }: Bounds,
  { left, right, top, bottom }: Surround,
  { scale, smallest, largest }: Try,
): Paper | null {
  const [planWidth, planHeight] = [((maxX - minX) * 1000) / scale, ((maxY - minY) * 1000) / scale];
  const needed = [
    planWidth + left + right + 2 * MARGIN,
    planHeight + top + bottom + STRIP + 2 * MARGIN,
  ] as const;
  for (const { name, short, long } of PAPERS.slice(smallest, largest + 1)) {
    const turned: Paper[] = [
      { name, width: long, height: short },
      { name, width: short, height: long },
    ];
    if (planWidth <= UPRIGHT * planHeight) turned.reverse();
    const paper = turned.find(({ width, height }) => needed[0] <= width && needed[1] <= height);
    if (paper !== undefined) return paper;
  }
  return null;
}

function pageOf(paper: Paper, scale: number, extent: Bounds, surround: Surround): Page {
  const { minX, minY, maxX, maxY } = extent;
  const { left, right, top, bottom } = surround;
  const k = 1000 / scale;
  const freeWidth = paper.width - 2 * MARGIN - left - right - k * (maxX - minX);
  const freeHeight = paper.height - 2 * MARGIN - STRIP - top - bottom - k * (maxY - minY);
  const e = MARGIN + left + freeWidth / 2 - k * minX;
  const f = MARGIN + top + freeHeight / 2 + k * maxY;
  return { paper, scale, planToSheet: [k, 0, 0, -k, e, f] };
}
