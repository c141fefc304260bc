/** The cloud from above and its levels from the side ([Stojanovic19] Fig. 1a, 2). */
import type { StageResults } from '../../core/stage-results.ts';
import type { PointCloud } from '../../core/types.ts';
import { dots } from './marks.ts';
import { countOf, type Drawing, type LegendEntry } from './page.ts';
import { heightColour, INK, OKABE_ITO } from './palette.ts';
import { boundsOfAll, thinned, thinningStep, topView } from './top-view.ts';

const POINT = 1.6;
/** Steps of the height's colour: finer ones no eye tells apart in dots. */
const COLOURS = 24;
/** Points this near the ceiling plane, m, would hide everything beneath them. */
const CEILING_DEPTH = 0.15;
const [, VERMILION] = OKABE_ITO;

/** Fig. 1a: the upright cloud seen from above, coloured by height, without its ceiling; outliers marked. */
export function drawCloud({ frame: cloud, outliers: kept }: Partial<StageResults>): Drawing | null {
  if (cloud === undefined || cloud.positions.length === 0) return null;
  const total = cloud.positions.length / 3;
  const step = thinningStep(total);
  const { low, high } = heightsOf(cloud, kept, step);
  const isOutlier = outlierMarks(total, kept);
  const bands: number[][] = Array.from({ length: COLOURS }, () => []);
  const strays: number[] = [];
  for (let i = 0; i < total; i++) {
    const [x, y, z] = cloud.positions.subarray(3 * i, 3 * i + 3);
    if (isOutlier?.[i]) strays.push(x, y);
    else if (i % step === 0 && z <= high) {
      const share = high > low ? (z - low) / (high - low) : 0;
      bands[Math.min(COLOURS - 1, Math.max(0, Math.floor(share * COLOURS)))].push(x, y);
    }
  }
  const shown = bands.map((band) => Float64Array.from(band));
  const away = thinned(Float64Array.from(strays));
  const view = topView(boundsOfAll([...shown, away]));
  const colourOf = (band: number): string => (cloud.isFlat ? INK : heightColour((band + 0.5) / COLOURS));
  const marked = away.length === 0 ? [] : [dots(view.map(away), { colour: VERMILION, size: 2 * POINT })];
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: [
      ...shown.flatMap((band, i) =>
        band.length === 0 ? [] : [dots(view.map(band), { colour: colourOf(i), size: POINT })],
      ),
      ...marked,
    ],
    counts: [
      countOf(total, 'point'),
      ...(kept === undefined ? [] : [countOf(total - kept.length, 'outlier')]),
      ...(cloud.isFlat ? ['a ready slice'] : []),
      ...(cloud.ceiling === null ? [] : ['ceiling left out']),
    ],
    legend: cloud.isFlat ? [] : heightLegend(low, high, away.length > 0),
  };
}

/** Lowest and highest point drawn, m, in the plan frame. */
function heightsOf(
  { positions, ceiling }: PointCloud,
  kept: Uint32Array | undefined,
  step: number,
): { readonly low: number; readonly high: number } {
  let [low, high] = [Infinity, -Infinity];
  const count = kept?.length ?? positions.length / 3;
  for (let k = 0; k < count; k += step) {
    const z = positions[3 * (kept?.[k] ?? k) + 2];
    low = Math.min(low, z);
    high = Math.max(high, z);
  }
  return { low, high: ceiling === null ? high : Math.min(high, ceiling - CEILING_DEPTH) };
}

/** 1 for every point that is an outlier; null before outliers were looked for. */
function outlierMarks(total: number, kept: Uint32Array | undefined): Uint8Array | null {
  if (kept === undefined) return null;
  const marks = new Uint8Array(total).fill(1);
  for (const i of kept) marks[i] = 0;
  return marks;
}

function heightLegend(low: number, high: number, hasOutliers: boolean): LegendEntry[] {
  const shares = [0, 0.25, 0.5, 0.75, 1];
  const heights = shares.map((share) => ({
    colour: heightColour(share),
    label: `${(share * (high - low)).toFixed(1)} m`,
  }));
  return hasOutliers ? [...heights, { colour: VERMILION, label: 'Outlier' }] : heights;
}
