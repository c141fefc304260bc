import { defineConfig } from '@playwright/test';
import { launchOptions } from './chromium.ts';

/** Two checkouts may be tested side by side; the workers inherit the choice of the first process. */
process.env.GRUNDRISS_TEST_PORT ??= String(20_000 + (process.pid % 20_000));
const PORT = Number(process.env.GRUNDRISS_TEST_PORT);

export default defineConfig({
  testDir: '.',
  outputDir: '../../test-results',
  timeout: 60_000,
  expect: { timeout: 20_000 },
  // Software rendering takes a core; side by side the tests would starve each other.
  workers: 1,
  // A loaded machine may draw late; what passes on its second try only is named flaky in the report.
  retries: process.env.CI ? 1 : 0,
  reporter: [['list']],
  use: {
    baseURL: `http://localhost:${PORT}/`,
    viewport: { width: 1440, height: 900 },
    launchOptions: launchOptions(),
  },
  webServer: {
    command: `npx vite preview --port ${PORT} --strictPort`,
    cwd: '../..',
    url: `http://localhost:${PORT}/`,
    reuseExistingServer: false,
  },
});
