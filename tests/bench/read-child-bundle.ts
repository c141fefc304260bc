import { join, resolve } from 'node:path';
import { build } from 'vite';
import { cacheFolder } from './clouds.ts';

/** As the command is built: Vite resolves the WebAssembly that decodes LAZ. */
export async function bundleChild(): Promise<string> {
  const outDir = join(cacheFolder, 'child');
  await build({
    configFile: false,
    publicDir: false,
    logLevel: 'error',
    ssr: { noExternal: true, external: ['three'] },
    build: {
      ssr: resolve(import.meta.dirname, 'read-child.ts'),
      outDir,
      emptyOutDir: true,
      target: 'node20',
      minify: false,
      rolldownOptions: {
        output: { topLevelVar: false, entryFileNames: 'read-child.js', codeSplitting: false },
      },
    },
  });
  return join(outDir, 'read-child.js');
}
