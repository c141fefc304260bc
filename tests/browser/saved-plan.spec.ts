import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { dropFile, expect, expectReady, openPlan, stagesRun, test } from './plan-page.ts';

async function save(page: Page, format: string): Promise<string> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(`export-${format}`).click(),
  ]);
  return readFile(await download.path(), 'utf8');
}

test('a dropped plan.json is shown again, changed, and saved as every format that needs no points', async ({
  page,
}) => {
  await openPlan(page);
  const [plan, geojson, svg] = [
    await save(page, 'json'),
    await save(page, 'geojson'),
    await save(page, 'svg'),
  ];

  await page.goto('./?src=');
  await dropFile(page, 'saved.json', plan);
  await expectReady(page);
  await expect(page.getByText(/home\.ply · saved plan · /)).toBeVisible();
  expect(await stagesRun(page)).toEqual(expect.arrayContaining(['plan', 'solid']));
  await expect(page.locator('[data-stage=read]')).toHaveAttribute('data-mark', 'saved');
  await expect(page.locator('[data-stage=read]')).toContainText('in the saved plan');
  expect(await save(page, 'json')).toBe(plan);
  expect(await save(page, 'geojson')).toBe(geojson);
  expect(await save(page, 'svg')).toBe(svg);
  await expect(page.getByTestId('export-slice')).toBeDisabled();
  await expect(page.getByTestId('crop')).toBeHidden();

  const glb = await save(page, 'glb');
  await page.locator('floor-plan').evaluate((element) => element.setAttribute('floor-slab', 'false'));
  await expect.poll(() => save(page, 'glb')).not.toBe(glb);
  await expectReady(page);

  await page.locator('floor-plan').evaluate((element) => element.setAttribute('level', '1'));
  await expect(page.getByText(/cannot change it/)).toBeVisible();
});

test('a damaged plan.json says where, and the plan before stays', async ({ page }) => {
  await openPlan(page);
  const plan = JSON.parse(await save(page, 'json'));
  plan.storeys[0].rooms[0].outline.outer[1] = ['x', 0];
  await dropFile(page, 'broken.json', JSON.stringify(plan));
  await expect(page.getByTestId('error')).toContainText('storeys[0].rooms[0].outline.outer[1]');
  await expect(page.getByTestId('plan-svg')).toBeVisible();
});
