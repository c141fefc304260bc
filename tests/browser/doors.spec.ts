import type { Locator, Page } from '@playwright/test';
import type { FloorPlanElement } from '../../src/element/floor-plan.ts';
import { drawOutline, dropFile, expect, expectReady, onSheet, roomCsv, test } from './plan-page.ts';

/** A room with a gap of a metre in its south wall and one of 0.8 m in its west wall. */
function gappyRoom(): string {
  return roomCsv(0.04)
    .split('\n')
    .filter((line, i) => {
      const [x, y] = line.split(',').map(Number);
      return i === 0 || !((y === 0 && x > 2 && x < 3) || (x === 0 && y > 2 && y < 2.8));
    })
    .join('\n');
}

async function openRoom(page: Page): Promise<void> {
  await page.goto('./?src=');
  await dropFile(page, 'room.csv', gappyRoom());
  await expectReady(page);
  await drawOutline(page);
}

test('a door is cut by a press on a wall, and taken away by another; undo and redo follow', async ({
  page,
}) => {
  await openRoom(page);
  await page.keyboard.press('d');
  const words = page.getByTestId('door-words');
  await expect(words).toBeVisible();
  const place = await onSheet(page, 1.5, 5.1);
  await page.mouse.move(...place);
  await expect(words).toHaveText('Cut a door here, 0.9 m wide.');
  await expect(page.locator('.mark-cut')).toHaveCount(1);
  await page.mouse.click(...place);
  await expect.poll(() => doors(page)).toMatch(/^1\.\d+,5\.1,0\.9$/);
  await expect(drawnDoors(page)).toHaveCount(1);
  const text = await doors(page);
  await page.mouse.move(place[0] + 2, place[1]);
  await expect(words).toHaveText('Take this door away, 0.9 m wide.');
  await page.mouse.click(...place);
  await expect(drawnDoors(page)).toHaveCount(0);
  expect(await doors(page)).toBe('none');
  await page.keyboard.press('Control+z');
  await expect(drawnDoors(page)).toHaveCount(1);
  expect(await doors(page)).toBe(text);
  await page.keyboard.press('Control+Shift+z');
  await expect(drawnDoors(page)).toHaveCount(0);
  await page.keyboard.press('Escape');
  await expect(words).toBeHidden();
  await page.mouse.click(...place);
  expect(await doors(page)).toBe('none');
});

test('a door has the size that was asked for, and the model its hole', async ({ page }) => {
  await openRoom(page);
  await page.getByTestId('cut-doors').click();
  const bar = page.getByRole('group', { name: 'Cut doors' });
  const width = bar.getByRole('spinbutton', { name: 'Width' });
  await width.fill('0');
  await expect(width).toHaveAttribute('aria-invalid', 'true');
  await width.fill('1.4');
  await expect(width).not.toHaveAttribute('aria-invalid');
  await bar.getByRole('spinbutton', { name: 'Height' }).fill('2.2');
  const triangles = await trianglesOf(page);
  await page.mouse.click(...(await onSheet(page, 4.5, 3.1)));
  await expect.poll(() => doors(page)).toMatch(/,1\.4,2\.2$/);
  await expect(drawnDoors(page)).toHaveCount(1);
  expect(await trianglesOf(page)).toBeGreaterThan(triangles);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(drawnDoors(page)).toHaveCount(0);
});

test('a gap is pressed in the drawing and becomes a door of its width; a drag moves the sheet', async ({
  page,
}) => {
  await openRoom(page);
  await page.getByTestId('cut-doors').click();
  await expect(page.locator('.mark-candidate')).toHaveCount(2);
  const [x, y] = await onSheet(page, 2.5, -0.1);
  await page.mouse.move(x, y);
  await expect(page.getByTestId('door-words')).toHaveText(/^Make a door of this gap, 1 m wide\.$/);
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 20, { steps: 4 });
  await page.mouse.up();
  await page.mouse.move(x, y);
  await page.mouse.move(x + 20, y + 20);
  await page.mouse.click(x + 20, y + 20);
  await expect(page.locator('.mark-candidate')).toHaveCount(1);
  await expect(drawnDoors(page)).toHaveCount(1);
  expect(Number((await doors(page)).split(',')[2])).toBeCloseTo(1, 1);
});

test('a finger cuts a door with one tap', async ({ browser, baseURL }) => {
  const context = await browser.newContext({ hasTouch: true, viewport: { width: 390, height: 844 } });
  const page = await context.newPage();
  await page.goto(`${baseURL}?src=`);
  await dropFile(page, 'room.csv', gappyRoom());
  await expectReady(page);
  await page.getByTestId('cut-doors').tap();
  await expect(page.getByTestId('door-words')).toBeVisible();
  await page.touchscreen.tap(...(await onSheet(page, 1.5, 5.1)));
  await expect(drawnDoors(page)).toHaveCount(1);
  await page.touchscreen.tap(...(await onSheet(page, 1.5, 5.1)));
  await expect(drawnDoors(page)).toHaveCount(0);
  await context.close();
});

test('doors are made of gaps and removed by the keyboard alone', async ({ page }) => {
  await openRoom(page);
  await page.getByRole('button', { name: 'Make doors of gaps' }).press('Enter');
  const list = page.getByRole('list', { name: 'Gaps and doors' });
  const first = list.getByRole('button').first();
  await expect(first).toBeFocused();
  await expect(first).toHaveAccessibleName(/^Make a door: Gap, 1 m wide at /);
  await expect(page.locator('.mark-cut')).toHaveCount(1);
  await page.keyboard.press('Enter');
  await expect(drawnDoors(page)).toHaveCount(1);
  await expect(first).toBeFocused();
  await expect(first).toHaveAccessibleName(/^Remove: Door in a gap/);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await expect(drawnDoors(page)).toHaveCount(2);
  await page.keyboard.press('Enter');
  await expect(drawnDoors(page)).toHaveCount(1);
});

test('with every gap a door, one is taken away and the other stays', async ({ page }) => {
  await openRoom(page);
  await page.locator('[data-stage=plan] > summary').click();
  await page.getByRole('checkbox', { name: 'Cut all gaps' }).check();
  await expect(drawnDoors(page)).toHaveCount(2);
  await page.getByRole('button', { name: /^Remove: Door in a gap, 1 m/ }).click();
  await expect(drawnDoors(page)).toHaveCount(1);
  await expect(page.getByRole('checkbox', { name: 'Cut all gaps' })).not.toBeChecked();
});

function drawnDoors(page: Page): Locator {
  return page.getByTestId('plan-svg').locator('[data-kind=door]');
}

function doors(page: Page): Promise<string> {
  return page.evaluate(
    () => (document.querySelector('floor-plan') as FloorPlanElement).options.doors ?? 'none',
  );
}

/** Of the model, by the report on the page. */
function trianglesOf(page: Page): Promise<number> {
  return page
    .locator('[data-stage=solid] .outcome')
    .textContent()
    .then((words) => Number(/([\d,]+) triangles/.exec(words!)![1].replaceAll(',', '')));
}
