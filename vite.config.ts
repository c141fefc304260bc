import { readFileSync } from 'node:fs';
import type { Plugin, UserConfig } from 'vite';
import { defineConfig } from 'vitest/config';

const manifest = JSON.parse(readFileSync(new URL('package.json', import.meta.url), 'utf8'));

/** Left to the consumer's own build: packages of the manifest, so that nobody ships two copies of three. */
const external = [
  ...Object.keys(manifest.dependencies),
  ...Object.keys(manifest.peerDependencies),
  ...Object.keys(manifest.optionalDependencies),
].map((name) => new RegExp(`^${name}(/|$)`));

/** What the built page may do: run and show its own files, and fetch the scan a person names. */
const policy = [
  "default-src 'none'",
  // WebAssembly decompresses LAZ, and models packed by Draco or meshopt.
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "worker-src 'self' blob:",
  "connect-src 'self' https: blob: data:",
  "font-src 'self'",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** Only the built page carries the policy: the development server needs inline styles and a web socket. */
const contentSecurityPolicy: Plugin = {
  name: 'content-security-policy',
  apply: 'build',
  transformIndexHtml: () => [
    {
      tag: 'meta',
      attrs: { 'http-equiv': 'Content-Security-Policy', content: policy },
      injectTo: 'head-prepend',
    },
  ],
};

/**
 * Constants stay constants: as variables, which is the default, the engine reads and checks them anew in every loop. Not in
 * the page, where the text of an inline worker would be a constant, and there twice over.
 */
const output = { topLevelVar: false };

/** The static site around the element. Relative paths, so that it runs from any folder. */
const site: UserConfig = {
  base: './',
  plugins: [contentSecurityPolicy],
  build: { outDir: 'dist/site', target: 'es2023', license: { fileName: 'licences.md' } },
};

/** The doors of the package: library, element class, registration, worker. */
const library: UserConfig = {
  publicDir: false,
  build: {
    outDir: 'dist',
    emptyOutDir: false,
    target: 'es2023',
    minify: false,
    license: { fileName: 'licences.md' },
    lib: {
      entry: {
        index: 'src/index.ts',
        element: 'src/element/floor-plan.ts',
        define: 'src/element/define.ts',
        worker: 'src/worker/entry.ts',
      },
      formats: ['es'],
    },
    rolldownOptions: { external, output },
  },
};

/** The command: one file that needs nothing but Node and, for one filter, a canvas. */
const command: UserConfig = {
  publicDir: false,
  define: { GRUNDRISS_VERSION: JSON.stringify(manifest.version) },
  ssr: { noExternal: true, external: ['@napi-rs/canvas'] },
  build: {
    ssr: 'src/cli/main.ts',
    outDir: 'dist',
    emptyOutDir: false,
    target: 'node20',
    minify: false,
    license: { fileName: 'licences-cli.md' },
    rolldownOptions: { output: { ...output, entryFileNames: 'cli.js', codeSplitting: false } },
  },
};

const builds: Record<string, UserConfig> = { lib: library, cli: command };

export default defineConfig(({ mode }) => ({
  ...(builds[mode] ?? site),
  worker: { rolldownOptions: { output } },
  test: {
    include: ['tests/{unit,property,golden,accuracy,reproduction}/**/*.test.ts'],
    setupFiles: ['tests/seeded.ts'],
    // Its own default leaves a core to others.
    maxWorkers: '100%',
    // Modules are loaded once a worker, not once a file; none of them holds state.
    pool: 'threads',
    isolate: false,
    testTimeout: 60_000,
    hookTimeout: 60_000,
    // The CSG packages resolve to CommonJS under Node and would load a second three.
    server: { deps: { inline: ['three-csg-ts'] } },
  },
}));
