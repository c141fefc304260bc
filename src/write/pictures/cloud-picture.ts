import { countOf } from '../../core/count-words.ts';
import { boundsOfAll } from '../../core/geometry/rings.ts';
import { storeyRange } from '../../core/level.ts';
import type { StageResults } from '../../core/stage-results.ts';
import type { PointCloud } from '../../core/types.ts';
import { dots } from './marks.ts';
import type { Drawing, LegendEntry } from './page.ts';
import { heightColour, INK, OKABE_ITO, PAPER } from './palette.ts';
import { sampler, shownShare, topView } from './top-view.ts';

const POINT = 1.8;
const STRAY = 1.6;
/** A scanner's mark and the paper around it, px. */
const SCANNER = 6;
const SCANNER_HALO = 9;
/** Steps of the height's colour: finer ones no eye tells apart in dots. */
const COLOURS = 24;
/** Points this near the ceiling plane, m, would hide everything beneath them. */
const CEILING_DEPTH = 0.15;
/** Heights named in the legend, as shares of the range. */
const NAMED = [0, 0.25, 0.5, 0.75, 1];
const [, VERMILION] = OKABE_ITO;

/** Fig. 1a: the upright cloud seen from above, coloured by height, without its ceiling; outliers beneath it, scanners on it. */
export function drawCloud({ frame, crop, outliers: kept }: Partial<StageResults>): Drawing | null {
  // A run that failed at the crop box has the whole cloud to show.
  const cloud = crop ?? frame;
  if (cloud === undefined || cloud.positions.length === 0) return null;
  const total = cloud.positions.length / 3;
  const range = heightRange(cloud, kept);
  const { bands, strays } = sortByHeight(cloud, kept, range);
  const view = topView(boundsOfAll(bands));
  const colourOf = (band: number): string => (cloud.isFlat ? INK : heightColour((band + 0.5) / COLOURS));
  const drawn = bands.flatMap((band, i) =>
    band.length === 0 ? [] : [dots(view.map(band), { colour: colourOf(i), size: POINT })],
  );
  const beneath = strays.length === 0 ? [] : [dots(view.map(strays), { colour: VERMILION, size: STRAY })];
  const scanners = within(Float64Array.from(cloud.stations.flatMap((station) => station.slice(0, 2))), bands);
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: [...beneath, ...drawn, ...scannerMarks(view.map(scanners))],
    counts: [
      countOf(total, 'point'),
      ...(kept === undefined ? [] : [countOf(total - kept.length, 'outlier')]),
      ...(cloud.isFlat ? ['a ready slice'] : []),
    ],
    legend: [
      ...(cloud.isFlat ? [] : heightLegend(range)),
      ...(strays.length === 0 ? [] : [{ colour: VERMILION, label: 'Outlier' }]),
      ...(scanners.length === 0 ? [] : [{ colour: INK, label: 'Scanner' }]),
    ],
  };
}

function scannerMarks(xy: Float64Array): string[] {
  if (xy.length === 0) return [];
  return [dots(xy, { colour: PAPER, size: SCANNER_HALO }), dots(xy, { colour: INK, size: SCANNER })];
}

/** Heights drawn, m, in the plan frame. */
interface HeightRange {
  readonly floor: number;
  readonly low: number;
  readonly high: number;
}

function heightRange(cloud: PointCloud, kept: Uint32Array | undefined): HeightRange {
  const { positions, ceiling } = cloud;
  const used = kept ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  let [low, high] = [Infinity, -Infinity];
  for (const i of used) {
    low = Math.min(low, positions[3 * i + 2]);
    high = Math.max(high, positions[3 * i + 2]);
  }
  const { floor } = storeyRange(cloud, used);
  return { floor, low, high: ceiling === null ? high : Math.min(high, ceiling - CEILING_DEPTH) };
}

/** A sample of the points by steps of height, lowest first, and of the outliers among them. */
function sortByHeight(
  { positions }: PointCloud,
  kept: Uint32Array | undefined,
  { low, high }: HeightRange,
): { readonly bands: readonly Float64Array[]; readonly strays: Float64Array } {
  const total = positions.length / 3;
  const isShown = sampler(shownShare(total));
  const bands: number[][] = Array.from({ length: COLOURS }, () => []);
  const strays: number[] = [];
  let next = 0;
  for (let i = 0; i < total; i++) {
    const isKept = kept === undefined || kept[next] === i;
    if (isKept) next++;
    if (!isShown()) continue;
    const z = positions[3 * i + 2];
    const step = high > low ? Math.floor(((z - low) / (high - low)) * COLOURS) : 0;
    if (!isKept) strays.push(positions[3 * i], positions[3 * i + 1]);
    else if (z <= high) bands[Math.min(COLOURS - 1, step)].push(positions[3 * i], positions[3 * i + 1]);
  }
  const shown = bands.map((band) => Float64Array.from(band));
  return { bands: shown, strays: within(Float64Array.from(strays), shown) };
}

/** Those of the points that lie in the box around the bands: far ones would make the picture of the cloud small. */
function within(xy: Float64Array, bands: readonly Float64Array[]): Float64Array {
  const { minX, minY, maxX, maxY } = boundsOfAll(bands);
  const inside: number[] = [];
  for (let i = 0; i < xy.length; i += 2) {
    const [x, y] = [xy[i], xy[i + 1]];
    if (x >= minX && x <= maxX && y >= minY && y <= maxY) inside.push(x, y);
  }
  return Float64Array.from(inside);
}

function heightLegend({ floor, low, high }: HeightRange): LegendEntry[] {
  return NAMED.map((share) => ({
    colour: heightColour(share),
    label: `${(low + share * (high - low) - floor).toFixed(1).replace('-0.0', '0.0').replace('-', '−')} m`,
  }));
}
