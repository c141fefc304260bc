import { kebabCase, PARAM_NAMES } from '../../src/core/params.ts';
import { ATTRIBUTES, EVENTS, METHODS, PARTS, PROPERTIES, SLOTS } from '../../src/element/contract.ts';
import type { FloorPlanElement } from '../../src/element/floor-plan.ts';
import { expect, roomCsv, test } from './plan-page.ts';

test.beforeEach(async ({ page }) => {
  await page.goto('./?src=');
  await page.evaluate(() => document.querySelector('floor-plan')?.remove());
});

test('the class offers the contract', async ({ page }) => {
  const offered = await page.evaluate(() => {
    const element = customElements.get('floor-plan')!;
    const observed = (element as unknown as { observedAttributes: string[] }).observedAttributes;
    return { observed, members: Object.getOwnPropertyNames(element.prototype) };
  });
  expect(offered.observed).toEqual(expect.arrayContaining(Object.keys(ATTRIBUTES)));
  expect(offered.observed).toEqual(expect.arrayContaining(PARAM_NAMES.map(kebabCase)));
  expect(offered.members).toEqual(
    expect.arrayContaining([...Object.keys(PROPERTIES), ...Object.keys(METHODS)]),
  );
});

test('parts and slots are where the contract says', async ({ page }) => {
  const offered = await page.evaluate(() => {
    const element = document.createElement('floor-plan');
    document.body.append(element);
    const names = (attribute: string) =>
      [...element.shadowRoot!.querySelectorAll(`[${attribute}]`)].map((node) => node.getAttribute(attribute));
    return {
      parts: names('part'),
      slots: [...element.shadowRoot!.querySelectorAll('slot')].map(({ name }) => name),
    };
  });
  expect([...new Set(offered.parts)].sort()).toEqual(Object.keys(PARTS).sort());
  expect([...new Set(offered.slots)].sort()).toEqual(Object.keys(SLOTS).sort());
});

test('a page gives the worker; where it cannot be made, the one inside serves', async ({ page }) => {
  const made = await page.evaluate(async (csv) => {
    const element = document.createElement('floor-plan') as FloorPlanElement;
    let asked = 0;
    element.spawnWorker = () => {
      asked++;
      throw new DOMException('refused', 'SecurityError');
    };
    document.body.append(element);
    const plan = await element.load(new File([csv], 'room.csv'));
    return { asked, storeys: plan.storeys.length };
  }, roomCsv());
  expect(made).toEqual({ asked: 1, storeys: 1 });
});

test('a wrong address is an error that is shown', async ({ page }) => {
  const told = await page.evaluate(async () => {
    const element = document.createElement('floor-plan') as FloorPlanElement;
    document.body.append(element);
    const rejected = await element.load('http://[').catch((error) => error.code);
    return { rejected, state: element.state };
  });
  expect(told).toEqual({ rejected: 'input/unreadable', state: 'failed' });
});

test('a plan outlives its place in the page: moved or taken out, it still exports and changes', async ({
  page,
}) => {
  const seen = await page.evaluate(async (csv) => {
    const element = document.createElement('floor-plan') as FloorPlanElement;
    document.body.append(element);
    const loading = element.load(new File([csv], 'room.csv')).catch((error) => error.code);
    document.querySelector('main, body')!.append(element);
    const overtaken = await loading;
    await new Promise((resolve) => element.addEventListener('load', resolve, { once: true }));
    element.remove();
    document.body.append(element);
    const svg = await (await element.export('svg')).text();
    const changed = new Promise((resolve) =>
      element.addEventListener('plan-change', resolve, { once: true }),
    );
    element.options = { wallThickness: 0.4 };
    await changed;
    return { overtaken, svg: svg.slice(0, 200), thickness: element.plan!.options.wallThickness };
  }, roomCsv());
  expect(seen.overtaken).toBe('cancelled');
  expect(seen.svg).toContain('<svg');
  expect(seen.thickness).toBe(0.4);
});

