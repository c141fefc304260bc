import { readFile } from 'node:fs/promises';
import { unzipSync } from 'fflate';
import {
  drawOutline,
  dropFile,
  expect,
  expectReady,
  openPlan,
  roomCsv,
  stagesRun,
  test,
} from './plan-page.ts';

/** Every format the page offers, with what its file must begin with or hold. */
const CONTENT: Readonly<Record<string, RegExp>> = {
  svg: /<svg[\s\S]*<\/svg>/,
  'minimal-svg': /<path/,
  dxf: /^\s*(0|999)\r?\n/,
  geojson: /"FeatureCollection"/,
  glb: /^glTF/,
  json: /"version"/,
  frame: /"metresPerUnit"|"origin"/,
  slice: /^x,y\r?\n/,
  rooms: /^name,/,
  'rooms-xlsx': /^PK/,
  pdf: /^%PDF-1\.7[\s\S]*%%EOF\s*$/,
  png: /^\x89PNG/,
  ifc: /^ISO-10303-21;[\s\S]*END-ISO-10303-21;\s*$/,
  stl: /^mm, z up/,
  ply: /^ply\n/,
  obj: /^PK/,
  zip: /^PK/,
};

test('a sample loads by itself: plan, model and facts are shown', async ({ page }) => {
  await openPlan(page);
  const drawing = page.getByTestId('plan-svg');
  await expect(drawing).toBeVisible();
  expect(await drawing.locator('path').count()).toBeGreaterThan(1);
  await expect(page.getByText(/home\.ply · [\d,]+ of [\d,]+ points · in m · z up · 1 storey/)).toBeVisible();
  await expect
    .poll(async () => coloursIn(page, await page.getByTestId('scene-3d').screenshot()))
    .toBeGreaterThan(50);
  await expect(page).toHaveTitle(/home\.ply/);
});

test('the drawing on screen is the SVG that is exported', async ({ page }) => {
  await openPlan(page);
  const saved = await download(page, 'svg');
  const shown = await page
    .getByTestId('plan-svg')
    .evaluate((svg) => [...svg.querySelectorAll('path')].map((p) => p.getAttribute('d')));
  const inFile = await page.evaluate((text) => {
    const svg = new DOMParser().parseFromString(text, 'image/svg+xml');
    return [...svg.querySelectorAll('path')].map((p) => p.getAttribute('d'));
  }, saved.toString('utf8'));
  expect(shown).toEqual(inFile);
});

test('a dropped file becomes a plan, and every export is one click', async ({ page }) => {
  await page.goto('./?src=');
  await expect(page.getByText('Drop a scan, get its floor plan')).toBeVisible();
  await dropFile(page, 'room.csv', roomCsv());
  await expectReady(page);
  await expect(page.getByText(/room\.csv · /)).toBeVisible();
  const ids = await page
    .locator('[data-testid^=export-]')
    .evaluateAll((all) => all.map((b) => (b as HTMLElement).dataset.testid!));
  const formats = ids.map((id) => id.replace('export-', ''));
  for (const format of Object.keys(CONTENT)) expect(formats).toContain(format);
  // A table of points names no coordinate system.
  await expect(page.getByTestId('export-geojson-wgs84')).toBeDisabled();
  for (const format of formats.filter((name) => name !== 'geojson-wgs84')) {
    const bytes = await download(page, format);
    expect(bytes.length, format).toBeGreaterThan(10);
    const expected = CONTENT[format];
    if (expected) expect(bytes.toString('latin1'), format).toMatch(expected);
  }
});

test('formats chosen go in one ZIP', async ({ page }) => {
  await openPlan(page);
  const choose = page.getByTestId('choose-exports');
  const zip = page.getByTestId('export-zip');
  await choose.click();
  await expect(zip).toBeDisabled();
  for (const format of ['svg', 'dxf', 'rooms']) await page.getByTestId(`export-${format}`).click();
  await page.getByTestId('export-dxf').click();
  await expect(page.getByTestId('export-svg')).toHaveAttribute('aria-pressed', 'true');
  await expect(zip).toHaveText('ZIP of 2');
  const entries = unzipSync(await download(page, 'zip'));
  expect(Object.keys(entries).sort()).toEqual(['README.txt', 'plan.svg', 'rooms.csv']);
  await choose.click();
  await expect(zip).toHaveText('All as ZIP');
});

