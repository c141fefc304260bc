import type { Pose } from '../../fixtures/simulator/pose.ts';
import type { ScanOptions } from '../../fixtures/simulator/scan.ts';
import {
  bentSketch,
  corridorSketch,
  crossingSketch,
  curvedSketch,
  hallSketch,
  homeSketch,
  officeSketch,
  oneRoomSketch,
  openPlanSketch,
  type Sketch,
} from '../../fixtures/simulator/sketches.ts';
import type { Variety } from '../../fixtures/simulator/varied-buildings.ts';

type Range = readonly [low: number, high: number];

/** A kind of building and how it is scanned; a seed makes a building of it. */
export interface Recipe {
  readonly sketch: Sketch;
  readonly variety: Variety;
  readonly isMobile?: boolean;
  /** Glass in the windows, and a garden behind them. */
  readonly hasGarden?: boolean;
  readonly scan?: Partial<Omit<ScanOptions, 'seed' | 'noise' | 'voxel' | 'mostRays'>> & {
    readonly noiseMm?: Range;
    readonly voxelCm?: Range;
  };
  readonly pose?: Partial<Pick<Pose, 'unit' | 'up'>> & {
    readonly isUtm?: boolean;
    readonly tiltDeg?: number;
  };
}

const DEGREE = Math.PI / 180;

/** Ceilings low enough for cupboards to hide a wall. */
const LOW: Range = [2.4, 2.5];
const cupboards = (share: number) => ({ share, heights: [2, 2.4] as const });
const fullCupboards = (share: number) => ({ share, heights: [2.3, 2.4] as const });

const OFFICE_STYLE = {
  doorWidths: [0.9, 1, 1.5],
  windowWidths: [1.2, 1.8, 2.4],
  passages: 0,
  extraDoors: 0,
} as const;
/** Front to back through wide doors and passages. */
const OPEN_STYLE = { doorWidths: [0.9, 1.4, 1.8], passages: 1, extraDoors: 0.6 } as const;

