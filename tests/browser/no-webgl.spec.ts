import { expect, test } from '@playwright/test';
import { launchOptions } from './chromium.ts';

const options = launchOptions();
const args = [...(options.args ?? []), '--disable-gpu', '--disable-software-rasterizer'];
test.use({ launchOptions: { ...options, args } });

test('without WebGL the plan is there, and the model says why it is not', async ({ page }) => {
  await page.goto('./');
  await expect(page.getByTestId('status')).toHaveText('Plan ready', { timeout: 45_000 });
  await expect(page.getByTestId('plan-svg')).toBeVisible();
  await expect(page.getByText(/environment\/webgl/)).toBeVisible();
});
