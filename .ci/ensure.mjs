// Installs what is missing, and nothing else: node .ci/ensure.mjs [packages] [chromium] [cli] [site]
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const tasks = {
  packages,
  chromium,
  cli: () => build('the command', 'dist/cli.js', ['--mode', 'cli']),
  site: () => build('the site', 'dist/site/index.html', []),
};

for (const name of process.argv.slice(2)) tasks[name]();

/** `npm ci` where node_modules is absent or older than the lock file. */
function packages() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (major < 20 || (major === 20 && minor < 19)) {
    fail(`Node 20.19 or newer is needed; this is ${process.versions.node}.`);
  }
  const installed = join(root, 'node_modules', '.package-lock.json');
  if (existsSync(installed) && sameVersions(installed)) return;
  note('installing packages');
  run('npm', ['ci', '--no-audit', '--no-fund']);
}

/** Whether every package the lock file needs here is installed in its version. */
function sameVersions(installed) {
  const wanted = JSON.parse(readFileSync(join(root, 'package-lock.json'), 'utf8')).packages;
  const found = JSON.parse(readFileSync(installed, 'utf8')).packages;
  return Object.entries(wanted).every(
    ([path, { version, optional }]) => path === '' || optional || found[path]?.version === version,
  );
}

/** A Chromium: an installed one, else the system package manager's, else Playwright's. */
function chromium() {
  if (findChromium()) return;
  note('no Chromium found: trying the system package manager');
  const asRoot = process.getuid?.() === 0 ? [] : ['sudo', '-n'];
  const apt = (...args) => {
    const [command, ...rest] = [...asRoot, 'apt-get', ...args];
    return tryRun(command, rest);
  };
  if (apt('update') && apt('install', '-y', '--no-install-recommends', 'chromium') && findChromium()) return;
  note("trying Playwright's own Chromium");
  if (tryRun('npx', ['playwright', 'install', '--with-deps', 'chromium-headless-shell']) && findChromium())
    return;
  if (tryRun('npx', ['playwright', 'install', 'chromium-headless-shell']) && findChromium()) return;
  fail('No Chromium could be installed. Install Chromium or Chrome, or name one in the variable CHROMIUM.');
}

function findChromium() {
  const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];
  const installed = names.flatMap((name) =>
    ['/usr/bin', '/usr/local/bin', '/snap/bin', '/opt/homebrew/bin'].map((dir) => join(dir, name)),
  );
  installed.push('/Applications/Google Chrome.app/Contents/MacOS/Google Chrome');
  installed.push('C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe');
  if (process.env.CHROMIUM) installed.unshift(process.env.CHROMIUM);
  const own = createRequire(import.meta.url)('@playwright/test').chromium.executablePath();
  return [...installed, own].find((path) => path && existsSync(path));
}

/** Builds what is absent or older than a source file. */
function build(what, file, mode) {
  const built = join(root, file);
  if (existsSync(built) && newest(join(root, 'src')) < statSync(built).mtimeMs) return;
  note(`building ${what}`);
  run('npx', ['vite', 'build', ...mode, '--logLevel', 'warn']);
}

function newest(folder) {
  const times = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => statSync(join(entry.parentPath, entry.name)).mtimeMs);
  return Math.max(...times, statSync(join(root, 'vite.config.ts')).mtimeMs);
}

/** Standard output belongs to the command that follows; installers may only talk on standard error. */
function tryRun(command, args) {
  const options = {
    cwd: root,
    stdio: ['ignore', process.stderr, 'inherit'],
    shell: process.platform === 'win32',
  };
  return spawnSync(command, args, options).status === 0;
}

function run(command, args) {
  if (!tryRun(command, args)) fail(`${command} ${args.join(' ')} failed.`);
}

function note(text) {
  process.stderr.write(`grundriss: ${text}\n`);
}

function fail(text) {
  process.stderr.write(`grundriss: environment: ${text}\n`);
  process.exit(5);
}
