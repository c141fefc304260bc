import { writeFileSync } from 'node:fs';

/** Writes a drawing as PATH.png, or as PATH.svg where no canvas is installed. */
export async function writePicture(path: string, svg: string): Promise<void> {
  const canvas = await import('@napi-rs/canvas').catch(() => null);
  if (canvas === null) {
    writeFileSync(`${path}.svg`, svg);
    return;
  }
  const image = await canvas.loadImage(Buffer.from(svg));
  const sheet = canvas.createCanvas(image.width, image.height);
  sheet.getContext('2d').drawImage(image, 0, 0);
  writeFileSync(`${path}.png`, sheet.toBuffer('image/png'));
}
