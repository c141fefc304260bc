import { existsSync } from 'node:fs';
import type { LaunchOptions } from '@playwright/test';

/** An installed browser is used where there is one; else Playwright's own. */
const PLACES = ['/usr/bin', '/usr/local/bin', '/snap/bin', '/opt/homebrew/bin'].flatMap((folder) =>
  ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'].map(
    (name) => `${folder}/${name}`,
  ),
);

/** No sandbox in a container, no chatter of the browser itself, and WebGL without a graphics card. */
const ARGUMENTS = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
];

/** How tests and bench start Chromium; the environment variable CHROMIUM names another. */
export function launchOptions(): LaunchOptions {
  const installed = [process.env.CHROMIUM ?? '', ...PLACES].find((path) => path !== '' && existsSync(path));
  return { args: ARGUMENTS, ...(installed ? { executablePath: installed } : {}) };
}
