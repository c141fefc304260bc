import { chordTurn } from '../../geometry/ring-arcs.ts';
import type { Ring, RingArc } from '../../types.ts';
import type { FacePair } from './pair-faces.ts';

/** A wall's strip reaches so far into the rooms beside it, m: more than chords leave their curve. */
const MARGIN = 0.005;

/** A wall between two rooms: over one pair of faces, or over all those of two curves. */
export interface WallStrip {
  readonly pairs: readonly FacePair[];
  readonly thickness: number;
  /** The area it is cut out of, a little wider than it is, so that what is cut out leaves no slivers. */
  readonly ring: Ring;
}

/** The walls that pairs of faces are of, in the order of their first pairs. */
export function wallStrips(pairs: readonly FacePair[]): WallStrip[] {
  const walls: FacePair[][] = [];
  for (const pair of pairs) {
    const { arc } = pair.face;
    const known = arc && walls.find(([{ face, back }]) => face.arc === arc && back.arc === pair.back.arc);
    if (known && pair.back.arc) known.push(pair);
    else walls.push([pair]);
  }
  return walls.map((own) => {
    const [{ face, back }] = own;
    return face.arc && back.arc && own.length > 1
      ? curvedStrip(own, face.arc, back.arc)
      : { pairs: own, thickness: own[0].thickness, ring: pairRing(own[0]) };
  });
}

function curvedStrip(pairs: readonly FacePair[], { centre, radius }: RingArc, back: RingArc): WallStrip {
  const [cx, cy] = centre;
  const { ax, ay, ux, uy } = pairs[0].face;
  // The room is on the face's left, so the wall is on its right.
  const out = Math.sign((ax - cx) * uy - (ay - cy) * ux);
  const [from, to] = reachOf(pairs, centre);
  /** Distance of the back from the centre of the face in a direction: the two circles are fitted each by itself. */
  const backAt = (dx: number, dy: number) => {
    const [ox, oy] = [cx - back.centre[0], cy - back.centre[1]];
    const along = ox * dx + oy * dy;
    return Math.sqrt(along * along - ox * ox - oy * oy + back.radius ** 2) - along;
  };
  const count = Math.max(1, Math.ceil((to - from) / (chordTurn(radius) / 2)));
  const [near, far]: [number[], number[]] = [[], []];
  for (let k = 0; k <= count; k++) {
    const angle = from + ((to - from) * k) / count;
    const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
    const [inner, outer] = [radius - out * MARGIN, backAt(dx, dy) + out * MARGIN];
    near.push(cx + inner * dx, cy + inner * dy);
    far.unshift(cx + outer * dx, cy + outer * dy);
  }
  const middle = (from + to) / 2;
  const thickness = Math.abs(backAt(Math.cos(middle), Math.sin(middle)) - radius);
  return { pairs, thickness, ring: Float64Array.from([...near, ...far]) };
}

/** Directions from a centre that pairs reach over, radians; the first may be turned by whole turns. */
function reachOf(pairs: readonly FacePair[], [cx, cy]: RingArc['centre']): readonly [number, number] {
  const angleAt = ({ face }: FacePair, along: number) =>
    Math.atan2(face.ay + along * face.uy - cy, face.ax + along * face.ux - cx);
  const first = angleAt(pairs[0], pairs[0].from);
  let [from, to] = [first, first];
  for (const pair of pairs) {
    for (const along of [pair.from, pair.to]) {
      // Pairs follow each other, so each is within half a turn of what is known.
      const turn = angleAt(pair, along) - (from + to) / 2;
      const angle = (from + to) / 2 + turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
      [from, to] = [Math.min(from, angle), Math.max(to, angle)];
    }
  }
  return [from, to];
}

/** The strip of a wall, a little wider than it is: what is cut out of the area between rooms then leaves no slivers. */
function pairRing({ face, back, from, to }: FacePair): Float64Array {
  const onFace = (along: number, out: number) => [
    face.ax + along * face.ux + out * face.uy,
    face.ay + along * face.uy - out * face.ux,
  ];
  const onBack = (along: number) => {
    const [x, y] = onFace(along, 0);
    const t = (x - back.ax) * back.ux + (y - back.ay) * back.uy;
    // Away from the room behind is towards the face.
    return [back.ax + t * back.ux - MARGIN * back.uy, back.ay + t * back.uy + MARGIN * back.ux];
  };
  // The room is on the face's left, so the wall is on its right.
  return Float64Array.from([onFace(from, -MARGIN), onBack(from), onBack(to), onFace(to, -MARGIN)].flat());
}
