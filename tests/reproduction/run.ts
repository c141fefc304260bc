/**
 * `npm run reproduce`: the experiments of [Stojanovic19] on the six rebuilt sets, as a page in public/reproduction.
 * Equal sources give equal files but for the times, which are in times.json and in the page's tables.
 */
import { runExperiments } from './experiments.ts';
import { drawPanels, FIGURES } from './figures.ts';
import { appPalette, pageFolder, removeOthers, write } from './folder.ts';
import { renderPage } from './page.ts';
import { PAPER_SETS } from './paper-sets.ts';
import { rasterise, sizeOf } from './raster.ts';
import { measureSet, type Results, type SetResults, toJson } from './results.ts';
import { measureTimes } from './timing.ts';

const sets: Record<string, SetResults> = {};
for (const set of PAPER_SETS) {
  console.log(`measuring ${set.label}`);
  sets[set.name] = await measureSet(set);
}
console.log('experiments beyond the sets');
const results: Results = { sets, ...(await runExperiments()) };
console.log('times');
const times = await measureTimes(PAPER_SETS);
console.log('figures');
const panels = await drawPanels(FIGURES.flatMap((figure) => figure.panels));
removeOthers(new Set([...panels.keys()].flatMap((file) => [`${file}.svg`, `${file}.png`])));
for (const [file, svg] of panels) {
  write(`${file}.svg`, svg);
  write(`${file}.png`, await rasterise(svg));
}
const sizes = new Map([...panels].map(([file, svg]) => [file, sizeOf(svg)]));
// The page is made from what the files hold, so that a test can make it again from them.
const [resultsJson, timesJson] = [toJson(results), toJson(times)];
write('palette.css', appPalette());
write('results.json', resultsJson);
write('times.json', timesJson);
write('index.html', renderPage(JSON.parse(resultsJson), JSON.parse(timesJson), sizes));
console.log(`${pageFolder}/index.html`);
