import { expect, openPlan, test } from './plan-page.ts';

/** Ways in which an environment refuses a worker: a cross-origin address throws, a strict policy only fires an error. */
const refusals = {
  'throws at once': () => {
    globalThis.Worker = class {
      constructor() {
        throw new DOMException('refused', 'SecurityError');
      }
    } as unknown as typeof Worker;
  },
  'fires an error without a message': () => {
    globalThis.Worker = class extends EventTarget {
      onerror: ((event: Event) => void) | null = null;
      constructor() {
        super();
        setTimeout(() => {
          const event = new Event('error', { cancelable: true });
          this.onerror?.(event);
          this.dispatchEvent(event);
        });
      }
      postMessage(): void {}
      terminate(): void {}
    } as unknown as typeof Worker;
  },
};

for (const [how, refuse] of Object.entries(refusals)) {
  test(`where a worker ${how}, the page makes the plan itself and says so`, async ({ page }) => {
    await page.addInitScript(refuse);
    await openPlan(page);
    expect(await page.getByTestId('plan-svg').locator('path').count()).toBeGreaterThan(1);
    await expect(page.getByText(/No worker could be started/)).toBeVisible();
    expect(page.workers()).toHaveLength(0);
  });
}

test('where the code for the page itself does not come either, that is told and not waited for', async ({
  page,
  misdeeds,
}) => {
  await page.addInitScript(refusals['throws at once']);
  await page.route(/\/serve-[^/]+\.js$/, (route) => route.abort());
  await page.goto('./');
  await expect(page.getByTestId('error')).toContainText('makes plans could not be fetched');
  await expect(page.getByTestId('status')).toHaveText('That did not work');
  // The browser's own word on the request.
  await expect.poll(() => misdeeds.errors).toEqual(['Failed to load resource: net::ERR_FAILED']);
  misdeeds.errors.length = 0;
});
