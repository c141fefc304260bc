import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import type { FloorPlanElement } from '../../src/element/floor-plan.ts';
import { dropFile, expect, expectReady, openPlan, roomCsv, stagesRun, test } from './plan-page.ts';

const HALLWAY = '?src=samples/hallway.csv';

test('the steps are leafed through by keys, each with its picture, counts and time', async ({ page }) => {
  await openPlan(page);
  await openSteps(page);
  const tabs = page.getByRole('tab');
  const names = await tabs.evaluateAll((all) => all.map((tab) => (tab as HTMLElement).dataset.testid!));
  expect(names.slice(0, 4)).toEqual(['step-cloud', 'step-levels', 'step-slice', 'step-hull']);
  expect(names.at(-1)).toBe('step-model');
  for (const name of names) {
    await expect(page.getByTestId(name)).toHaveAttribute('aria-selected', 'true');
    await expect(pictureShown(page)).toHaveAttribute('data-picture', name.replace('step-', ''));
    await expect(page.getByTestId('step-outcome')).toContainText(/\d+ ms|\d s/);
    await page.keyboard.press(']');
  }
  await page.keyboard.press('[');
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'plan');
  await page.getByTestId('step-plan').focus();
  await page.keyboard.press('ArrowLeft');
  await expect(page.getByTestId(names.at(-3)!)).toBeFocused();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByTestId('step-plan')).toHaveAttribute('aria-selected', 'true');
  await page.getByRole('button', { name: 'Drawing', exact: true }).click();
  await expect(page.getByTestId('plan-svg')).toBeVisible();
  await expect(page.getByTestId('step-picture')).toBeHidden();
});

test('a stage of the rail leads to its picture; on it arrow keys move and plus zooms', async ({ page }) => {
  await openPlan(page);
  await page.locator('[data-stage=boundary] > summary').click();
  await page.getByTestId('show-boundary').click();
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'hull');
  const place = () => pictureShown(page).evaluate((svg) => (svg as SVGElement).style.transform);
  const fitted = await place();
  await page.getByTestId('step-picture').focus();
  await page.keyboard.press('+');
  const zoomed = await place();
  expect(zoomed).not.toBe(fitted);
  await page.keyboard.press('ArrowLeft');
  expect(await place()).not.toBe(zoomed);
  await expect(page.getByTestId('step-hull')).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('0');
  expect(await place()).toBe(fitted);
});

test("a step's picture is saved as the SVG on show, and all of them as a ZIP", async ({ page }) => {
  await openPlan(page, HALLWAY);
  await openSteps(page);
  await page.getByTestId('step-hull').click();
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'hull');
  const saved = await downloadBy(page, 'save-picture');
  expect(saved.name).toBe('picture-04-hull.svg');
  const shown = await pathsOf(page);
  expect(shown.length).toBeGreaterThan(1);
  expect(await pathsIn(page, saved.text)).toEqual(shown);
  const all = await downloadBy(page, 'export-pictures');
  expect(all.text.slice(0, 2)).toBe('PK');
});

test('the pictures follow a changed parameter', async ({ page }) => {
  await openPlan(page, HALLWAY);
  await openSteps(page);
  await page.getByTestId('step-plan').click();
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'plan');
  const before = await pathsOf(page);
  await page.locator('[data-stage=plan] > summary').click();
  const thickness = page.locator('#param-wallThickness');
  await thickness.fill('0.4');
  await thickness.press('Enter');
  await expect.poll(() => pathsOf(page)).not.toEqual(before);
  await expect(page.getByTestId('step-plan')).toHaveAttribute('aria-selected', 'true');
});