/** One row a kind; two seeds of each make the corpus. */
export const RECIPES: Readonly<Record<string, Recipe>> = {
  // Little noise, little furniture.
  home: { sketch: homeSketch('rect'), variety: { clutter: 0.3, details: { pilasters: 1 } } },
  'home-l-feet-tilted': {
    sketch: homeSketch('L'),
    variety: { clutter: 0.3, details: { niches: 2 } },
    pose: { unit: 'ft', tiltDeg: 2 },
  },
  'home-u-utm': {
    sketch: homeSketch('U', { alcoves: 1 }),
    variety: { clutter: 0.2 },
    pose: { isUtm: true },
  },
  'home-t-y-up-millimetres': {
    sketch: homeSketch('T'),
    variety: { clutter: 0.3, details: { wallEnds: 1 } },
    pose: { unit: 'mm', up: 'y' },
  },
  'home-skew': { sketch: homeSketch('rect', { skew: 0.05 }), variety: { clutter: 0.15 } },
  'home-skew-u': {
    sketch: homeSketch('U', { skew: 0.035 }),
    variety: { clutter: 0.3, details: { pilasters: 2 } },
    scan: { noiseMm: [8, 10] },
  },
  'home-alcoves': {
    sketch: homeSketch('rect', { alcoves: 3 }),
    variety: { clutter: 0.2, details: { niches: 3, pilasters: 2 } },
    scan: { noiseMm: [3, 5], voxelCm: [1, 2] },
  },
  'home-shafts': {
    sketch: homeSketch('L'),
    variety: { clutter: 0.2, details: { cornerShafts: 2, wallEnds: 1, shafts: 1 } },
    scan: { voxelCm: [4, 5] },
  },
  'wing-30': { sketch: bentSketch(30 * DEGREE, 'home'), variety: { clutter: 0.3 } },
  'wing-45': {
    sketch: bentSketch(45 * DEGREE, 'home'),
    variety: { clutter: 0.2, details: { pilasters: 1 } },
    scan: { noiseMm: [3, 6] },
  },
  office: {
    sketch: officeSketch,
    variety: {
      clutter: 0.3,
      style: OFFICE_STYLE,
      lowered: 0.3,
      heights: [2.8, 3.2],
      details: { roundColumns: 2, squareColumns: 1 },
    },
    scan: { noiseMm: [6, 10], voxelCm: [4, 5] },
  },
  crossing: {
    sketch: crossingSketch,
    variety: { clutter: 0.3, style: OFFICE_STYLE, heights: [2.6, 3] },
    scan: { voxelCm: [4, 5] },
  },
  corridor: { sketch: corridorSketch, variety: { clutter: 0.3, details: { pilasters: 2 } } },
  'round-hall': {
    sketch: curvedSketch('outer'),
    variety: { clutter: 0.3, heights: [2.9, 3.4], details: { roundColumns: 2 } },
  },
  'curved-inner': {
    sketch: curvedSketch('inner'),
    variety: { clutter: 0.2, details: { squareColumns: 2 } },
    scan: { noiseMm: [3, 6] },
  },
  'hall-columns': {
    sketch: hallSketch,
    variety: {
      clutter: 0.2,
      heights: [3.2, 4],
      style: OFFICE_STYLE,
      details: { squareColumns: 4, roundColumns: 2, shafts: 1 },
    },
    scan: { voxelCm: [4, 5] },
  },
  house: {
    sketch: homeSketch('rect'),
    variety: { storeys: 2, clutter: 0.3 },
    scan: { voxelCm: [4, 5] },
  },
  'one-room': {
    sketch: oneRoomSketch,
    variety: { clutter: 0.3, details: { niches: 1, pilasters: 1, squareColumns: 1 } },
    scan: { voxelCm: [1, 2] },
  },
  'open-plan': {
    sketch: openPlanSketch,
    variety: { clutter: 0.3, style: OPEN_STYLE, details: { wallEnds: 1, squareColumns: 1 } },
  },
  'home-no-ceiling': {
    sketch: homeSketch('T'),
    variety: { clutter: 0.2 },
    scan: { ceilings: false },
  },

  // About 2 cm of noise, furnished, some walls hidden.
  'home-mobile': {
    sketch: homeSketch('rect'),
    variety: { clutter: 1, heights: LOW, tall: cupboards(0.3) },
    isMobile: true,
    scan: { noiseMm: [16, 20] },
  },
  'home-l-cupboards': {
    sketch: homeSketch('L', { alcoves: 1 }),
    variety: { clutter: 0.8, heights: LOW, tall: fullCupboards(0.22) },
    scan: { noiseMm: [15, 20] },
  },
  'home-u-furnished-x-up': {
    sketch: homeSketch('U'),
    variety: { clutter: 1, heights: LOW, tall: fullCupboards(0.2), lowered: 0.2 },
    scan: { noiseMm: [15, 20], voxelCm: [3, 5] },
    pose: { up: 'x', unit: 'ft' },
  },
  'home-skew-cupboards': {
    sketch: homeSketch('T', { skew: 0.04 }),
    variety: { clutter: 0.8, heights: LOW, tall: fullCupboards(0.22), details: { pilasters: 2 } },
    scan: { noiseMm: [15, 20] },
  },
  'wing-30-office': {
    sketch: bentSketch(30 * DEGREE, 'office'),
    variety: {
      clutter: 0.8,
      style: OFFICE_STYLE,
      heights: [2.7, 2.9],
      tall: fullCupboards(0.2),
      lowered: 0.4,
    },
    scan: { noiseMm: [15, 20], voxelCm: [4, 5] },
  },
  'office-mobile': {
    sketch: officeSketch,
    variety: {
      clutter: 0.8,
      style: OFFICE_STYLE,
      heights: [2.5, 2.8],
      tall: fullCupboards(0.2),
      lowered: 0.5,
      details: { squareColumns: 3 },
    },
    isMobile: true,
    scan: { noiseMm: [18, 22], voxelCm: [4, 5] },
  },
  'crossing-suspended': {
    sketch: crossingSketch,
    variety: {
      clutter: 0.8,
      style: OFFICE_STYLE,
      heights: [2.55, 2.75],
      tall: fullCupboards(0.22),
      lowered: 0.8,
      details: { roundColumns: 1 },
    },
    scan: { noiseMm: [15, 20], voxelCm: [4, 6] },
  },
  'open-plan-passages': {
    sketch: openPlanSketch,
    variety: {
      clutter: 1,
      style: OPEN_STYLE,
      heights: LOW,
      tall: fullCupboards(0.2),
      details: { wallEnds: 1 },
    },
    scan: { noiseMm: [15, 20] },
  },
  'curved-furnished': {
    sketch: curvedSketch('both'),
    variety: { clutter: 0.8, heights: LOW, tall: fullCupboards(0.2), details: { roundColumns: 2 } },
    scan: { noiseMm: [15, 20] },
  },
  'house-furnished': {
    sketch: homeSketch('L'),
    variety: { storeys: 2, clutter: 0.8, heights: LOW, tall: fullCupboards(0.2) },
    scan: { noiseMm: [15, 20], voxelCm: [4, 5] },
    pose: { tiltDeg: 1 },
  },
  'one-room-cupboards': {
    sketch: oneRoomSketch,
    variety: { clutter: 1, heights: LOW, tall: fullCupboards(0.22), details: { roundColumns: 1 } },
    scan: { noiseMm: [15, 20], voxelCm: [1.5, 3] },
    pose: { unit: 'mm' },
  },

  // Harder: more noise, more of the walls hidden, coarser, or a storeroom.
  'home-storeroom-mobile': {
    sketch: homeSketch('rect', { alcoves: 1 }),
    variety: { clutter: 1.6, heights: LOW, tall: fullCupboards(0.45) },
    isMobile: true,
    scan: { noiseMm: [25, 30] },
  },
  'home-hidden': {
    sketch: homeSketch('L'),
    variety: { clutter: 0.6, heights: LOW, tall: fullCupboards(0.5), style: { windows: 0.4 } },
    scan: { noiseMm: [8, 12], stationsPerRoom: 1 },
  },
  'corridor-coarse': {
    sketch: corridorSketch,
    variety: { clutter: 1, heights: LOW, tall: fullCupboards(0.2), details: { pilasters: 2 } },
    scan: { noiseMm: [22, 28], voxelCm: [7, 8] },
  },
  'office-no-ceiling-mobile': {
    sketch: officeSketch,
    variety: {
      clutter: 1.2,
      style: OFFICE_STYLE,
      heights: [2.5, 2.7],
      tall: fullCupboards(0.4),
      details: { roundColumns: 2, shafts: 1 },
    },
    isMobile: true,
    scan: { noiseMm: [22, 28], voxelCm: [4, 6], ceilings: false },
  },
  'wing-45-hidden': {
    sketch: bentSketch(45 * DEGREE, 'home'),
    variety: { clutter: 1, heights: LOW, tall: fullCupboards(0.36), style: { windows: 0.5 } },
    scan: { noiseMm: [22, 30], voxelCm: [5, 7] },
    pose: { unit: 'ft', tiltDeg: 2.5 },
  },

  // Seen from inside: what lies outside.
  'home-garden': { sketch: homeSketch('T'), variety: { clutter: 0.3 }, hasGarden: true },
  'home-garden-furnished': {
    sketch: homeSketch('L'),
    variety: { clutter: 0.8, heights: LOW, tall: fullCupboards(0.2) },
    scan: { noiseMm: [15, 20] },
    pose: { tiltDeg: 3 },
    hasGarden: true,
  },
};
