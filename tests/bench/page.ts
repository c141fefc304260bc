import { type CloudFormat, cloudFile } from './clouds.ts';
import { loadInPage, rendererMemory, withPage } from './served-page.ts';
import type { Figure } from './table.ts';

const CLOUDS: readonly (readonly [string, number, CloudFormat])[] = [
  ['1 M points PLY', 1_000_000, 'ply'],
  ['2 M points PLY, 31 bytes each', 2_000_000, 'ply-full'],
  ['2 M points LAS', 2_000_000, 'las'],
  ['10 M points PLY', 10_000_000, 'ply'],
];

/** Scans given to the built page: time until they are read, beside `file.stream()`, and until the plan is on screen. */
export async function benchPage(): Promise<readonly Figure[]> {
  return withPage(async (page, browser) => {
    const figures: Figure[] = [];
    for (const [name, points, format] of CLOUDS) {
      const { path } = await cloudFile(points, format);
      const { raw, read, whole, longest } = await loadInPage(page, path);
      const { peak } = await rendererMemory(browser);
      const figure = (of: string, value: number): Figure => ({ name, of, value, unit: 'in Chromium' });
      figures.push(
        figure('raw s', raw / 1000),
        figure('read s', read / 1000),
        figure('read : raw', read / raw),
      );
      figures.push(figure('plan s', whole / 1000), figure('longest ms', longest), figure('peak MB', peak));
    }
    return figures;
  });
}
