import { type Canvas, createCanvas, loadImage } from '@napi-rs/canvas';
import { getDocument } from 'pdfjs-dist/legacy/build/pdf.mjs';
import { expect, test } from 'vitest';
import { makeNodeCanvas } from '../../../../src/cli/node-canvas.ts';
import type { Sheet } from '../../../../src/core/sheet.ts';
import { writePng } from '../../../../src/write/drawing/png.ts';
import type { WriteTools } from '../../../../src/write/drawing/raster.ts';
import { writePdf } from '../../../../src/write/pdf/pdf.ts';
import type { Product } from '../../../../src/write/plan-writer.ts';
import { disc, wallAround } from '../../solid/plans.ts';
import { home, productOf } from '../products.ts';

/** An independent reader, Mozilla's. */
const open = (pdf: Uint8Array) =>
  getDocument({ data: pdf.slice(), useSystemFonts: true, verbosity: 0 }).promise;

const TOOLS: WriteTools = { makeCanvas: makeNodeCanvas };
const POINTS_PER_MM = 72 / 25.4;
/** Half of this. */
const DOTS_PER_MM = 4;

const textsOf = (sheet: Sheet): string[] =>
  sheet.layers.flatMap(({ items }) => items.flatMap((item) => (item.kind === 'text' ? [item.text] : [])));

async function textsIn(pdf: Uint8Array): Promise<string[]> {
  const page = await (await open(pdf)).getPage(1);
  const { items } = await page.getTextContent();
  return items.flatMap((item) => ('str' in item && item.str.trim() !== '' ? [item.str] : []));
}

/** A hall with a curved wall beside a home with structures and a gap. */
async function drawn(name = 'Home'): Promise<Product> {
  const { storeys } = home();
  const inner = disc(20, 4, 4, 48);
  const outline = wallAround(inner, 0.3);
  return productOf(
    {
      storeys: [
        { ...storeys![0], walls: [...storeys![0].walls!, { outline, thickness: 0.3, confidence: 1 }] },
      ],
    },
    name,
  );
}

test('the page is the paper, its text is the sheet’s, its layers have their names', async () => {
  const product = await drawn();
  const [sheet] = product.sheet;
  const file = await open(writePdf(product, 0));
  expect(file.numPages).toBe(1);
  const page = await file.getPage(1);
  const [, , width, height] = page.view;
  expect([width / POINTS_PER_MM, height / POINTS_PER_MM]).toEqual([
    expect.closeTo(sheet.paper.width, 3),
    expect.closeTo(sheet.paper.height, 3),
  ]);
  expect(await textsIn(writePdf(product, 0))).toEqual(textsOf(sheet));
  const config = await file.getOptionalContentConfig();
  const names = sheet.layers.map(({ name }) => name);
  expect([...config].map(([, group]) => (group as { name: string }).name).sort()).toEqual([...names].sort());
  const { info } = await file.getMetadata();
  expect(info).toHaveProperty('Title', 'Home');
});

test('PDF and PNG are the same picture', async () => {
  const product = await drawn();
  const { width, height } = product.sheet[0].paper;
  const [columns, rows] = [Math.round(width * DOTS_PER_MM), Math.round(height * DOTS_PER_MM)];
  const file = await open(writePdf(product, 0, TOOLS));
  const page = await file.getPage(1);
  const viewport = page.getViewport({ scale: DOTS_PER_MM / POINTS_PER_MM });
  const factory = file.canvasFactory as { create(width: number, height: number): { canvas: Canvas } };
  const rendered = factory.create(columns, rows).canvas;
  await page.render({ canvas: rendered as unknown as HTMLCanvasElement, viewport }).promise;
  const painted = Buffer.from(await writePng(product, 0, TOOLS));
  const [one, other] = await Promise.all(
    [rendered.toBuffer('image/png'), painted].map(async (png) => {
      const context = createCanvas(columns, rows).getContext('2d');
      context.drawImage(await loadImage(png), 0, 0, columns, rows);
      return context.getImageData(0, 0, columns, rows).data;
    }),
  );
  let [dark, apart] = [0, 0];
  for (let i = 0; i < one.length; i += 4) {
    dark += 255 - other[i];
    apart += Math.abs(one[i] - other[i]);
  }
  // Edges and letters are smoothed in other ways; walls and lines are where they are.
  expect(dark / 255).toBeGreaterThan(0.02 * columns * rows);
  expect(apart).toBeLessThan(0.35 * dark);
});

test('a PNG prints at true scale: 200 dots an inch are in its head', async () => {
  const png = await writePng(await drawn(), 0, TOOLS);
  const view = new DataView(png.buffer, png.byteOffset);
  expect(new TextDecoder().decode(png.subarray(37, 41))).toBe('pHYs');
  expect([view.getUint32(41), view.getUint32(45), png[49]]).toEqual([7874, 7874, 1]);
});

test('where nothing can paint, PNG says what to install', async () => {
  await expect(writePng(await drawn(), 0)).rejects.toMatchObject({ code: 'environment/canvas' });
});

test.each(['<script>"&]]>', 'Grundriß – Büro „Nord“ (¾) \\ €', 'Дом 12', '🏠 بيت 家', `a\u0007b\ud800`])(
  'the name %j comes through, with a canvas and without',
  async (name) => {
    for (const tools of [TOOLS, {}]) {
      const product = await drawn(name);
      const pdf = writePdf(product, 0, tools);
      const { info } = await (await open(pdf)).getMetadata();
      expect(info).toHaveProperty('Title', name.replace('\ud800', '\ufffd'));
      expect((await textsIn(pdf)).length).toBeGreaterThan(5);
    }
  },
);

test('a name of ten thousand letters is shortened on the sheet', async () => {
  const pdf = writePdf(await drawn('x'.repeat(10_000)), 0, TOOLS);
  expect((await textsIn(pdf)).some((text) => /^x+…$/.test(text))).toBe(true);
});

test('equal plans give equal bytes', async () => {
  expect(writePdf(await drawn(), 0, TOOLS)).toEqual(writePdf(await drawn(), 0, TOOLS));
});

test('walls are as long as they are at the scale', async () => {
  const product = await drawn();
  const [sheet] = product.sheet;
  const text = await contentOf(writePdf(product, 0));
  const [, , , , e, f] = sheet.planToSheet;
  const k = 1000 / sheet.scale;
  // The home's lower left outer corner, 20 cm off the origin's room, in mm of the sheet.
  const [x, y] = [e + 0 * k, f - 0 * k];
  expect(text).toContain(`${Number(x.toFixed(4))} ${Number(y.toFixed(4))} `);
  expect(text).toMatch(/^2\.8346 0 0 -2\.8346 0 [\d.]+ cm/);
});

async function contentOf(pdf: Uint8Array): Promise<string> {
  const { inflateSync } = await import('node:zlib');
  const raw = Buffer.from(pdf);
  const start = raw.indexOf('stream\n') + 7;
  return inflateSync(raw.subarray(start, raw.indexOf('\nendstream', start))).toString();
}
