import { turnOn } from '../../geometry/circle.ts';
import { chordTurn } from '../../geometry/ring-arcs.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { type Face, pointOn } from './face.ts';
import type { CurvedFace } from './fit-arc.ts';

/** Chords turn by no more than this at a vertex, radians: a curve is drawn in steps below 5°. */
const STEP = (4 * Math.PI) / 180;
/** A curve smaller than this is a column's or furniture's, m. */
export const SMALLEST_RADIUS = 0.6;
/** A curve is drawn on past its ends by so much, m, to meet the walls it runs into … */
const OVERLAP = 0.4;
/** … and one that is a wall for sure by as much as this, or half of it: furniture hides many a corner. */
const SURE_OVERLAP = 2.5;

/** The chords of each curved face: short straight faces, end to end, which may meet others past both ends of the curve. */
export function chordsOf(columns: HeightColumns, curved: readonly CurvedFace[]): Face[][] {
  return curved.filter(({ radius }) => radius >= SMALLEST_RADIUS).map((arc) => chordsOfArc(columns, arc));
}

function chordsOfArc({ centres }: HeightColumns, arc: CurvedFace): Face[] {
  const { cx, cy, radius, noise } = arc;
  const overlap = arc.isSure
    ? Math.min(SURE_OVERLAP / radius, (arc.to - arc.from) / 2)
    : Math.min(OVERLAP / radius, Math.PI / 8);
  const isWhole = arc.to - arc.from > 2 * Math.PI - 2 * overlap;
  const [from, to] = isWhole ? [arc.from, arc.from + 2 * Math.PI] : [arc.from - overlap, arc.to + overlap];
  const step = arc.isSure ? Math.min(STEP, chordTurn(radius)) : STEP;
  const count = Math.ceil((to - from) / step);
  const turn = (to - from) / count;
  const members: number[][] = Array.from({ length: count }, () => []);
  for (const c of arc.members) {
    const past = turnOn(from, Math.atan2(centres[2 * c + 1] - cy, centres[2 * c] - cx));
    members[Math.min(count - 1, Math.floor(past / turn))].push(c);
  }
  return members.map((own, k) => {
    const direction = from + (k + 0.5) * turn;
    const [nx, ny] = [Math.cos(direction), Math.sin(direction)];
    const half = radius * Math.sin(turn / 2);
    const middle = cy * nx - cx * ny;
    const offset = cx * nx + cy * ny + radius * Math.cos(turn / 2);
    return {
      nx,
      ny,
      offset,
      from: middle - half,
      to: middle + half,
      noise,
      support: own.length,
      members: own,
      ...(arc.isSure && { arc }),
    };
  });
}

/** How far a curve's end may be off the wall it runs into, m: two fits meet at a grazing angle. */
const TIE = 0.06;

/** A short stroke across the start of a chord, that ties a curve to a wall it runs along rather than crosses. */
export function tieOf(chord: Face) {
  const [[ax, ay], [bx, by]] = [pointOn(chord, chord.from, -TIE), pointOn(chord, chord.from, TIE)];
  return { ax, ay, bx, by };
}
