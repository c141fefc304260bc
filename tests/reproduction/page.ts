import { experimentSections } from './experiment-sections.ts';
import { FIGURES, type Figure, type FigurePanel } from './figures.ts';
import { html, type Markup } from './html.ts';
import type { Results } from './results.ts';
import {
  alphaTable,
  meshTable,
  outlineTable,
  passTable,
  setTable,
  structureTable,
  timeTable,
} from './tables.ts';
import type { Times } from './timing.ts';

/** Only its own pictures and style sheet; no script at all. */
const POLICY = "default-src 'none'; img-src 'self'; style-src 'self'; base-uri 'none'; form-action 'none'";

/** Width and height of a drawn panel, px. */
export type PictureSizes = ReadonlyMap<string, readonly [width: number, height: number]>;

/** The whole page, from measured numbers and drawn pictures alone. */
export function renderPage(results: Results, times: Times, sizes: PictureSizes): string {
  const figure = (number: number) => figureSection(FIGURES.find((row) => row.number === number)!, sizes);
  const { text } = html`<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>The paper reproduced – Grundriss</title>
<link rel="icon" href="../icon.svg" type="image/svg+xml">
<link rel="stylesheet" href="palette.css">
<link rel="stylesheet" href="reproduction.css">
</head>
<body>
${header()}
<main>
${notice(times)}
${section('sets', 'The six sets', setTable())}
${figure(3)}
${figure(4)}
${figure(5)}
${section('outlines', 'Primary boundaries against the truth', outlineTable(results), passTable(results, times))}
${figure(6)}
${section('structures', 'Secondary boundaries against the truth', structureTable(results), alphaTable(results))}
${figure(7)}
${figure(8)}
${section('meshes', 'Size of the models', meshTable(results))}
${section('times', 'Time', timeTable(times))}
${experimentSections(results)}
</main>
${footer()}
</body>
</html>
`;
  return text;
}

function header(): Markup {
  const entries = [
    ['sets', 'Sets'],
    ...FIGURES.map(({ number }) => [`fig-${number}`, `Fig. ${number}`]),
    ['outlines', 'Outlines'],
    ['structures', 'Structures'],
    ['meshes', 'Models'],
    ['times', 'Time'],
    ['narrow-spaces', 'Narrow spaces'],
    ['door-gaps', 'Door gaps'],
    ['structure-cases', '200 rooms'],
  ];
  return html`<header>
<p class="home"><a href="../index.html">Grundriss</a></p>
<h1>The paper, reproduced</h1>
<p class="lede">The experiments of Stojanovic, Trapp, Richter and Döllner, <cite>Generation of Approximate 2D and 3D Floor Plans from 3D Point Clouds</cite> (GRAPP 2019), run again: its figures 3 to 8, its numbers beside ours, its rival, and how far each result is from the truth.</p>
<nav aria-label="Contents">${entries.map(([id, label]) => html`<a href="#${id}">${label}</a> `)}</nav>
</header>`;
}

function notice({ machine, runs }: Times): Markup {
  return html`<section class="notice" aria-label="What can be compared">
<h2>What can be compared, and what cannot</h2>
<ul>
<li><strong>The point sets are rebuilt, not the authors’ own.</strong> Theirs were never published. These six have the same numbers of points and the same kinds of rooms; they are made with a seed, so their truth is known. Compare what each method does, not line with line.</li>
<li><strong>The paper measures no accuracy.</strong> IoU (shared area over united area, 1 is perfect) is ours, against the known truth of these sets.</li>
<li><strong>Times are from different hardware.</strong> Paper: Intel Core i5-6500, 3.2 GHz, Firefox 62 (2018). Here: ${machine}, mean of ${runs} runs of warmed code. They show an order of magnitude and nothing finer.</li>
<li><strong>Of the models compare the faces.</strong> The paper’s vertices are three times its faces, as if no two triangles shared one; ours are shared.</li>
</ul>
</section>`;
}

function section(id: string, title: string, ...content: readonly Markup[]): Markup {
  return html`<section id="${id}">
<h2>${title}</h2>
${content}
</section>`;
}

function figureSection({ number, title, doc, panels }: Figure, sizes: PictureSizes): Markup {
  return html`<section id="fig-${number}" class="figure">
<h2>Fig. ${number} <span>${title}</span></h2>
<p>${doc}</p>
<div class="panels ${panels.length % 3 === 0 ? 'by-three' : 'by-two'}">
${panels.map((panel) => panelMarkup(panel, sizes))}</div>
</section>`;
}

function panelMarkup({ file, label }: FigurePanel, sizes: PictureSizes): Markup {
  const [width, height] = sizes.get(file)!;
  return html`<figure>
<a href="${file}.svg"><img src="${file}.svg" width="${width}" height="${height}" alt="${label}"></a>
<figcaption>${label} <a href="${file}.svg">SVG</a> <a href="${file}.png">PNG</a></figcaption>
</figure>
`;
}

function footer(): Markup {
  return html`<footer>
<p><code>npm run reproduce</code> makes this page: every number and picture on it comes from that run, and only the times differ from one run to the next. The numbers as data: <a href="results.json">results.json</a>, <a href="times.json">times.json</a>.</p>
</footer>`;
}
