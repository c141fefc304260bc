import { join, resolve } from 'node:path';
import { build } from 'vite';
import { cacheFolder } from './clouds.ts';

/** A script of this folder, built as the command is: Vite resolves the WebAssembly that decodes LAZ. Returns its path. */
export async function bundleChild(name: 'read-child' | 'linear-child'): Promise<string> {
  const outDir = join(cacheFolder, name);
  await build({
    configFile: false,
    publicDir: false,
    logLevel: 'error',
    ssr: { noExternal: true, external: ['three', '@napi-rs/canvas'] },
    build: {
      ssr: resolve(import.meta.dirname, `${name}.ts`),
      outDir,
      emptyOutDir: true,
      target: 'node20',
      minify: false,
      rolldownOptions: {
        output: { topLevelVar: false, entryFileNames: `${name}.js`, codeSplitting: false },
      },
    },
  });
  return join(outDir, `${name}.js`);
}
