import { fileURLToPath } from 'node:url';
import { expect, expectReady, test } from './plan-page.ts';

const fixture = (name: string) => fileURLToPath(new URL(`../../fixtures/foreign/${name}`, import.meta.url));

test('a LAZ file becomes a plan, decompressed in the worker under the page’s own policy', async ({
  page,
}) => {
  await page.goto('./?src=');
  await page.getByTestId('file-input').setInputFiles(fixture('room.laz'));
  await expectReady(page);
  await expect(page.getByTestId('plan-svg')).toContainText('m²');
  await expect(page.locator('[data-stage=read]')).toContainText('6,000');
});

test('the coordinate system that a file states is among its facts', async ({ page }) => {
  await page.goto('./?src=');
  await page.getByTestId('file-input').setInputFiles(fixture('variable-7.laz'));
  await expectReady(page);
  await expect(page.locator('.facts')).toContainText('in m · z up · EPSG:25832 · 1 storey');
});

for (const name of ['flat-meshopt.glb', 'flat-draco.glb']) {
  test(`${name} becomes a plan, decompressed in the worker under the page’s own policy`, async ({ page }) => {
    await page.goto('./?src=');
    await page.getByTestId('file-input').setInputFiles(fixture(name));
    await expectReady(page);
    await expect(page.getByTestId('plan-svg')).toContainText('m²');
  });
}
