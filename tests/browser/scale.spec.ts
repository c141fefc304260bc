import type { Page } from '@playwright/test';
import type { FloorPlanElement } from '../../src/element/floor-plan.ts';
import { axe, dropFile, expect, expectReady, onSheet, roomCsv, stagesRun, test } from './plan-page.ts';

async function openRoom(page: Page): Promise<void> {
  await page.goto('./?src=');
  await dropFile(page, 'room.csv', roomCsv(0.04));
  await expectReady(page);
}

/** Metres a unit, as the plan has them. */
function scaleOf(page: Page): Promise<number> {
  return page.evaluate(
    () => (document.querySelector('floor-plan') as FloorPlanElement).plan!.frame.metresPerUnit,
  );
}

test('two points and their true length set the scale; undo and redo follow, and there is a way back', async ({
  page,
}) => {
  await openRoom(page);
  await page.keyboard.press('m');
  const words = page.getByTestId('measure-words');
  await expect(words).toHaveText('Press two points whose true distance you know, or choose an edge.');
  // Near the corners, not on them.
  const [x, y] = await onSheet(page, 0, 0);
  await page.mouse.click(x + 3, y - 3);
  await expect(words).toHaveText('Now the other point.');
  const [toX, toY] = await onSheet(page, 6, 0);
  await page.mouse.move(toX - 4, toY - 2);
  await expect(page.locator('.mark-length')).toHaveCount(1);
  await page.mouse.click(toX - 4, toY - 2);
  await expect(words).toHaveText(/^(5\.9[89]|6(\.0[0-2])?) m in the plan\.$/);
  const length = page.getByRole('textbox', { name: 'True length' });
  await expect(length).toBeFocused();
  await length.fill('12 m');
  await page.keyboard.press('Enter');
  await expect.poll(() => scaleOf(page)).toBeCloseTo(2, 1);
  await expect(words).toHaveText(/^12 m in the plan\. 1 unit = (1\.99|2|2\.0)\d* m\.$/);
  await expect(page.locator('.facts')).toContainText('1 unit = ');
  await expect(page.getByTestId('plan-svg').locator('svg')).toContainText('12');
  const scale = await scaleOf(page);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => scaleOf(page)).toBe(1);
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect.poll(() => scaleOf(page)).toBe(scale);
  await page.getByTestId('automatic-scale').click();
  await expect.poll(() => scaleOf(page)).toBe(1);
  await expect(page.getByTestId('automatic-scale')).toBeHidden();
  await page.keyboard.press('Escape');
  await expect(words).toBeHidden();
});

test('the scale is set by the keyboard alone, from the length of an edge', async ({ page }) => {
  await openRoom(page);
  await page.locator('[data-stage=read] > summary').press('Enter');
  await page.getByTestId('measure-in-drawing').press('Enter');
  const edge = page.getByRole('combobox', { name: 'Length of' });
  await edge.selectOption({ index: 1 });
  await expect(page.locator('.mark-length')).toHaveCount(1);
  const length = page.getByRole('textbox', { name: 'True length' });
  await length.press('x');
  await expect(length).toHaveAttribute('aria-invalid', 'true');
  await length.fill('3');
  await length.press('Enter');
  await expect.poll(() => scaleOf(page)).toBeCloseTo(0.5, 2);
  await expect(page.getByTestId('measure-words')).toHaveText(/^3 m in the plan\. 1 unit = 0\.[45]\d* m\.$/);
  await expect(edge.locator('option').nth(1)).toHaveText(/^Edge 1, (3|3\.0\d|2\.9\d) m$/);
});

test('a unit named by hand ends a scale set by hand', async ({ page }) => {
  await openRoom(page);
  await page.locator('[data-stage=read] > summary').click();
  // No scale is made up: the person types it.
  await page.getByRole('checkbox', { name: 'Scale: length of one unit: auto' }).uncheck();
  await expect(page.getByRole('textbox', { name: 'Scale: length of one unit' })).toBeFocused();
  expect(await scaleOf(page)).toBe(1);
  await page.keyboard.type('0.5');
  await page.keyboard.press('Enter');
  await expect(page.getByTestId('reason-unit')).toHaveText('1 unit = 0.5 m: the scale was given.');
  await page.getByRole('combobox', { name: 'Unit' }).selectOption('ft');
  await expect(page.getByTestId('reason-unit')).toHaveText('The unit is ft: it was given.');
  await expect.poll(() => scaleOf(page)).toBe(0.3048);
  await expect(page.getByRole('textbox', { name: 'Scale: length of one unit' })).toHaveValue('');
});

