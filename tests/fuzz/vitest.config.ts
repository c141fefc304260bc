import { defineConfig } from 'vitest/config';
import type { FuzzTask } from './task.ts';

/** Handed over by run.ts. */
const tasks: readonly FuzzTask[] = JSON.parse(process.env.FUZZ_TASKS ?? '[]');

/** A project a format: each has a process of its own, whose memory and end are its own. */
export default defineConfig({
  test: {
    maxWorkers: 2,
    reporters: ['default'],
    coverage: {
      provider: 'v8',
      include: ['src/read/**/*.ts'],
      reporter: ['json-summary'],
      reportsDirectory: '.cache/fuzz/coverage',
      reportOnFailure: true,
    },
    projects: tasks.map((task) => ({
      test: {
        name: task.format,
        include: ['tests/fuzz/format.fuzz.ts'],
        provide: { task },
        pool: 'forks',
        testTimeout: 0,
      },
    })),
  },
});
