import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['tests/{unit,property,golden,accuracy}/**/*.test.ts'],
    testTimeout: 60_000,
    // The CSG packages resolve to CommonJS under Node and would load a second three.
    server: { deps: { inline: ['three-csg-ts'] } },
  },
});