test('a picked file becomes a plan', async ({ page }) => {
  await page.goto('./?src=');
  await page
    .getByTestId('file-input')
    .setInputFiles({ name: 'room.csv', mimeType: 'text/csv', buffer: Buffer.from(roomCsv()) });
  await expectReady(page);
});

test('files picked together are one scan, or one of them', async ({ page }) => {
  await page.goto('./?src=');
  const rows = roomCsv().trim().split('\n');
  const part = (name: string, from: number, to?: number) => ({
    name,
    mimeType: 'text/csv',
    buffer: Buffer.from(`${[rows[0], ...rows.slice(from, to)].join('\n')}\n`),
  });
  const half = Math.floor(rows.length / 2);
  await page.getByTestId('file-input').setInputFiles([part('a.csv', 1, half), part('b.csv', half)]);
  await expectReady(page);
  await expect(page.getByText(/a\.csv \+ 1 · /)).toBeVisible();
  const choice = page.getByRole('combobox', { name: 'Files opened together' });
  await choice.selectOption('b.csv');
  await expect(page.getByText(/^b\.csv · /)).toBeVisible();
  await expectReady(page);
  await choice.selectOption('2 files as one scan');
  await expect(page.getByText(/a\.csv \+ 1 · /)).toBeVisible();
});

test('?src= loads a scan by its address', async ({ page }) => {
  await openPlan(page, '?src=samples/hallway.csv');
  await expect(page.getByText(/hallway\.csv · /)).toBeVisible();
});

test('cancel stops a run and keeps the last plan', async ({ page }) => {
  await openPlan(page);
  const before = await page.getByTestId('plan-svg').locator('svg').innerHTML();
  await dropFile(page, 'big.csv', roomCsv(0.0075));
  await expect(page.getByTestId('progress')).toBeVisible();
  await page.getByTestId('cancel').click();
  await expect(page.getByTestId('status')).toHaveText('Plan ready');
  await expect(page.getByTestId('progress')).toBeHidden();
  expect(await page.getByTestId('plan-svg').locator('svg').innerHTML()).toBe(before);
  expect((await download(page, 'geojson')).length).toBeGreaterThan(10);
});

