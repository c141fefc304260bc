import type { Page } from '@playwright/test';
import { expect, expectReady, openPlan, test } from './plan-page.ts';

const FOLDER = new URL('../../.cache/screenshots/', import.meta.url).pathname;

/** From what was waited for to the end of every transition, ms. */
const SETTLE = 300;

/** Waits until the model has its canvas, which is made after the plan. */
async function expectModel(page: Page): Promise<void> {
  await expect(page.locator('.surface canvas')).toBeVisible();
}

/** Nobody looks at CI's pictures; that both schemes can be read is asserted elsewhere. */
const SCHEMES = process.env.CI ? (['light'] as const) : (['light', 'dark'] as const);

/** Pictures of every state, to look at; that the page gets there without an error is all that is asserted. */
for (const colorScheme of SCHEMES) {
  for (const [size, viewport] of [
    ['wide', { width: 1440, height: 900 }],
    ['phone', { width: 390, height: 844 }],
  ] as const) {
    test(`pictures: ${size}, ${colorScheme}`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize(viewport);
      const take = async (state: string) => {
        await page.waitForTimeout(SETTLE);
        await page.screenshot({ path: `${FOLDER}${state}-${size}-${colorScheme}.png` });
      };
      await page.goto('./?src=');
      await take('empty');
      await openPlan(page);
      if (size === 'wide') await expectModel(page);
      await take('plan');
      await page.getByRole('button', { name: 'Step by step' }).click();
      await expect(page.getByTestId('step-picture').locator('.paper > svg')).toBeVisible();
      await take('step-by-step');
      await page.getByTestId('compare').click();
      await expect(page.getByTestId('compare-iou')).toContainText('%');
      await take('comparison');
      await page.getByRole('button', { name: 'Drawing', exact: true }).click();
      if (size === 'phone') {
        await page.getByRole('button', { name: 'Model', exact: true }).first().click();
        await expectModel(page);
        await take('model');
        await page.getByRole('button', { name: 'Steps' }).click();
        await take('steps');
        await page.getByRole('button', { name: 'Plan', exact: true }).click();
        await page.getByRole('button', { name: 'Steps' }).click();
      }
      await page.getByTestId('file-input').setInputFiles({
        name: 'letter.ply',
        mimeType: 'text/plain',
        buffer: Buffer.from('Dear reader'),
      });
      await expect(page.getByTestId('error')).toBeVisible();
      await take('error');
      for (const sample of ['office', 'hallway']) {
        await page.goto(`./?src=samples/${sample}.${sample === 'office' ? 'ply' : 'csv'}`);
        await expectReady(page);
        if (size === 'wide') await expectModel(page);
        await take(sample);
      }
    });
  }
}