test('two methods are compared overlaid and side by side; the plan stays', async ({ page }) => {
  await openPlan(page, HALLWAY);
  const plan = await page.getByTestId('plan-svg').locator('svg').innerHTML();
  await openSteps(page);
  await page.getByTestId('compare').click();
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'comparison');
  const table = page.getByTestId('compare-table');
  await expect(table).toContainText('This plan: Gift opening');
  await expect(table).toContainText('Alpha shape');
  await expect(page.getByTestId('compare-iou')).toHaveText(/^\d+\.\d %$/);
  const overlaid = await pathsOf(page);
  await page.getByRole('button', { name: 'Side by side' }).click();
  await expect.poll(() => pathsOf(page)).not.toEqual(overlaid);
  const saved = await downloadBy(page, 'save-comparison');
  expect(saved.name).toBe('comparison-boundary-alpha-shape.svg');
  expect(await pathsIn(page, saved.text)).toEqual(await pathsOf(page));
  await page.getByTestId('compare-param').selectOption({ label: 'Visvalingam pass' });
  await expect(table).toContainText('This plan: On');
  await expect(page.getByTestId('compare-iou')).toHaveText(/^\d+\.\d %$/);
  await page.keyboard.press('Escape');
  await expect(table).toBeHidden();
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'cloud');
  expect(await page.getByTestId('plan-svg').locator('svg').innerHTML()).toBe(plan);
  expect(await stagesRun(page)).toContain('read');
});

test('a comparison asked for before its code has come opens when it is there', async ({ page }) => {
  await page.route('**/steps-pane-*.js', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 1500));
    await route.continue();
  });
  await openPlan(page, HALLWAY);
  await page.getByRole('button', { name: 'Step by step' }).click();
  const button = page.getByTestId('compare');
  await button.click();
  await expect(button).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByTestId('compare-iou')).toHaveText(/^\d+\.\d %$/);
  await expect(button).toHaveAttribute('aria-pressed', 'true');
});

test('structures found by two methods are compared by the figures of the structures', async ({ page }) => {
  await openPlan(page, HALLWAY);
  await dropFile(page, 'room-2.csv', await readFile('tests/golden/room-2/slice.csv', 'utf8'));
  await expectReady(page);
  await setOptions(page, { secondaryCount: 1 });
  await expectReady(page);
  await openSteps(page);
  await setStep(page, 'clusters');
  await expect(page.getByTestId('refine')).toBeVisible();
  await page.getByTestId('compare').click();
  await expect(page.getByTestId('refine')).toBeHidden();
  await page.getByTestId('compare-param').selectOption({ label: 'Secondary method' });
  await expect(page.getByTestId('compare-table')).toContainText('Structures');
  const iou = page.getByTestId('compare-iou');
  await expect(iou).toHaveText(/^\d+\.\d %$/);
  const caption = page.locator('#caption');
  await expect(caption).toContainText('Structures · IoU');
  const [, told] = /IoU (0\.\d+)/.exec((await caption.textContent())!)!;
  expect(Number.parseFloat((await iou.textContent())!)).toBeCloseTo(100 * Number(told), 0);
});

test('a comparison that cannot be made says why and leaves the plan', async ({ page }) => {
  await openPlan(page, HALLWAY);
  await page.evaluate(() => {
    (document.querySelector('floor-plan') as FloorPlanElement).options = { alpha: 0.001 };
  });
  await expectReady(page);
  await openSteps(page);
  await page.getByTestId('compare').click();
  await expect(page.getByText(/result\/no-boundary/)).toBeVisible();
  await expect(page.getByTestId('save-comparison')).toBeDisabled();
  await expect(page.getByTestId('status')).toHaveText('Plan ready');
});

test('after a failed run the plan stays and the step before the failing one can be seen', async ({
  page,
}) => {
  await openPlan(page);
  const plan = await page.getByTestId('plan-svg').locator('svg').innerHTML();
  await setOptions(page, { boundary: 'alpha-shape', alpha: 0.001 });
  await expect(page.getByTestId('error')).toContainText('result/no-boundary');
  await expect(page.locator('[data-stage=boundary]')).toHaveAttribute('data-mark', 'failed');
  expect(await page.getByTestId('plan-svg').locator('svg').innerHTML()).toBe(plan);
  await page.getByTestId('step-before').click();
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'slice');
  await expect(page.getByTestId('step-picture')).toBeFocused();
  await expect(page.getByRole('tab')).toHaveCount(3);
  const banner = page.getByRole('region', { name: 'The run that failed' });
  await expect(banner).toContainText('Outline failed');
  await expect(banner).toContainText('Raise alpha');
  await page.getByRole('button', { name: 'Back to the plan' }).click();
  await expect(page.getByTestId('step-model')).toBeAttached();
  await setOptions(page, {});
  await expectReady(page);
  await expect(page.getByRole('region', { name: 'The run that failed' })).toBeHidden();
});

