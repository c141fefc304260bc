/** Scenes with exact truth, beside the project; tests on them skip where they are not. GRUNDRISS_SCENES names another folder. */
export const SCENES =
  process.env.GRUNDRISS_SCENES ?? new URL('../../shared/scenes/', import.meta.url).pathname;
