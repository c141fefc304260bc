/** One step from bytes to solid; drives order, progress labels, cache keys, the app's rail, bench and golden names. */
export interface StageRow {
  readonly label: string;
  /** What the stage does, one sentence. */
  readonly doc: string;
  /** Paper section or "ours". */
  readonly source: string;
  /** Share of a usual run's time, for progress; they sum to 1. */
  readonly share: number;
  /** It makes the outline and what stands in it, which a plan of rooms leaves aside. */
  readonly isOfOutline?: true;
}

export const STAGES = {
  read: {
    label: 'Read',
    doc: 'Bytes become points, thinned on a voxel lattice.',
    source: 'ours',
    share: 0.35,
  },
  frame: {
    label: 'Orient',
    doc: 'The cloud is turned upright and levelled; its unit is judged.',
    source: '[Stojanovic19] §3',
    share: 0.09,
  },
  crop: {
    label: 'Crop',
    doc: 'Points outside the crop box, where there is one, are left out.',
    source: 'ours',
    share: 0.01,
  },
  outliers: {
    label: 'Clean',
    doc: 'Stray points far from every dense cluster go.',
    source: '[Stojanovic19] §3',
    share: 0.1,
  },
  level: {
    label: 'Level',
    doc: 'Three height levels are measured and one is chosen; floor and ceiling are left out.',
    source: '[Stojanovic19] §3',
    share: 0.05,
    isOfOutline: true,
  },
  slice: {
    label: 'Slice',
    doc: 'The level is sampled uniformly and seen from above.',
    source: '[Stojanovic19] §4',
    share: 0.05,
    isOfOutline: true,
  },
  boundary: {
    label: 'Outline',
    doc: 'The primary boundary: a concave hull around the slice.',
    source: '[Stojanovic19] §3',
    share: 0.1,
    isOfOutline: true,
  },
  regularise: {
    label: 'Straighten',
    doc: 'Radial distance, Douglas-Peucker and Visvalingam passes simplify the outline; its corners are restored.',
    source: '[Stojanovic19] §3',
    share: 0.02,
    isOfOutline: true,
  },
  secondary: {
    label: 'Structures',
    doc: 'Secondary boundaries: columns, shafts and cubicles inside the outline.',
    source: '[Stojanovic19] §3.1',
    share: 0.05,
    isOfOutline: true,
  },
  rooms: {
    label: 'Rooms',
    doc: 'Storeys, rooms, walls with two faces, doors, windows and columns, from planes that reach the ceiling.',
    source: 'ours',
    share: 0.1,
  },
  plan: {
    label: 'Plan',
    doc: 'Rooms and walls, or outlines drawn with a pen, become the floor plan.',
    source: '[Stojanovic19] §3',
    share: 0.03,
  },
  solid: {
    label: 'Model',
    doc: 'Walls are extruded and secondary boundaries cut out or added: the 3D model.',
    source: '[Stojanovic19] §3.2',
    share: 0.04,
  },
  sheet: {
    label: 'Drawing',
    doc: 'Each storey is drawn on a sheet of paper, to scale, with dimensions and a title block.',
    source: '[Stojanovic19] §3.2',
    share: 0.01,
  },
} as const satisfies Record<string, StageRow>;

export type StageName = keyof typeof STAGES;

export const STAGE_NAMES = Object.keys(STAGES) as readonly StageName[];

/** Stages of the paper's chain from the level on. */
export const OUTLINE_STAGES = STAGE_NAMES.filter((name) => (STAGES[name] as StageRow).isOfOutline);
