import type { Options } from '../core/params.ts';
import type { Progress } from '../session/result.ts';
import type { PlanView } from './protocol.ts';

export interface ClientEvents {
  onProgress?(progress: Progress): void;
  onPreview?(positions: Float32Array): void;
}

/** The pipeline off the main thread. The latest request wins; an overtaken one rejects with `cancelled`. */
export declare class PlanClient {
  constructor(events?: ClientEvents, spawn?: () => Worker);
  /** Reads a scan and makes its plan. @throws FloorPlanError */
  load(source: Blob | string, name: string, options: Partial<Options>): Promise<PlanView>;
  /** Runs again with other options, from the first stage they touch. @throws FloorPlanError */
  update(options: Partial<Options>): Promise<PlanView>;
  /** Files of one write format (several for a building of several storeys). @throws FloorPlanError */
  export(format: string): Promise<readonly { name: string; blob: Blob }[]>;
  /** Stops at once; pending calls reject with `cancelled`; the last plan can still be updated and exported. */
  cancel(): void;
  /** Ends the worker for good. */
  dispose(): void;
}