test('a first scan that fails shows the step before too', async ({ page }) => {
  await page.goto('./?src=');
  await setOptions(page, { boundary: 'alpha-shape', alpha: 0.001 });
  await dropFile(page, 'room.csv', roomCsv());
  await page.getByTestId('step-before').click();
  await expect(pictureShown(page)).toBeVisible();
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'slice');
  await expect(page.getByRole('button', { name: 'Back to the plan' })).toBeHidden();
});

test('the slice goes out as CSV and comes back in as a plan of the same outline', async ({ page }) => {
  await openPlan(page);
  const slice = await downloadBy(page, 'export-slice');
  expect(slice.text).toMatch(/^x,y\r?\n/);
  const area = await outlineArea(page);
  await setOptions(page, { preset: 'building', unit: 'm' });
  await dropFile(page, 'slice.csv', slice.text);
  await expectReady(page);
  await expect(page.getByText(/slice\.csv · /)).toBeVisible();
  expect(Math.abs((await outlineArea(page)) / area - 1)).toBeLessThan(0.02);
  await openSteps(page);
  await expect(page.getByTestId('step-slice')).toBeVisible();
});

test("one click gives every parameter the paper's value, and undo takes it back", async ({ page }) => {
  await openPlan(page);
  await setOptions(page, { visvalingamPass: false, strokeWidth: 0.3, unit: 'm' });
  await expectReady(page);
  await page.getByRole('group', { name: 'Preset' }).getByRole('button', { name: 'Paper' }).click();
  const promise = page.getByText(/Every parameter has the value of the paper/);
  await expect(promise).toBeVisible();
  // What it does not take from the paper is said where it is promised.
  await expect(promise).toContainText('with “Bridge gaps up to” at 0 the outline falls through doors');
  await expect.poll(() => options(page)).toEqual({ preset: 'paper', unit: 'm' });
  await expectReady(page);
  // What a stage holds is made when it first opens, its second fold with it.
  for (const folds of [page.locator('.stage'), page.locator('.more')]) {
    await folds.evaluateAll((all) => {
      for (const details of all) (details as HTMLDetailsElement).open = true;
    });
    await expect(page.locator('.more').first()).toBeAttached();
  }
  const paper: Readonly<Record<string, string>> = {
    epsilon: '0.024',
    strokeWidth: '0.1',
    secondaryEpsilon: '0.1',
    wallThickness: '0.1',
    alpha: '1.5',
  };
  for (const [name, value] of Object.entries(paper))
    await expect(page.locator(`#param-${name}`)).toHaveValue(value);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => options(page)).toEqual({ visvalingamPass: false, strokeWidth: 0.3, unit: 'm' });
});

test('the structure is refined by hand, once more at a time, and undo takes it back', async ({ page }) => {
  await openPlan(page, HALLWAY);
  await dropFile(page, 'room-2.csv', await readFile('tests/golden/room-2/slice.csv', 'utf8'));
  await expectReady(page);
  await setOptions(page, { secondaryCount: 1 });
  await expectReady(page);
  await setStep(page, 'clusters');
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'clusters');
  await page.getByTestId('refine').click();
  await expect.poll(() => options(page)).toEqual({ secondaryCount: 1, secondaryRounds: 2 });
  await expectReady(page);
  await setStep(page, 'secondary-outline');
  const second = page.getByRole('button', { name: 'Round 2' });
  await expect(second).toHaveAttribute('aria-pressed', 'true');
  await expect(page.locator('#caption')).toContainText('round 2');
  await page.getByRole('button', { name: 'Round 1' }).click();
  await expect(second).toHaveAttribute('aria-pressed', 'false');
  await expect(page.locator('#caption')).toContainText('round 1');
  const saved = await downloadBy(page, 'save-picture');
  expect(saved.name).toMatch(/^picture-\d+-secondary-outline-round-1\.svg$/);
  expect(saved.text).toContain('round 1');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => options(page)).toEqual({ secondaryCount: 1 });
  await expect(second).toBeHidden();
  // Beside the picture too: on a phone the undo of the rail is out of sight.
  await expect(page.getByTestId('take-back')).toBeHidden();
  await page.getByTestId('refine').click();
  await page.getByTestId('take-back').click();
  await expect.poll(() => options(page)).toEqual({ secondaryCount: 1, secondaryRounds: 1 });
  await expect(second).toBeHidden();
});

