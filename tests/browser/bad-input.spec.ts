import { BAD_INPUTS } from '../bad-inputs.ts';
import { expect, openPlan, test } from './plan-page.ts';

test('every bad file gives its error and the last plan stays', async ({ page }) => {
  await openPlan(page);
  const drawing = page.getByTestId('plan-svg');
  const before = await drawing.locator('svg').innerHTML();
  for (const { name, bytes, code, says } of BAD_INPUTS) {
    await page
      .getByTestId('file-input')
      .setInputFiles({ name, mimeType: 'application/octet-stream', buffer: Buffer.from(bytes) });
    const error = page.getByTestId('error');
    await expect(error, name).toBeVisible();
    await expect(error, name).toContainText(code);
    expect(await error.innerText(), name).toMatch(says);
    expect(await drawing.locator('svg').innerHTML(), name).toBe(before);
    await error.getByRole('button', { name: 'Close' }).click();
    await expect(error).toBeHidden();
  }
});
