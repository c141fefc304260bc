import type { Page } from '@playwright/test';
import type { FloorPlanElement } from '../../src/element/floor-plan.ts';
import { axe, dropFile, expect, expectReady, onSheet, roomCsv, stagesRun, test } from './plan-page.ts';

async function openRoom(page: Page): Promise<void> {
  await page.goto('./?src=');
  await dropFile(page, 'room.csv', roomCsv(0.04));
  await expectReady(page);
}

/** The box as set; null where there is none. */
function cropOf(page: Page): Promise<number[] | null> {
  return page.evaluate(() => {
    const crop = (document.querySelector('floor-plan') as FloorPlanElement).options.crop ?? 'none';
    return crop === 'none' ? null : crop.split(',').map(Number);
  });
}

/** Of the plan's outline, m²; the file's unit is the metre. */
function areaOf(page: Page): Promise<number> {
  return page
    .locator('.status-detail')
    .textContent()
    .then((words) => Number.parseFloat(words!));
}

async function drag(page: Page, from: [number, number], to: [number, number]): Promise<void> {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await page.mouse.move(...to);
  await page.mouse.up();
}

function expectNear(found: number[] | null, expected: readonly number[]): void {
  expect(found).toHaveLength(expected.length);
  for (const [i, value] of expected.entries()) expect(Math.abs(found![i] - value)).toBeLessThan(0.1);
}

test('a box is drawn, resized, moved and taken away; undo follows', async ({ page }) => {
  await openRoom(page);
  const whole = await areaOf(page);
  await page.keyboard.press('c');
  const words = page.getByTestId('crop-words');
  await expect(words).toHaveText('Drag a box around what the plan is to be made from.');
  await drag(page, await onSheet(page, -0.5, -0.5), await onSheet(page, 3, 6));
  await expect.poll(() => cropOf(page)).not.toBeNull();
  expectNear(await cropOf(page), [-0.5, -0.5, 3, 6]);
  await expect.poll(() => areaOf(page)).toBeLessThan(0.75 * whole);
  expect(await stagesRun(page)).not.toContain('frame');
  await expect(page.locator('.mark-handle')).toHaveCount(8);
  await expect(words).toHaveText(/^3\.\d+ m × 6\.\d+ m$/);

  await drag(page, await onSheet(page, 3, 2.75), await onSheet(page, 6.5, 2.75));
  await expect.poll(async () => (await cropOf(page))![2]).toBeGreaterThan(6.4);
  await expect.poll(() => areaOf(page)).toBeCloseTo(whole, 0);
  await drag(page, await onSheet(page, 5, 4), await onSheet(page, 5, 3));
  await expect.poll(async () => (await cropOf(page))![3]).toBeLessThan(5.2);
  expectNear(await cropOf(page), [-0.5, -1.5, 6.5, 5]);

  await page.getByRole('button', { name: 'Undo' }).click();
  expectNear(await cropOf(page), [-0.5, -0.5, 6.5, 6]);
  await page.getByTestId('remove-crop').click();
  expect(await cropOf(page)).toBeNull();
  await expect(page.locator('.mark-box')).toHaveCount(0);
  await page.keyboard.press('Control+z');
  expectNear(await cropOf(page), [-0.5, -0.5, 6.5, 6]);
  await page.keyboard.press('Escape');
  await expect(words).toBeHidden();
  await expect(page.locator('.mark-box')).toHaveCount(0);
});

test('a drag beside the box moves the sheet, and Escape drops a box half drawn', async ({ page }) => {
  await openRoom(page);
  await page.getByTestId('crop').click();
  const [x, y] = await onSheet(page, 0, 0);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y - 60);
  await expect(page.locator('.mark-box')).toHaveCount(1);
  await page.keyboard.press('Escape');
  await expect(page.locator('.mark-box')).toHaveCount(0);
  await page.mouse.up();
  expect(await cropOf(page)).toBeNull();
  await page.keyboard.press('c');
  await drag(page, await onSheet(page, -0.5, -0.5), await onSheet(page, 6.5, 3.5));
  await expect(page.locator('[data-stage=crop] .outcome')).toHaveText(/points$/);
  const box = await cropOf(page);
  const before = await onSheet(page, 0, 0);
  const beside = await onSheet(page, 3, 5);
  await drag(page, beside, [beside[0] + 40, beside[1] + 10]);
  const after = await onSheet(page, 0, 0);
  expect(after[0] - before[0]).toBeCloseTo(40, 0);
  expect(await cropOf(page)).toEqual(box);
});

test('the box is set by numbers alone, heights too', async ({ page }) => {
  await openRoom(page);
  await page.locator('[data-stage=crop] > summary').press('Enter');
  await page.getByTestId('crop-in-drawing').press('Enter');
  const bar = page.getByRole('group', { name: 'Crop', exact: true });
  const field = (name: string) => bar.getByRole('spinbutton', { name, exact: true });
  await field('x to').fill('3');
  await field('x to').press('Enter');
  await expect.poll(() => cropOf(page)).toEqual([0, 0, 3, 5]);
  await field('Height to').fill('2');
  await field('Height to').press('Enter');
  await expect.poll(() => cropOf(page)).toEqual([0, 0, 3, 5, 0, 2]);
  await field('x from').fill('4');
  await field('x from').press('Enter');
  await expect(field('x from')).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByTestId('crop-words')).toHaveText('The first number must be less than the second.');
  expect(await cropOf(page)).toEqual([0, 0, 3, 5, 0, 2]);
});

