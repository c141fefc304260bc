import type { FuzzFormat } from './seeds.ts';

/** What the process of one format is to do. */
export interface FuzzTask {
  readonly format: FuzzFormat;
  readonly seed: number;
  /** Number of the first case, and how many there are. */
  readonly first: number;
  readonly cases: number;
  /** Where its report goes. */
  readonly folder: string;
}

declare module 'vitest' {
  interface ProvidedContext {
    task: FuzzTask;
  }
}