test('unit and up are shown with their reason, and a guess leads to its control', async ({ page }) => {
  await page.goto('./?src=');
  const inches = roomCsv(0.05).replace(/[\d.]+/g, (n) => String(Math.round(Number(n) * 1000)));
  await dropFile(page, 'room.csv', inches);
  await expectReady(page);
  const guess = page.locator('[data-code="frame/unit-guessed"]');
  await expect(guess).toContainText('The unit is mm');
  await guess.getByRole('button', { name: 'Set the unit' }).press('Enter');
  await expect(page.locator('#param-unit')).toBeFocused();
  await expect(page.getByTestId('reason-unit')).toContainText('The unit is mm: floor and ceiling are');
  await page.locator('[data-stage=frame] > summary').click();
  await expect(page.getByTestId('reason-up')).toContainText('z is up');
});

test('an axis of the scan is taken for up in the model, by hand and by keyboard', async ({ page }) => {
  await openRoom(page);
  const axes = page.getByRole('group', { name: 'Axes of the scan' });
  await expect(axes.getByRole('button', { name: 'z is up' })).toHaveAttribute('aria-pressed', 'true');
  await axes.getByRole('button', { name: 'Take y for up' }).click();
  await expect(axes.getByRole('button', { name: 'y is up' })).toHaveAttribute('aria-pressed', 'true');
  expect(await stagesRun(page)).not.toContain('read');
  await axes.getByRole('button', { name: 'Take z for up' }).press('Enter');
  await expect(axes.getByRole('button', { name: 'z is up' })).toHaveAttribute('aria-pressed', 'true');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(axes.getByRole('button', { name: 'y is up' })).toHaveAttribute('aria-pressed', 'true');
});

test('the axes follow the camera: from above x points right and y up the screen', async ({ page }) => {
  await openRoom(page);
  await page.getByRole('button', { name: 'From above' }).click();
  const end = (axis: string) =>
    page
      .locator(`.axis-end[data-axis="${axis}"]`)
      .evaluate((node) => new DOMMatrix(getComputedStyle(node).transform));
  await expect.poll(async () => Math.round((await end('x')).e)).toBe(38);
  const [x, y, z] = [await end('x'), await end('y'), await end('-z')];
  expect(x.f).toBeCloseTo(0, 0);
  expect([y.e, y.f].map(Math.round).map(Math.abs)).toEqual([0, 38]);
  expect(y.f).toBeLessThan(0);
  expect(Math.hypot(z.e, z.f)).toBeLessThan(1);
  const caption = page.locator('.axis-caption');
  await expect(caption).toHaveText('z is up');
  await page.locator('.axis-end[data-axis="-x"]').hover();
  await expect(caption).toHaveText('Take −x for up');
  await page.mouse.move(0, 0);
  await expect(caption).toHaveText('z is up');
});

test('a page without controls shows no axes to press', async ({ page }) => {
  await openRoom(page);
  const axes = page.getByRole('group', { name: 'Axes of the scan' });
  await expect(axes).toBeVisible();
  await page.evaluate(() => document.querySelector('floor-plan')!.removeAttribute('controls'));
  await expect(axes).toBeHidden();
});

test('on a phone the axes lead to the choice of them', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await openRoom(page);
  await page.getByRole('button', { name: 'Model', exact: true }).first().click();
  await page.getByRole('button', { name: 'Set the up axis' }).click();
  await expect(page.locator('#param-up')).toBeFocused();
});

for (const width of [1440, 390]) {
  test(`measuring and the axes are accessible, ${width} px wide`, async ({ page }) => {
    await page.setViewportSize({ width, height: 844 });
    await openRoom(page);
    await page.getByTestId('measure').click();
    await page.getByRole('combobox', { name: 'Length of' }).selectOption({ index: 1 });
    expect(await axe(page)).toEqual([]);
    if (width > 760) return;
    await page.getByRole('button', { name: 'Model', exact: true }).first().click();
    await expect(page.getByRole('button', { name: 'Set the up axis' })).toBeVisible();
    expect(await axe(page)).toEqual([]);
  });
}