test('on a sheet that turns the plan square the box lies along the sheet, and a number turns it', async ({
  page,
}) => {
  await page.goto('./?src=');
  const angle = (20 * Math.PI) / 180;
  const turned = roomCsv(0.04)
    .split('\n')
    .map((line, i) => {
      const [x, y, z] = line.split(',').map(Number);
      const at = [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle)];
      return i === 0 ? line : [...at.map((value) => value.toFixed(4)), z].join(',');
    });
  await dropFile(page, 'turned.csv', turned.join('\n'));
  await expectReady(page);
  await page.keyboard.press('c');
  // The left arm of the L, as it lies on the sheet.
  const inPlan = (x: number, y: number) =>
    onSheet(page, x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle));
  await drag(page, await inPlan(-0.4, -0.4), await inPlan(3.2, 5.4));
  // 15 m² and a strip of the other arm.
  await expect.poll(() => areaOf(page)).toBeLessThan(16.5);
  const crop = await page.evaluate(
    () => (document.querySelector('floor-plan') as FloorPlanElement).options.crop,
  );
  expect(Math.abs(Number(crop!.split('@')[1]) - 20)).toBeLessThan(0.5);
  const words = page.getByTestId('crop-words');
  await expect(words).toHaveText(/^3\.[56]\d? m × 5\.[789]\d? m$/);
  const heading = page.getByRole('spinbutton', { name: 'Turned by, degrees' });
  await heading.fill('200');
  await heading.press('Enter');
  await expect(words).toHaveText('A box turns by 180° at most.');
  await heading.fill('0');
  await heading.press('Enter');
  await expect
    .poll(() => page.evaluate(() => (document.querySelector('floor-plan') as FloorPlanElement).options.crop))
    .toBe(crop!.split('@')[0]);
});

test('another axis up takes box and doors away and says so; undo brings them back', async ({ page }) => {
  await openRoom(page);
  const options = () =>
    page.evaluate(() => (document.querySelector('floor-plan') as FloorPlanElement).options);
  const placed = { crop: '-0.5,-0.5,6.5,6', doors: '3,0,0.9' };
  await page.evaluate((given) => {
    (document.querySelector('floor-plan') as FloorPlanElement).options = given;
  }, placed);
  await expect(page.getByTestId('status')).toHaveText('Plan ready');
  const axes = page.getByRole('group', { name: 'Axes of the scan' });
  await axes.getByRole('button', { name: 'Take -z for up' }).press('Enter');
  await expect.poll(options).toEqual({ up: '-z', crop: '-0.5,-6,6.5,0.5', doors: '3,0,0.9' });
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(options).toEqual(placed);
  await axes.getByRole('button', { name: 'Take y for up' }).press('Enter');
  await expect.poll(options).toEqual({ up: 'y', crop: 'none', doors: 'none' });
  const notice = page.locator('[data-code="frame/crop-dropped"]');
  await expect(notice).toContainText('The crop box was taken away');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(options).toEqual(placed);
  await expect(notice).toHaveCount(0);
});

test('a box beside the scan says so, and the last plan stays', async ({ page }) => {
  await openRoom(page);
  await page.locator('[data-stage=crop] > summary').click();
  const text = page.getByRole('textbox', { name: 'Crop box' });
  await text.fill('50,50,60');
  await text.press('Enter');
  await expect(text).toHaveAttribute('aria-invalid', 'true');
  await text.fill('50,50,60,60');
  await text.press('Enter');
  const error = page.getByTestId('error');
  await expect(error).toContainText('expected at least 3 points in the box 50,50,60,60 m, found 0');
  await expect(error).toContainText('input/too-few-points');
  await expect(page.getByTestId('plan-svg').locator('svg')).toBeVisible();
  await expect(page.locator('[data-stage=crop]')).toHaveAttribute('data-mark', 'failed');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(error).toBeHidden();
  await expect(page.getByTestId('status')).toHaveText('Plan ready');
});

test('a finger draws a box', async ({ browser, baseURL }) => {
  const context = await browser.newContext({ hasTouch: true, viewport: { width: 390, height: 844 } });
  const page = await context.newPage();
  await page.goto(`${baseURL}?src=`);
  await dropFile(page, 'room.csv', roomCsv(0.04));
  await expectReady(page);
  await page.getByTestId('crop').tap();
  const [from, to] = [await onSheet(page, -0.5, -0.5), await onSheet(page, 3, 6)];
  const touch = await context.newCDPSession(page);
  const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...points: [number, number][]) =>
    touch.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  await send('touchStart', from);
  await send('touchMove', [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
  await send('touchMove', to);
  await send('touchEnd');
  await expect.poll(() => cropOf(page)).not.toBeNull();
  const [x0, , x1] = (await cropOf(page))!;
  expect(x0).toBeCloseTo(-0.5, 0);
  expect(x1).toBeCloseTo(3, 0);
  await context.close();
});

for (const width of [1440, 1024, 390]) {
  test(`cropping is accessible and nothing is cut off, ${width} px wide`, async ({ page }) => {
    await page.setViewportSize({ width, height: 844 });
    await openRoom(page);
    await page.getByTestId('crop').click();
    await drag(page, await onSheet(page, -0.5, -0.5), await onSheet(page, 3, 6));
    await expect(page.getByTestId('remove-crop')).toBeVisible();
    expect(await axe(page)).toEqual([]);
    const cut = await page
      .locator('.pane-2d .tools, .tool-bar')
      .evaluateAll((bars) => bars.map((bar) => bar.scrollWidth - bar.clientWidth));
    expect(Math.max(...cut)).toBe(0);
  });
}
