import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import { chromium } from '@playwright/test';
import { launchOptions } from '../browser/chromium.ts';
import { cloudFile } from './clouds.ts';
import type { Figure } from './table.ts';

const POINTS = 1_000_000;
const PORT = 4199;

/** 1 M points dropped on the built page: time to the plan on screen, longest task of the page's thread. */
export async function benchPage(): Promise<readonly Figure[]> {
  const { path } = await cloudFile(POINTS, 'ply');
  const server = spawn('npx', ['vite', 'preview', '--port', String(PORT), '--strictPort'], {
    detached: true,
  });
  const browser = await chromium.launch(launchOptions());
  try {
    await untilServed(server);
    const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
    await page.goto(`http://localhost:${PORT}/`);
    await page.getByTestId('plan-svg').locator('svg').waitFor();
    await page.evaluate(() => {
      const state = globalThis as unknown as { longest: number };
      state.longest = 0;
      new PerformanceObserver((list) => {
        for (const { duration } of list.getEntries()) state.longest = Math.max(state.longest, duration);
      }).observe({ entryTypes: ['longtask'] });
    });
    const start = performance.now();
    await page.getByTestId('file-input').setInputFiles(path);
    await page
      .locator(`[data-testid="plan-svg"] svg[data-source="home-${POINTS}.ply"]`)
      .waitFor({ timeout: 60_000 });
    const ms = performance.now() - start;
    const longest = await page.evaluate(() => (globalThis as unknown as { longest: number }).longest);
    return [
      { name: '1 M points PLY → plan on screen', value: ms / 1000, unit: 's' },
      { name: 'longest task of the page', value: longest, unit: 'ms', note: '0: none over 50 ms' },
    ];
  } finally {
    await browser.close();
    if (server.pid) process.kill(-server.pid);
  }
}

async function untilServed(server: ChildProcess): Promise<void> {
  for (;;) {
    const [data] = await once(server.stdout!, 'data');
    if (String(data).includes('http')) return;
  }
}
