import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { parseXml } from '../unit/write/drawing/strict-xml.ts';
import { drawPanels, FIGURES } from './figures.ts';
import { appPalette, pageFolder, readText } from './folder.ts';
import { OUTLINE_METHODS } from './outlines.ts';
import { renderPage } from './page.ts';
import { PAPER_SETS } from './paper-sets.ts';
import { PASS_COMBINATIONS } from './passes.ts';
import { sizeOf } from './raster.ts';
import { measureSet, type Results, toJson } from './results.ts';
import { STRUCTURE_METHODS } from './structures.ts';
import type { Times } from './timing.ts';

const STALE = 'the page is out of date: npm run reproduce';
/** Of the whole folder, bytes. */
const LARGEST_FOLDER = 3_000_000;
const PNG_SIGNATURE = '89504e470d0a1a0a';

const panels = FIGURES.flatMap((figure) => figure.panels);
const results: Results = JSON.parse(readText('results.json'));
const times: Times = JSON.parse(readText('times.json'));
const page = readText('index.html');
/** One set stands for the six: it is in Fig. 3, 6 and 8. */
const sample = PAPER_SETS.find(({ name }) => name === 'room-1a')!;

describe('the committed page of the reproduction', () => {
  it('is made from the committed numbers and pictures', () => {
    const sizes = new Map(panels.map(({ file }) => [file, sizeOf(readText(`${file}.svg`))]));
    expect(page, STALE).toBe(renderPage(results, times, sizes));
    expect(readText('palette.css'), STALE).toBe(appPalette());
  });

  it('has the numbers that a run on one set gives today', async () => {
    expect(toJson(await measureSet(sample)), STALE).toBe(toJson(results.sets[sample.name]));
  });

  it('has the pictures that a run on one set gives today', async () => {
    const drawn = await drawPanels(panels.filter(({ set }) => set === sample));
    expect(drawn.size).toBeGreaterThan(10);
    for (const [file, svg] of drawn)
      expect(readText(`${file}.svg`) === svg, `${file}.svg: ${STALE}`).toBe(true);
  });

  it('has every figure from 3 to 8 with all its parts, as SVG and as PNG', () => {
    const parts = Object.fromEntries(FIGURES.map(({ number, panels: { length } }) => [number, length]));
    expect(parts).toEqual({ 3: 4, 4: 3, 5: 3, 6: 24, 7: 2, 8: 4 });
    for (const { file } of panels) {
      expect(page).toContain(`<img src="${file}.svg"`);
      expect(page).toContain(`href="${file}.png"`);
      expect(() => parseXml(readText(`${file}.svg`))).not.toThrow();
      const png = readFileSync(join(pageFolder, `${file}.png`));
      expect(png.subarray(0, 8).toString('hex')).toBe(PNG_SIGNATURE);
      expect(png.readUInt32BE(16)).toBeGreaterThan(sizeOf(readText(`${file}.svg`))[0]);
    }
  });

  it('has a row for every method, every combination of passes and every mesh the paper measures', () => {
    const labels = [...OUTLINE_METHODS, ...STRUCTURE_METHODS].map(({ label }) => label);
    const combinations = PASS_COMBINATIONS.map(({ label }) => label);
    expect(combinations).toHaveLength(9);
    for (const label of [...labels, ...combinations]) {
      expect(page).toContain(`<th scope="row">${label.replaceAll("'", '&apos;')}</th>`);
    }
    for (const { label, points, mesh } of PAPER_SETS) {
      expect(page).toContain(`<th scope="row">${label}</th><td>${points.toLocaleString('en-GB')}</td>`);
      if (mesh) expect(page).toContain(`<td>${mesh.faces.toLocaleString('en-GB')}</td>`);
    }
    for (const milliseconds of ['10.25', '169']) expect(page).toContain(`<td>${milliseconds}</td>`);
  });

  it('says what it is, and stays small', () => {
    expect(page).toContain('rebuilt, not the authors’ own');
    expect(page).not.toContain('<script');
    const bytes = readdirSync(pageFolder).map((name) => statSync(join(pageFolder, name)).size);
    expect(bytes.reduce((sum, size) => sum + size, 0)).toBeLessThan(LARGEST_FOLDER);
  });
});