test('an error says what was found and what to try, and the last plan stays', async ({ page }) => {
  await openPlan(page);
  const before = await page.getByTestId('plan-svg').locator('svg').innerHTML();
  await dropFile(page, 'letter.ply', 'Dear reader, this is no point cloud.');
  const error = page.getByTestId('error');
  await expect(error).toBeVisible();
  await expect(error.locator('code')).toHaveText(/^input\//);
  await expect(error.locator('.error-hint')).not.toBeEmpty();
  expect(await page.getByTestId('plan-svg').locator('svg').innerHTML()).toBe(before);
  await error.getByRole('button', { name: 'Close' }).click();
  await expect(error).toBeHidden();
  await expect(page.getByTestId('status')).toHaveText('Plan ready');
});

test('warnings call a parameter by the label of its control, and many of them fold', async ({ page }) => {
  await page.goto('./?src=');
  // A slice at one height with gaps in its walls: its unit, its height and its gaps are all guessed.
  const gappy = roomCsv(0.02)
    .split('\n')
    .filter((line, i) => {
      const [x, y, z] = line.split(',').map(Number);
      return i === 0 || (z === 1 && !(y === 0 && x > 2 && x < 3.2) && !(x === 0 && y > 2 && y < 3));
    });
  await dropFile(page, 'gappy.csv', gappy.join('\n'));
  await expectReady(page);
  const warnings = page.getByRole('region', { name: 'Warnings' });
  await expect(warnings).toBeVisible();
  const more = warnings.getByRole('button', { name: /^Show \d+ more$/ });
  await expect(warnings.getByRole('listitem')).toHaveCount(2);
  await more.click();
  expect(await warnings.getByRole('listitem').count()).toBeGreaterThan(2);
  await expect(warnings).toContainText('“Bridge gaps up to”');
  await expect(warnings).not.toContainText('bridgeGap');
});

test("feet hold for the levels and a band of one's own", async ({ page }) => {
  await openPlan(page);
  await page.getByRole('button', { name: 'ft', exact: true }).click();
  await expect(page.getByTestId('level-1')).toContainText(/′ \d+″ to .*per ft²/);
  await page.getByRole('spinbutton', { name: 'From, above the floor' }).fill('3');
  await page.getByRole('spinbutton', { name: 'to, above the floor' }).fill('6');
  await page.getByRole('button', { name: 'Use', exact: true }).click();
  await expectReady(page);
  const level = await page.evaluate(
    () => (document.querySelector('floor-plan') as unknown as { options: { level: string } }).options.level,
  );
  expect(level).toBe('0.914:1.829');
  await page.getByRole('button', { name: 'm', exact: true }).click();
  await expect(page.getByRole('spinbutton', { name: 'From, above the floor' })).toHaveValue('0.914');
});

test('nothing of the bars is cut off on a small laptop', async ({ page }) => {
  await page.setViewportSize({ width: 1024, height: 768 });
  await openPlan(page);
  const cut = (bars: string) =>
    page.locator(bars).evaluateAll((all) => all.map((bar) => bar.scrollWidth - bar.clientWidth));
  await page.getByTestId('cut-doors').click();
  await expect(page.getByTestId('door-words')).toBeVisible();
  expect(Math.max(...(await cut('.tools, .bar, .tool-bar')))).toBe(0);
  await page.getByRole('button', { name: 'Step by step' }).click();
  await page.getByTestId('compare').click();
  await expect(page.getByTestId('compare-table')).toBeVisible();
  const comparing = await cut('.tools, .bar, .band, .exports, .compare, .compare-choice, .compare-line');
  expect(comparing.length).toBeGreaterThan(3);
  expect(Math.max(...comparing)).toBe(0);
});

test('a level can be picked; what came before the level is kept', async ({ page }) => {
  await openPlan(page);
  const before = await page.getByTestId('plan-svg').locator('svg').innerHTML();
  for (const level of [0, 1, 2])
    await expect(page.getByTestId(`level-${level}`)).toContainText(/points.*per m²/);
  const chosen = await page.locator('.level[aria-pressed=true]').getAttribute('data-testid');
  const other = chosen === 'level-0' ? 'level-1' : 'level-0';
  await page.getByTestId(other).click();
  await expect(page.getByTestId(other)).toHaveAttribute('aria-pressed', 'true');
  await expectReady(page);
  await expect.poll(() => page.getByTestId('plan-svg').locator('svg').innerHTML()).not.toBe(before);
  expect(await stagesRun(page)).not.toContain('read');
  expect(await stagesRun(page)).toContain('level');
});

test('a parameter of the outline has the outline drawn, which is told, as is the way back', async ({
  page,
}) => {
  await openPlan(page);
  const rooms = page.getByTestId('plan-svg').getByText(/^Room \d$/);
  const words = page.getByTestId('plan-method-words');
  const status = page.locator('.status-detail');
  const method = page.getByRole('group', { name: 'Plan of' });
  await expect(status).toHaveText(/ m² · \d rooms · /);
  await expect(rooms).not.toHaveCount(0);
  await expect(words).toHaveText('Now: rooms.');
  await page.getByTestId('level-2').click();
  await expect(rooms).toHaveCount(0);
  await expect(words).toHaveText('Now: the outline, because of “Level”. Press Rooms to go back.');
  await expect(status).toHaveText(/ m² · outline · /);
  await expect(method.getByRole('button', { name: 'Auto' })).toHaveAttribute('aria-pressed', 'true');
  await method.getByRole('button', { name: 'Rooms' }).click();
  await expect(rooms).not.toHaveCount(0);
  await expect(words).toHaveText('Without effect on rooms: “Level”.');
  await method.getByRole('button', { name: 'Outline' }).click();
  await expect(rooms).toHaveCount(0);
  await page.getByRole('button', { name: 'Reset all parameters' }).click();
  await expect(rooms).not.toHaveCount(0);
  await expect(words).toHaveText('Now: rooms.');
});

test('a changed parameter runs again from its stage only, and can be undone', async ({ page }) => {
  await openPlan(page);
  await drawOutline(page);
  const drawing = () => page.getByTestId('plan-svg').locator('svg').innerHTML();
  const before = await drawing();
  await page.locator('[data-stage=plan] > summary').click();
  const thickness = page.getByRole('textbox', { name: 'Wall thickness' });
  await thickness.fill('50 cm');
  await thickness.press('Enter');
  await expect.poll(() => stagesRun(page)).toEqual(['plan', 'solid', 'sheet']);
  await expect(thickness).toHaveValue('0.5');
  await expect.poll(drawing).not.toBe(before);
  const changed = await drawing();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(thickness).toHaveValue('0.2');
  await expect.poll(drawing).toBe(before);
  await page.getByRole('group', { name: /^Floor plan/ }).press('Control+Shift+z');
  await expect.poll(drawing).toBe(changed);
});

test('what is being typed stays while the page draws itself anew', async ({ page }) => {
  await openPlan(page);
  await page.locator('[data-stage=plan] > summary').click();
  const thickness = page.getByRole('textbox', { name: 'Wall thickness' });
  await thickness.fill('50 cm');
  await page.setViewportSize({ width: 1300, height: 850 });
  const frame = () => page.evaluate(() => new Promise(requestAnimationFrame));
  for (let i = 0; i < 3; i++) await frame();
  await expect(thickness).toHaveValue('50 cm');
});

test('the number of structures brings a choice of operation for each', async ({ page }) => {
  await openPlan(page);
  await page.locator('[data-stage=secondary] > summary').click();
  const count = page.getByRole('spinbutton', { name: 'Secondary boundaries' });
  await count.fill('2');
  await count.press('Enter');
  await page.getByRole('combobox', { name: 'Structure 2' }).selectOption('add');
  await expectReady(page);
  const options = await page.evaluate(
    () => (document.querySelector('floor-plan') as unknown as { options: object }).options,
  );
  expect(options).toEqual({ secondaryCount: 2, secondaryOperation: ['subtract', 'add'] });
});

async function download(page: import('@playwright/test').Page, format: string): Promise<Buffer> {
  const [saved] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(`export-${format}`).click(),
  ]);
  return readFile(await saved.path());
}

