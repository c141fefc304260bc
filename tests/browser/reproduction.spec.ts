import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { FIGURES } from '../reproduction/figures.ts';
import { expect, test } from './plan-page.ts';

const FOLDER = new URL('../../.cache/screenshots/', import.meta.url).pathname;
const PANELS = FIGURES.flatMap(({ panels }) => panels).length;

/** The fixture also fails on console errors, policy violations and requests to other servers. */
for (const colorScheme of ['light', 'dark'] as const) {
  for (const [size, width] of [
    ['wide', 1440],
    ['phone', 390],
  ] as const) {
    test(`the reproduction: ${size}, ${colorScheme}`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 844 });
      await page.goto('./reproduction/index.html');
      const images = page.locator('figure img');
      await expect(images).toHaveCount(PANELS);
      const widths = await images.evaluateAll((all) =>
        all.map((image) => (image as HTMLImageElement).naturalWidth),
      );
      expect(Math.min(...widths)).toBeGreaterThan(0);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(overflow, 'the page does not scroll sideways').toBeLessThanOrEqual(0);
      const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
      await page.evaluate(await readFile(axe, 'utf8'));
      const violations = await page.evaluate(async () => {
        const { axe: runner } = globalThis as unknown as { axe: typeof import('axe-core') };
        return (await runner.run()).violations.map(
          ({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 160)}`,
        );
      });
      expect(violations).toEqual([]);
      await page.screenshot({ path: `${FOLDER}reproduction-${size}-${colorScheme}.png`, fullPage: true });
    });
  }
}

test('its pictures are there as PNG, and it leads back to the app', async ({ page, request }) => {
  await page.goto('./reproduction/index.html');
  const links = await page
    .locator('a[href$=".png"]')
    .evaluateAll((all) => all.map((link) => (link as HTMLAnchorElement).href));
  expect(links).toHaveLength(PANELS);
  for (const link of links) expect((await request.get(link)).headers()['content-type']).toBe('image/png');
  await page.getByRole('link', { name: 'Grundriss' }).click();
  await expect(page.locator('floor-plan')).toBeAttached();
});
