import {
  direction,
  distance,
  distanceToSegment,
  interpolate,
  signedArea,
  type XY,
} from '../../fixtures/simulator/ring.ts';
import type { StoreyFacts } from './facts.ts';

/** A stretch of wall of one thickness between a room and another room or the open air. */
export interface TrueWall {
  /** Points midway between its faces, every {@link STEP}. */
  readonly axis: readonly XY[];
  readonly thickness: number;
  readonly isOuter: boolean;
  /** Whether most of both faces was seen; an outer face never is. */
  readonly isSeen: boolean;
}

/** m */
const STEP = 0.1;
/** Faces farther apart have a space between them, no wall, m. */
const THICKEST = 0.8;
/** Thickness within one wall differs by less, m. */
const SAME = 0.01;
/** A wall that goes on turns by less than this, radians. */
const STRAIGHT_ON = (12 * Math.PI) / 180;
/** Shorter stretches are ends and corners, m. */
const SHORTEST = 0.5;
/** A face this near to a hidden stretch is hidden, m. */
const ON_STRETCH = 0.05;

interface Sample {
  readonly middle: XY;
  readonly along: XY;
  readonly thickness: number;
  /** Room on the far side; -1 is outside. */
  readonly far: number;
  readonly isSeen: boolean;
}

/** Every wall of a storey once, from the faces of its rooms and its outer face. O(samples · edges). */
export function trueWalls(truth: StoreyFacts): TrueWall[] {
  const walls: TrueWall[] = [];
  truth.rooms.forEach(([outline], room) => {
    const ring = signedArea(outline) > 0 ? outline : [...outline].reverse();
    let run: Sample[] = [];
    const close = (): void => {
      if (run.length * STEP >= SHORTEST) walls.push(wallOf(run));
      run = [];
    };
    ring.forEach((from, i) => {
      for (const sample of samplesAlong(from, ring[(i + 1) % ring.length], room, truth)) {
        const last = run[run.length - 1];
        if (sample === null || (last !== undefined && !goesOn(last, sample))) close();
        if (sample !== null) run.push(sample);
      }
    });
    close();
  });
  return walls;
}

function goesOn(a: Sample, b: Sample): boolean {
  const turn = Math.acos(Math.min(1, a.along[0] * b.along[0] + a.along[1] * b.along[1]));
  return a.far === b.far && Math.abs(a.thickness - b.thickness) < SAME && turn < STRAIGHT_ON;
}

function wallOf(run: readonly Sample[]): TrueWall {
  const thicknesses = run.map(({ thickness }) => thickness).sort((a, b) => a - b);
  const isOuter = run[0].far < 0;
  const seen = run.filter(({ isSeen }) => isSeen).length;
  return {
    axis: run.map(({ middle }) => middle),
    thickness: thicknesses[Math.floor(run.length / 2)],
    isOuter,
    isSeen: !isOuter && seen > run.length / 2,
  };
}

/** What stands behind the face from → to; null where that is an opening, no wall, or another room's wall told before. */
function samplesAlong(from: XY, to: XY, room: number, truth: StoreyFacts): (Sample | null)[] {
  const length = distance(from, to);
  const along = direction(from, to);
  const outwards: XY = [along[1], -along[0]];
  // Chords of a curve are shorter than the step: each gives one sample.
  const count = Math.max(1, Math.floor(length / STEP));
  return Array.from({ length: count }, (_, k) => {
    const face = interpolate(from, to, (k + 0.5) / count);
    const hit = behind(face, outwards, room, truth);
    if (hit === null || (hit.far >= 0 && hit.far < room)) return null;
    const back: XY = [face[0] + outwards[0] * hit.reach, face[1] + outwards[1] * hit.reach];
    const middle = interpolate(face, back, 0.5);
    if (isOpen(middle, hit.reach, truth)) return null;
    const isSeen = !isHidden(face, truth) && !isHidden(back, truth);
    return { middle, along, thickness: hit.reach, far: hit.far, isSeen };
  });
}

function behind(face: XY, way: XY, room: number, truth: StoreyFacts): { reach: number; far: number } | null {
  let best = { reach: THICKEST, far: -2 };
  const look = (ring: readonly XY[], far: number): void => {
    ring.forEach((a, i) => {
      const reach = crossing(face, way, a, ring[(i + 1) % ring.length]);
      if (reach !== null && reach < best.reach) best = { reach, far };
    });
  };
  truth.rooms.forEach(([ring], i) => {
    if (i !== room) look(ring, i);
  });
  for (const [ring] of truth.outer) look(ring, -1);
  // A wall that ends in its own room, or a pilaster, has no other side to measure.
  look(truth.rooms[room][0], -2);
  return best.far === -2 ? null : best;
}

/** Way to where a ray crosses a → b; null beside it. */
function crossing([x, y]: XY, [dx, dy]: XY, a: XY, b: XY): number | null {
  const [ex, ey] = [b[0] - a[0], b[1] - a[1]];
  const cross = dx * ey - dy * ex;
  if (Math.abs(cross) < 1e-9) return null;
  const [wx, wy] = [a[0] - x, a[1] - y];
  const reach = (wx * ey - wy * ex) / cross;
  const share = (wx * dy - wy * dx) / cross;
  return reach > 1e-4 && share >= 0 && share <= 1 ? reach : null;
}

function isOpen([x, y]: XY, thickness: number, { openings }: StoreyFacts): boolean {
  return openings.some(({ from, to }) => distanceToSegment(x, y, from, to) < thickness / 2);
}

function isHidden([x, y]: XY, { hidden }: StoreyFacts): boolean {
  return (hidden ?? []).some(([a, b]) => distanceToSegment(x, y, a, b) < ON_STRETCH);
}