/** Distinct colours of a picture: a blank one has few. */

test('points are coloured by colour, intensity or height, where the scan has both', async ({ page }) => {
  await page.goto('./?src=');
  await dropFile(page, 'room.csv', roomCsv());
  await expectReady(page);
  await expect(page.getByTestId('shades')).toBeHidden();
  const [, ...rows] = roomCsv().trim().split('\n');
  const coloured = rows.map((row, i) => `${row},255,0,0,${i % 256}`);
  await dropFile(page, 'red.csv', ['x,y,z,red,green,blue,intensity', ...coloured].join('\n'));
  await expect(page.getByText(/red\.csv · /)).toBeVisible();
  await expectReady(page);
  const reds = async () => redIn(page, await page.getByTestId('scene-3d').screenshot());
  await expect.poll(reds).toBeGreaterThan(50);
  for (const shade of ['intensity', 'height']) {
    await page.getByTestId('shades').selectOption(shade);
    await expect.poll(reds).toBe(0);
  }
});

/** Pixels of pure red. */
async function redIn(page: import('@playwright/test').Page, png: Buffer): Promise<number> {
  const pixels = await pixelsOf(page, png);
  return pixels.filter((word) => (word & 0xffffff) === 0xff).length;
}

async function coloursIn(page: import('@playwright/test').Page, png: Buffer): Promise<number> {
  return new Set(await pixelsOf(page, png)).size;
}

/** Pixels of a picture, blue, green and red from the highest byte but one down. */
async function pixelsOf(page: import('@playwright/test').Page, png: Buffer): Promise<number[]> {
  return page.evaluate(async (base64) => {
    const picture = await createImageBitmap(
      new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))]),
    );
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    const context = canvas.getContext('2d')!;
    context.drawImage(picture, 0, 0);
    return [...new Uint32Array(context.getImageData(0, 0, picture.width, picture.height).data.buffer)];
  }, png.toString('base64'));
}
