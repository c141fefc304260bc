import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import type { FloorPlanElement } from '../../src/element/floor-plan.ts';
import { axe, drawOutline, dropFile, expect, expectReady, onSheet, openPlan, test } from './plan-page.ts';

/** Letters that run right to left, an emoji of several code points, and what would be markup. */
const NAME = 'مطبخ 👩‍🍳 <b>&;';

async function save(page: Page, format: string): Promise<string> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(`export-${format}`).click(),
  ]);
  return readFile(await download.path(), 'utf8');
}

const roomNames = (page: Page) =>
  page.locator('floor-plan').evaluate((plan: FloorPlanElement) => plan.options.roomNames ?? 'none');

const planRooms = (page: Page) =>
  page
    .locator('floor-plan')
    .evaluate((element: FloorPlanElement) => element.plan!.storeys[0].rooms.map(({ name }) => name));

/** The middle of a room's box, in source coordinates; the rooms of the home are near to boxes. */
const middleOf = (page: Page, index: number) =>
  page.locator('floor-plan').evaluate((element: FloorPlanElement, i) => {
    const { storeys, frame } = element.plan!;
    const { outer } = storeys[0].rooms[i].outline;
    const mean = (axis: 0 | 1) => {
      const along = [...outer].filter((_, k) => k % 2 === axis);
      return (Math.min(...along) + Math.max(...along)) / 2 / frame.metresPerUnit + frame.planOrigin[axis];
    };
    return [mean(0), mean(1)] as const;
  }, index);

const drawing = (page: Page) => page.getByTestId('plan-svg').locator('svg');

test('a room is pressed and named, in the drawing and in what is saved; undo and redo follow', async ({
  page,
}) => {
  await openPlan(page);
  await page.keyboard.press('n');
  const words = page.getByTestId('name-words');
  await expect(words).toHaveText('Press a room to name it.');
  const input = page.getByTestId('room-name');
  await expect(input).toBeDisabled();
  const place = await onSheet(page, ...(await middleOf(page, 1)));
  await page.mouse.move(...place);
  await expect(words).toHaveText(/^Room 2, \d+\.\d m²$/);
  await expect(page.locator('.mark-area')).toHaveCount(1);
  await page.mouse.click(...place);
  await expect(page.locator('.mark-area.is-chosen')).toHaveCount(1);
  await expect(input).toBeFocused();
  await expect(input).toHaveValue('Room 2');
  await page.keyboard.insertText(NAME);
  await page.keyboard.press('Enter');
  await expect(drawing(page)).toContainText(NAME);
  await expectReady(page);
  await expect(input).toHaveValue(NAME);
  await expect(words).toHaveText(/^\u2068.+\u2069, \d+\.\d m²$/);
  await expect(input).toBeFocused();
  expect((await planRooms(page))[1]).toBe(NAME);
  expect(await roomNames(page)).toMatch(/^[\d.]+,[\d.]+=مطبخ 👩‍🍳 <b>&;;$/);
  expect(await save(page, 'svg')).toContain('مطبخ 👩‍🍳 &lt;b&gt;&amp;;');
  expect(await save(page, 'rooms')).toContain(NAME);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(drawing(page)).not.toContainText('مطبخ');
  await expect(drawing(page)).toContainText('Room 2');
  await expect(input).toHaveValue('Room 2');
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(drawing(page)).toContainText(NAME);
  await expect(input).toHaveValue(NAME);
});

