import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test as base, expect, type Page } from '@playwright/test';
import type { FloorPlanElement } from '../../src/element/floor-plan.ts';

/** What the page did that nobody asked for. */
export interface Misdeeds {
  /** Uncaught errors and console errors. */
  readonly errors: string[];
  /** Violations of the content security policy. */
  readonly violations: string[];
  /** Requests beyond the page's own origin. */
  readonly foreign: string[];
}

/** Every test watches the page: an error, a policy violation or a foreign request fails it. */
export const test = base.extend<{ misdeeds: Misdeeds }>({
  misdeeds: [
    async ({ page, baseURL }, use) => {
      const misdeeds: Misdeeds = { errors: [], violations: [], foreign: [] };
      page.on('pageerror', (error) => misdeeds.errors.push(error.message));
      page.on('console', (message) => {
        if (message.type() === 'error') misdeeds.errors.push(message.text());
      });
      page.on('request', (request) => {
        const url = request.url();
        const isOwn = url.startsWith(baseURL!) || /^(blob|data):/.test(url);
        if (!isOwn) misdeeds.foreign.push(url);
      });
      await page.exposeFunction('reportViolation', (text: string) => misdeeds.violations.push(text));
      await page.addInitScript(() => {
        document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) => {
          const report = (globalThis as unknown as { reportViolation(text: string): void }).reportViolation;
          report(`${violatedDirective} ${blockedURI}`);
        });
      });
      await use(misdeeds);
      expect(misdeeds).toEqual({ errors: [], violations: [], foreign: [] });
    },
    { auto: true },
  ],
});

export { expect };

/** Opens the page and waits until a plan is shown. */
export async function openPlan(page: Page, query = ''): Promise<void> {
  await page.goto(`./${query}`);
  await expectReady(page);
}

/** Has the plan drawn from the outline, whose walls are as thick as a parameter says and whose gaps may be doors. */
export async function drawOutline(page: Page): Promise<void> {
  const drawing = () => page.getByTestId('plan-svg').locator('svg').innerHTML();
  const ofRooms = await drawing();
  await page.locator('floor-plan').evaluate((plan) => plan.setAttribute('plan-method', 'outline'));
  await expect.poll(drawing).not.toBe(ofRooms);
  await expectReady(page);
}

export async function expectReady(page: Page): Promise<void> {
  await expect(page.getByTestId('status')).toHaveText('Plan ready', { timeout: 45_000 });
  await expect(page.getByTestId('plan-svg')).toBeAttached();
}

/** Names of the stages that ran in the last run; the others were kept from before. */
export async function stagesRun(page: Page): Promise<string[]> {
  return page
    .locator('[data-stage][data-mark=done]')
    .evaluateAll((rows) => rows.map((row) => (row as HTMLElement).dataset.stage!));
}

/** Points of an L-shaped room, 2.5 m high, with floor and ceiling, as comma-separated text: 6 × 5 m less 3 × 2 m. */
export function roomCsv(step = 0.05): string {
  const corners = [0, 0, 6, 0, 6, 3, 3, 3, 3, 5, 0, 5];
  const lines = ['x,y,z'];
  for (let i = 0; i < corners.length; i += 2) {
    const [ax, ay] = [corners[i], corners[i + 1]];
    const [bx, by] = [corners[(i + 2) % corners.length], corners[(i + 3) % corners.length]];
    const steps = Math.round(Math.hypot(bx - ax, by - ay) / step);
    for (let s = 0; s < steps; s++) {
      const [x, y] = [ax + ((bx - ax) * s) / steps, ay + ((by - ay) * s) / steps];
      for (let z = 0; z <= 2.5; z += step) lines.push(`${x.toFixed(3)},${y.toFixed(3)},${z.toFixed(3)}`);
    }
  }
  for (let x = 0; x < 6; x += 2 * step) {
    for (let y = 0; y < 5; y += 2 * step) {
      if (x < 3 || y < 3)
        lines.push(`${x.toFixed(3)},${y.toFixed(3)},0`, `${x.toFixed(3)},${y.toFixed(3)},2.5`);
    }
  }
  return lines.join('\n');
}

/** Drops a file on the page as a person does. */
export async function dropFile(page: Page, name: string, text: string): Promise<void> {
  const transfer = await page.evaluateHandle(
    ([fileName, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content], fileName));
      return data;
    },
    [name, text] as const,
  );
  const target = page.locator('floor-plan');
  await target.dispatchEvent('dragenter', { dataTransfer: transfer });
  await expect(page.getByText('Release to make a plan of this scan')).toBeVisible();
  await target.dispatchEvent('dragover', { dataTransfer: transfer });
  await target.dispatchEvent('drop', { dataTransfer: transfer });
}

/** Where a place of the plan, source coordinates, lies on the screen once the sheet is at rest: the tool's bar makes it move, a run draws it anew. */
export function onSheet(page: Page, x: number, y: number): Promise<[number, number]> {
  return page.locator('floor-plan').evaluate(
    async (element: FloorPlanElement, [px, py]) => {
      const drawing = () =>
        element.shadowRoot!.querySelector<SVGSVGElement>('[data-testid=plan-svg] svg') ?? undefined;
      const look = () => String(Object.values(drawing()?.getBoundingClientRect().toJSON() ?? {}));
      let svg = drawing();
      for (let [before, calm] = ['', 0]; calm < 4; ) {
        await new Promise((resolve) => requestAnimationFrame(resolve));
        calm = svg && svg === drawing() && look() === before ? calm + 1 : 0;
        before = look();
        svg = drawing();
      }
      const [a, b, c, d, e, f] = svg!.dataset.planToSheet!.split(' ').map(Number);
      const { planOrigin, metresPerUnit } = element.plan!.frame;
      const [qx, qy] = [(px - planOrigin[0]) * metresPerUnit, (py - planOrigin[1]) * metresPerUnit];
      const point = new DOMPoint(a * qx + c * qy + e, b * qx + d * qy + f);
      const onScreen = point.matrixTransform(svg!.getScreenCTM()!);
      return [onScreen.x, onScreen.y] as [number, number];
    },
    [x, y],
  );
}

/** What axe finds wrong with the page. */
export async function axe(page: Page): Promise<string[]> {
  const source = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
  await page.evaluate(source);
  return page.evaluate(async () => {
    const { axe: runner } = globalThis as unknown as { axe: typeof import('axe-core') };
    const { violations } = await runner.run();
    return violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html.slice(0, 160)}`));
  });
}
