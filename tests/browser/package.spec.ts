import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { build, type PreviewServer, preview } from 'vite';
import type { FloorPlanElement } from '../../src/element/floor-plan.ts';
import { test as base, expect, roomCsv } from './plan-page.ts';

const root = resolve(import.meta.dirname, '../..');
/** Within the checkout, so that the packages the library leaves to its consumer are found. */
const consumer = join(root, '.cache/consumer');

/** A page of somebody else's, made with the packed package and a bundler. */
const test = base.extend<object, { address: string }>({
  address: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the names of the fixtures from a pattern
    async ({}, use) => {
      const server = await serveConsumer();
      await use(server.resolvedUrls!.local[0]);
      await server.close();
    },
    { scope: 'worker' },
  ],
  baseURL: async ({ address }, use) => use(address),
});

async function serveConsumer(): Promise<PreviewServer> {
  const installed = join(consumer, 'node_modules/grundriss');
  rmSync(consumer, { recursive: true, force: true });
  mkdirSync(installed, { recursive: true });
  const [{ filename }] = JSON.parse(
    execFileSync('npm', ['pack', '--json', '--ignore-scripts', '--pack-destination', consumer], {
      cwd: root,
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'ignore'],
    }),
  );
  execFileSync('tar', ['-xzf', join(consumer, filename), '-C', installed, '--strip-components=1']);
  const body = '<floor-plan style="display: block; height: 600px" controls></floor-plan>';
  writeFileSync(
    join(consumer, 'index.html'),
    `<!doctype html><link rel="icon" href="data:,"><title>Consumer</title>${body}<script type="module" src="./main.js"></script>`,
  );
  writeFileSync(join(consumer, 'main.js'), "import 'grundriss/element/define';\n");
  const options = { root: consumer, configFile: false, logLevel: 'error' } as const;
  await build(options);
  return preview({ ...options, preview: { port: 4188 } });
}

test('the packed element works in an app made with a bundler, in a worker of its own', async ({ page }) => {
  await page.goto('./');
  const made = await page.evaluate(async (csv) => {
    await customElements.whenDefined('floor-plan');
    const element = document.querySelector('floor-plan') as FloorPlanElement;
    const plan = await element.load(new File([csv], 'room.csv'));
    return { storeys: plan.storeys.length, svg: await (await element.export('svg')).text() };
  }, roomCsv());
  expect(made.storeys).toBe(1);
  expect(made.svg).toContain('<svg');
  await expect(page.getByTestId('plan-svg')).toBeVisible();
  // One makes the plan, one draws the model.
  await expect.poll(() => page.workers().length).toBe(2);
});

test('the packed element decompresses LAZ', async ({ page }) => {
  await page.goto('./');
  const laz = readFileSync(join(root, 'fixtures/foreign/room.laz')).toString('base64');
  const format = await page.evaluate(async (base64) => {
    await customElements.whenDefined('floor-plan');
    const element = document.querySelector('floor-plan') as FloorPlanElement;
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    return (await element.load(new File([bytes], 'room.laz'))).source.format;
  }, laz);
  expect(format).toBe('laz');
});