test('rooms are named by the keyboard alone; Escape lets go of what was being typed', async ({ page }) => {
  await openPlan(page);
  await page.getByTestId('name-rooms').focus();
  await page.keyboard.press('Enter');
  const input = page.getByTestId('room-name');
  const next = page.getByTestId('next-room');
  await expect(next).toBeVisible();
  await next.focus();
  await page.keyboard.press('Enter');
  await expect(input).toBeFocused();
  await page.keyboard.insertText('Hall');
  // The way on takes the name, too.
  await page.keyboard.press('Tab');
  await expect(next).toBeFocused();
  await page.keyboard.press('Space');
  await expect(input).toHaveValue('Room 2');
  await page.keyboard.insertText('Bath');
  await page.keyboard.press('Enter');
  await expect.poll(() => planRooms(page)).toEqual(expect.arrayContaining(['Hall', 'Bath']));
  // Without a name it is called as before.
  await page.keyboard.press('Delete');
  await page.keyboard.press('Enter');
  await expect.poll(() => planRooms(page)).toEqual(expect.arrayContaining(['Hall', 'Room 2']));
  await expect(input).toHaveValue('Room 2');
  await page.keyboard.insertText('Cellar');
  expect(await axe(page)).toEqual([]);
  await page.keyboard.press('Escape');
  await expect(input).toBeHidden();
  await expect(page.locator('.mark-area')).toHaveCount(0);
  await expectReady(page);
  expect(await planRooms(page)).not.toContain('Cellar');
  expect(await roomNames(page)).toMatch(/=Hall$/);
});

test('a finger names a room of a phone; a finger on the next takes the name', async ({
  browser,
  baseURL,
}) => {
  const context = await browser.newContext({ hasTouch: true, viewport: { width: 390, height: 844 } });
  const page = await context.newPage();
  await page.goto(baseURL!);
  await expectReady(page);
  await page.getByTestId('name-rooms').tap();
  await page.touchscreen.tap(...(await onSheet(page, ...(await middleOf(page, 0)))));
  await expect(page.getByTestId('room-name')).toBeFocused();
  await page.keyboard.insertText('Hall');
  await page.touchscreen.tap(...(await onSheet(page, ...(await middleOf(page, 1)))));
  await expect.poll(() => planRooms(page)).toContain('Hall');
  await expect(page.getByTestId('room-name')).toHaveValue('Room 2');
  await context.close();
});

test('rooms of a saved plan are named; names are of their scan alone', async ({ page }) => {
  await openPlan(page);
  const saved = await save(page, 'json');
  await page.getByTestId('name-rooms').click();
  await page.getByTestId('next-room').click();
  await page.keyboard.insertText('Of the scan');
  await page.keyboard.press('Enter');
  await expect.poll(() => planRooms(page)).toContain('Of the scan');

  await dropFile(page, 'plan.json', saved);
  await expect(page.getByText(/ · saved plan · /)).toBeVisible();
  await expectReady(page);
  expect(await planRooms(page)).not.toContain('Of the scan');
  await page.mouse.click(...(await onSheet(page, ...(await middleOf(page, 2)))));
  await page.keyboard.insertText('Study');
  await page.keyboard.press('Enter');
  await expect.poll(() => planRooms(page)).toContain('Study');
  await expect(drawing(page)).toContainText('Study');
  const named = await save(page, 'json');

  await page.goto('./?src=');
  await dropFile(page, 'again.json', named);
  await expectReady(page);
  expect(await planRooms(page)).toContain('Study');
  await page.keyboard.press('n');
  await page.mouse.click(...(await onSheet(page, ...(await middleOf(page, 2)))));
  await expect(page.getByTestId('room-name')).toHaveValue('Study');
  await page.keyboard.press('Delete');
  await page.keyboard.press('Enter');
  await expect.poll(() => planRooms(page)).toContain('Room 3');
});

test('a plan of outlines has no rooms to name, and says so', async ({ page }) => {
  await openPlan(page);
  await page.getByTestId('name-rooms').click();
  await drawOutline(page);
  await expect(page.getByTestId('name-words')).toContainText('no rooms to name');
  await expect(page.getByTestId('next-room')).toBeDisabled();
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('name-rooms')).toBeHidden();
  await page.keyboard.press('n');
  await expect(page.getByTestId('name-words')).toBeHidden();
  await page.locator('[data-stage=plan] > summary').click();
  await expect(page.getByTestId('names-in-drawing')).toBeDisabled();
  const field = page.getByRole('textbox', { name: 'Room names' });
  await field.fill('1,1');
  await field.press('Enter');
  await expect(field).toHaveAttribute('aria-invalid', 'true');
  await field.fill('1,1=Hall');
  await field.press('Enter');
  await expect(page.getByText(/is of no use: the plan is one of outlines/)).toBeVisible();
});