test('the cluster of the structure is picked in the picture or the list; undo takes it back', async ({
  page,
}) => {
  await openPlan(page, HALLWAY);
  await dropFile(page, 'room-2.csv', await readFile('tests/golden/room-2/slice.csv', 'utf8'));
  await expectReady(page);
  await setOptions(page, { secondaryCount: 2 });
  await expectReady(page);
  await setStep(page, 'clusters');
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'clusters');
  const clusters = page.getByRole('group', { name: 'Cluster of the structure' });
  await expect(clusters.getByRole('button')).toHaveCount(4);
  // Beside the first point of cluster 0: a finger is no needle.
  const [x, y] = await page.locator('#cluster-0').evaluate((path: SVGPathElement) => {
    const [, left, top] = path
      .getAttribute('d')!
      .match(/^M([\d.]+) ?(-?[\d.]+)/)!
      .map(Number);
    const { x, y } = new DOMPoint(left, top).matrixTransform(path.getScreenCTM()!);
    return [x + 5, y - 5];
  });
  await page.mouse.click(x, y);
  await expect.poll(() => options(page)).toEqual({ secondaryCount: 2, secondaryCluster: 0 });
  await expectReady(page);
  await expect(clusters.getByRole('button', { name: /^0: / })).toHaveAttribute('aria-pressed', 'true');
  await clusters.getByRole('button', { name: /^1: / }).click();
  await expect.poll(() => options(page)).toEqual({ secondaryCount: 2, secondaryCluster: 1 });
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => options(page)).toEqual({ secondaryCount: 2 });
});

test('an element that is moved goes on with its step', async ({ page }) => {
  await openPlan(page, HALLWAY);
  await setStep(page, 'hull');
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'hull');
  await page.evaluate(() => {
    const element = document.querySelector('floor-plan')!;
    element.remove();
    document.querySelector('main')!.append(element);
  });
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'hull');
});

test('a cancelled load leaves the pictures of the plan shown', async ({ page }) => {
  await openPlan(page, HALLWAY);
  await openSteps(page);
  await dropFile(page, 'big.csv', roomCsv(0.0075));
  await expect(page.getByTestId('progress')).toBeVisible();
  await page.getByTestId('cancel').click();
  await expect(page.getByTestId('status')).toHaveText('Plan ready');
  await page.getByTestId('step-model').click();
  await expect(pictureShown(page)).toHaveAttribute('data-picture', 'model');
});

async function openSteps(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Step by step' }).click();
  await expect(pictureShown(page)).toBeVisible();
}

function pictureShown(page: Page) {
  return page.getByTestId('step-picture').locator('.paper > svg');
}

function pathsOf(page: Page): Promise<(string | null)[]> {
  return page
    .getByTestId('step-picture')
    .evaluate((host) => [...host.querySelectorAll('path')].map((path) => path.getAttribute('d')));
}

function pathsIn(page: Page, text: string): Promise<(string | null)[]> {
  return page.evaluate((svg) => {
    const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml');
    return [...parsed.querySelectorAll('path')].map((path) => path.getAttribute('d'));
  }, text);
}

async function downloadBy(page: Page, testid: string): Promise<{ name: string; text: string }> {
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByTestId(testid).click()]);
  return { name: saved.suggestedFilename(), text: (await readFile(await saved.path())).toString('latin1') };
}

function setOptions(page: Page, given: FloorPlanElement['options']): Promise<void> {
  return page.evaluate((value) => {
    (document.querySelector('floor-plan') as FloorPlanElement).options = value;
  }, given);
}

function setStep(page: Page, step: string): Promise<void> {
  return page.evaluate((name) => {
    (document.querySelector('floor-plan') as FloorPlanElement).step = name;
  }, step);
}

function options(page: Page): Promise<FloorPlanElement['options']> {
  return page.evaluate(() => (document.querySelector('floor-plan') as FloorPlanElement).options);
}

/** Of the first outline, m², by the shoelace formula. */
function outlineArea(page: Page): Promise<number> {
  return page.evaluate(() => {
    const { outer } = (document.querySelector('floor-plan') as FloorPlanElement).plan!.storeys[0].primary[0];
    let twice = 0;
    for (let i = 0, j = outer.length - 2; i < outer.length; j = i, i += 2)
      twice += outer[j] * outer[i + 1] - outer[i] * outer[j + 1];
    return twice / 2;
  });
}
