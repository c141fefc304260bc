import { createCanvas, type ImageData, loadImage } from '@napi-rs/canvas';
import { expect, it } from 'vitest';
import { indexedPng } from './indexed-png.ts';

async function decode(png: Uint8Array): Promise<ImageData> {
  const image = await loadImage(Buffer.from(png));
  const context = createCanvas(image.width, image.height).getContext('2d');
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, image.width, image.height);
}

it('keeps every pixel of a picture of few colours', async () => {
  const [width, height] = [7, 5];
  const rgba = new Uint8ClampedArray(4 * width * height);
  for (let i = 0; i < width * height; i++) rgba.set([(i * 40) % 256, i % 3, 255 - i, 255], 4 * i);
  const decoded = await decode(indexedPng(rgba, width, height));
  expect([decoded.width, decoded.height]).toEqual([width, height]);
  expect([...decoded.data]).toEqual([...rgba]);
});

it('gives the colours past the first 256 their nearest', async () => {
  const [width, height] = [32, 24];
  const rgba = new Uint8ClampedArray(4 * width * height);
  // Twice each red, then each once with a touch of green.
  for (let i = 0; i < width * height; i++) rgba.set([i & 255, i < 512 ? 0 : 2, 0, 255], 4 * i);
  const { data } = await decode(indexedPng(rgba, width, height));
  for (let i = 0; i < width * height; i++)
    expect([...data.subarray(4 * i, 4 * i + 3)]).toEqual([i & 255, 0, 0]);
});