test('load, export, events and states', async ({ page }) => {
  const seen = await page.evaluate(
    async ([csv, names]) => {
      const element = document.createElement('floor-plan') as FloorPlanElement;
      const events: string[] = [];
      for (const name of names)
        element.addEventListener(name, () => events.at(-1) !== name && events.push(name));
      document.body.append(element);
      const states = [element.state];
      const promise = element.load(new File([csv], 'room.csv'));
      states.push(element.state);
      const plan = await promise;
      states.push(element.state);
      const json = JSON.parse(await (await element.export('json')).text());
      const failed = await element.load(new File(['no cloud'], 'x.ply')).catch((error) => error.code);
      states.push(element.state);
      return {
        events,
        states,
        version: json.version,
        same: plan === element.plan,
        failed,
        error: element.error?.message,
      };
    },
    [roomCsv(), Object.keys(EVENTS)] as const,
  );
  expect(seen.states).toEqual(['empty', 'loading', 'ready', 'failed']);
  expect(seen.events).toEqual(['progress', 'plan-change', 'load', 'progress', 'error']);
  expect(seen.version).toBe(1);
  expect(seen.same).toBe(true);
  expect(seen.failed).toMatch(/^input\//);
  expect(seen.error).toBeTruthy();
});

test('every parameter is an attribute; a wrong value is an error that names it', async ({ page }) => {
  const given = await page.evaluate(() => {
    const element = document.createElement('floor-plan') as FloorPlanElement;
    element.setAttribute('wall-thickness', '0.35');
    element.setAttribute('floor-slab', 'false');
    element.setAttribute('secondary-operation', 'add,subtract');
    document.body.append(element);
    const { options } = element;
    element.removeAttribute('floor-slab');
    element.setAttribute('wall-thickness', 'thick');
    return { options, after: element.options, error: element.error?.message };
  });
  expect(given.options).toEqual({
    wallThickness: 0.35,
    floorSlab: false,
    secondaryOperation: ['add', 'subtract'],
  });
  expect(given.after).toEqual({ wallThickness: 0.35, secondaryOperation: ['add', 'subtract'] });
  expect(given.error).toContain('wallThickness');
});

test('properties set before the class was known count', async ({ page }) => {
  const options = await page.evaluate(() => {
    const element = document.createElement('floor-plan') as FloorPlanElement;
    Object.defineProperty(element, 'options', { value: { seed: 7 }, configurable: true, writable: true });
    document.body.append(element);
    return element.options;
  });
  expect(options).toEqual({ seed: 7 });
});

test('forty mounts leave no worker and no graphics context behind', async ({ page }) => {
  test.setTimeout(240_000);
  const warnings: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'warning') warnings.push(message.text());
  });
  await page.evaluate(async (csv) => {
    for (let i = 0; i < 40; i++) {
      const element = document.createElement('floor-plan') as FloorPlanElement;
      document.body.append(element);
      await element.load(new File([csv], 'room.csv'));
      // The model opens after the plan; every other mount leaves before it has.
      while (i % 2 === 0 && !element.shadowRoot!.querySelector('.surface canvas')) {
        await new Promise(requestAnimationFrame);
      }
      element.remove();
    }
  }, roomCsv(0.1));
  await expect.poll(() => page.workers().length).toBe(0);
  expect(warnings.filter((text) => /too many active webgl/i.test(text))).toEqual([]);
});

test('a removed element cancels its run; put back, it shows its plan again', async ({ page }) => {
  const outcome = await page.evaluate(async (csv) => {
    const element = document.createElement('floor-plan') as FloorPlanElement;
    document.body.append(element);
    await element.load(new File([csv], 'room.csv'));
    const running = element.load(new File([csv], 'again.csv')).catch((error) => error.code);
    element.remove();
    const code = await running;
    document.body.append(element);
    await new Promise((resolve) => setTimeout(resolve, 300));
    const isShown = element.shadowRoot!.querySelector('[data-testid=plan-svg] svg') !== null;
    const bytes = (await element.export('geojson')).size;
    return { code, isShown, state: element.state, bytes };
  }, roomCsv(0.1));
  expect(outcome).toMatchObject({ code: 'cancelled', isShown: true, state: 'ready' });
  expect(outcome.bytes).toBeGreaterThan(10);
});

test('a poster is shown until the first plan is there', async ({ page }) => {
  const poster = page.locator('.poster');
  await page.evaluate(() => {
    const element = document.createElement('floor-plan');
    element.setAttribute('poster', 'icon.svg');
    document.body.append(element);
  });
  await expect(poster).toBeVisible();
  await page.evaluate(async (csv) => {
    await (document.querySelector('floor-plan') as FloorPlanElement).load(new File([csv], 'room.csv'));
  }, roomCsv(0.1));
  await expect(poster).toBeHidden();
});
