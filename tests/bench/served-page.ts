import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFile } from 'node:fs/promises';
import { type Browser, chromium, type Page } from '@playwright/test';
import { launchOptions } from '../browser/chromium.ts';

const PORT = 4199;

/** The built page in Chromium, its sample shown, watched for long tasks. */
export async function withPage<T>(work: (page: Page, browser: Browser) => Promise<T>): Promise<T> {
  const words = ['vite', 'preview', '--port', String(PORT), '--strictPort'];
  const server = spawn('npx', words, { detached: true });
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
      const input = document.createElement('input');
      Object.assign(input, { type: 'file', id: 'bench' });
      document.body.append(input);
    });
    return await work(page, browser);
  } finally {
    await browser.close();
    if (server.pid) process.kill(-server.pid);
  }
}

/** ms; `raw` of merely reading the file by `stream()` in a worker, as we read it; `longest` is the page's longest task, 0 where none is over 50 ms. */
export interface PageRun {
  readonly raw: number;
  readonly read: number;
  readonly whole: number;
  readonly longest: number;
}

/** What the worker does that merely reads. */
const RAW_READER = `onmessage = async ({ data: file }) => {
  const start = performance.now();
  const reader = file.stream().getReader();
  while (!(await reader.read()).done);
  postMessage(performance.now() - start);
}`;
const RAW_RUNS = 3;

/** The median of some runs: the cache of a disk is cold at first. */
async function readRaw(page: Page): Promise<number> {
  const times: number[] = [];
  for (let i = 0; i < RAW_RUNS; i++) {
    times.push(
      await page.evaluate(async (script) => {
        const file = document.querySelector<HTMLInputElement>('#bench')!.files![0];
        const worker = new Worker(URL.createObjectURL(new Blob([script])));
        const answer = new Promise<number>((resolve, reject) => {
          worker.onmessage = ({ data }) => resolve(data);
          worker.onerror = () => reject(new Error('The worker that reads raw bytes failed.'));
        });
        worker.postMessage(file);
        return answer.finally(() => worker.terminate());
      }, RAW_READER),
    );
  }
  return times.sort((a, b) => a - b)[RAW_RUNS >> 1];
}

/** Merely reads a file, then makes its plan. */
export async function loadInPage(page: Page, path: string): Promise<PageRun> {
  // A path, so that the browser reads from the disk and nothing is held in memory.
  await page.locator('#bench').setInputFiles(path);
  const raw = await readRaw(page);
  const rest = await page.evaluate(async () => {
    const state = globalThis as unknown as { longest: number };
    const file = document.querySelector<HTMLInputElement>('#bench')!.files![0];
    const element = document.querySelector('floor-plan')! as HTMLElement & {
      load(file: File): Promise<unknown>;
    };
    state.longest = 0;
    let read = 0;
    const start = performance.now();
    const done = new AbortController();
    // Inline: a named function would need what the transpiler adds to name it.
    element.addEventListener(
      'progress',
      (event) => {
        if ((event as unknown as CustomEvent).detail.stage !== 'read') read ||= performance.now() - start;
      },
      { signal: done.signal },
    );
    await element.load(file);
    done.abort();
    const whole = performance.now() - start;
    // Entries come a little later.
    await new Promise((resolve) => setTimeout(resolve, 200));
    return { read, whole, longest: state.longest };
  });
  return { raw, ...rest };
}

/** Begins to load the file last picked and cancels after a while: ms until the element lets go. */
export async function cancelInPage(page: Page, afterMs: number): Promise<number> {
  return page.evaluate(async (wait) => {
    const file = document.querySelector<HTMLInputElement>('#bench')!.files![0];
    const element = document.querySelector('floor-plan')! as HTMLElement & {
      load(file: File): Promise<unknown>;
      cancel(): void;
    };
    const ended = element.load(file).then(
      () => 'done',
      ({ code }) => code,
    );
    await new Promise((resolve) => setTimeout(resolve, wait));
    const start = performance.now();
    element.cancel();
    const end = await ended;
    if (end !== 'cancelled') throw new Error(`Expected the run to be cancelled, found ${end}.`);
    return performance.now() - start;
  }, afterMs);
}

/** Memory of the largest renderer, MB, its workers included: at most so far, and now; 0 where /proc tells none. */
export async function rendererMemory(browser: Browser): Promise<{ peak: number; now: number }> {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  let largest = { peak: 0, now: 0 };
  for (const { type, id } of processInfo) {
    const status = type === 'renderer' ? await readFile(`/proc/${id}/status`, 'utf8').catch(() => '') : '';
    const megabytes = (key: string) => Number(new RegExp(`${key}:\\s+(\\d+)`).exec(status)?.[1] ?? 0) / 1024;
    if (megabytes('VmHWM') > largest.peak) largest = { peak: megabytes('VmHWM'), now: megabytes('VmRSS') };
  }
  return largest;
}

async function untilServed(server: ChildProcess): Promise<void> {
  for (;;) {
    const [data] = await once(server.stdout!, 'data');
    if (String(data).includes('http')) return;
  }
}
