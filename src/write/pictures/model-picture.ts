import { type Bounds, boundsOf } from '../../core/geometry/rings.ts';
import type { StageResults } from '../../core/stage-results.ts';
import type { Solid, SolidGroup } from '../../core/types.ts';
import { turnToSquare } from '../sheet-turn.ts';
import { path } from './marks.ts';
import { castShadow } from './model-shadow.ts';
import { CONTENT_WIDTH, countOf, type Drawing, MARGIN } from './page.ts';
import { paintOrder } from './paint-order.ts';
import { INK } from './palette.ts';
import { type GroupRings, type SolidSlab, slabsOf } from './solid-slabs.ts';

/** Seen from the south-east, a little more from the south so that no corner hides behind another, and from above. */
const HEADING = (-58 * Math.PI) / 180;
/** From as high above that walls hide no more than this share of what lies behind them, within these bounds. */
const HIDDEN = 0.4;
const LOWEST = (42 * Math.PI) / 180;
const HIGHEST = (62 * Math.PI) / 180;
/** The light comes from the viewer's left. */
const LIGHT = HEADING - (55 * Math.PI) / 180;
/** Share of the light that comes from all around. */
const AMBIENT = 0.8;
/** Length of a shadow by the height that casts it, and its share of ink: a high sun in a bright sky. */
const SHADOW = 0.3;
const SHADE = 0.09;
const TALLEST = 460;
/** Faces of a curve that meet flatter than 20° get no line between them. */
const FLAT = Math.cos(Math.PI / 9);
const EDGE = { fill: 'none', stroke: INK, 'stroke-width': 0.7, 'stroke-linecap': 'round' } as const;
/** A face's own colour along its edge closes the seams that smoothing would leave, px. */
const SEAM = 0.5;

type Colour = readonly [r: number, g: number, b: number];
interface Clay {
  readonly side: Colour;
  readonly top: string;
}

/** Matt clay, slightly darker where it is cut; floors in paper; structures in a muted accent. */
const CLAY: Record<SolidGroup['kind'], Clay> = {
  wall: { side: [0xf2, 0xf0, 0xea], top: '#A9A69F' },
  floor: { side: [0xe4, 0xe1, 0xd8], top: '#FBFAF6' },
  ceiling: { side: [0xf2, 0xf0, 0xea], top: '#ECEAE4' },
  secondary: { side: [0xb4, 0xc5, 0xe8], top: '#8FA6D6' },
};

/** Fig. 1c, 7, 8: the solid in parallel projection, hidden faces truly hidden. */
export function drawModel({ solid, plan }: Partial<StageResults>): Drawing | null {
  if (solid === undefined || solid.indices.length === 0) return null;
  const turn = turnToSquare(plan?.storeys.flatMap(({ primary }) => primary) ?? []);
  const eye = makeEye(solid, turn);
  const slabs = slabsOf(solid);
  const items = slabs.flatMap((slab, k) => [
    ...paintSides(slab, slabs[k - 1], eye),
    ...slab.tops.map((top) => paintTop(top, slab.high, eye)),
    ...slab.tops.flatMap(({ group, rings }) =>
      group.kind === 'floor' ? paintShadow(rings, slab.high, slabs.slice(k + 1), eye) : [],
    ),
  ]);
  return {
    height: eye.height,
    items,
    counts: [
      countOf(solid.positions.length / 3, 'vertex', 'vertices'),
      countOf(solid.indices.length / 3, 'triangle'),
      countOf(solid.groups.length, 'solid'),
    ],
  };
}

/** Where the model is seen from, and the page it is seen on. */
interface Eye {
  /** Unit vectors in the plan: towards the viewer and to the right, and where the light is. */
  readonly towards: readonly [x: number, y: number];
  readonly right: readonly [x: number, y: number];
  readonly light: readonly [x: number, y: number];
  /** Of the page above its caption, px. */
  readonly height: number;
  /** Vertices x, y at a height, m, to px. */
  map(xy: ArrayLike<number>, z: number): Float64Array;
}

function makeEye(solid: Solid, turn: number): Eye {
  const { positions } = solid;
  const direction = (angle: number) => [Math.cos(angle - turn), Math.sin(angle - turn)] as const;
  const towards = direction(HEADING);
  const right = [-towards[1], towards[0]] as const;
  const elevation = elevationFor(solid, towards);
  const [lift, rise] = [Math.sin(elevation), Math.cos(elevation)];
  const project = (x: number, y: number, z: number) =>
    [right[0] * x + right[1] * y, lift * (towards[0] * x + towards[1] * y) - rise * z] as const;
  const flat = new Float64Array((positions.length / 3) * 2);
  for (let i = 0; i < positions.length / 3; i++) {
    flat.set(project(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]), 2 * i);
  }
  const { scale, left, head, height } = fitPage(boundsOf(flat));
  return {
    towards,
    right,
    light: direction(LIGHT),
    height,
    map(xy, z) {
      const mapped = new Float64Array(xy.length);
      for (let i = 0; i < xy.length; i += 2) {
        const [u, w] = project(xy[i], xy[i + 1], z);
        mapped[i] = left + scale * u;
        mapped[i + 1] = head + scale * w;
      }
      return mapped;
    },
  };
}

/** How steeply to look: a wall of height h hides h / tan(elevation) of the ground behind it. */
function elevationFor({ positions }: Solid, towards: readonly [number, number]): number {
  let [nearest, farthest, lowest, highest] = [-Infinity, Infinity, Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    const depth = towards[0] * positions[i] + towards[1] * positions[i + 1];
    nearest = Math.max(nearest, depth);
    farthest = Math.min(farthest, depth);
    lowest = Math.min(lowest, positions[i + 2]);
    highest = Math.max(highest, positions[i + 2]);
  }
  const steepness = Math.atan2(highest - lowest, HIDDEN * (nearest - farthest));
  return Math.min(HIGHEST, Math.max(LOWEST, steepness));
}

function fitPage({ minX, minY, maxX, maxY }: Bounds) {
  const scale = Math.min(CONTENT_WIDTH / (maxX - minX), TALLEST / (maxY - minY));
  const left = MARGIN + CONTENT_WIDTH / 2 - (scale * (minX + maxX)) / 2;
  return { scale, left, head: MARGIN - scale * minY, height: MARGIN + scale * (maxY - minY) + 8 };
}

/** An upright face of one slab that looks at the viewer, from left to right as seen. */
interface SideFace {
  readonly kind: SolidGroup['kind'];
  /** x, y of either end, m. */
  readonly ends: Float64Array;
  readonly u0: number;
  readonly v0: number;
  readonly u1: number;
  readonly v1: number;
  /** Whether the face ends, for the eye, at its left and right end. */
  readonly hasLine: readonly [left: boolean, right: boolean];
  /** Parts of the lower edge with nothing beneath them: x, y, x, y each. */
  readonly feet: readonly Float64Array[];
}

function paintSides(slab: SolidSlab, below: SolidSlab | undefined, eye: Eye): string[] {
  const faces = slab.sections.flatMap((section) => {
    const under = below?.sections.find(({ group }) => group === section.group);
    return facesOf(section, under, eye);
  });
  return paintOrder(faces).flatMap((i) => paintSide(faces[i], slab, eye));
}

function facesOf({ group, rings }: GroupRings, under: GroupRings | undefined, eye: Eye): SideFace[] {
  return rings.flatMap((ring) => {
    const n = ring.length;
    const faces: SideFace[] = [];
    for (let i = 0; i < n; i += 2) {
      const ends = Float64Array.of(ring[i], ring[i + 1], ring[(i + 2) % n], ring[(i + 3) % n]);
      const [u0, u1] = [along(eye.right, ends, 0), along(eye.right, ends, 2)];
      // The solid lies to the left, so faces that run to the right are those that look at the viewer.
      if (!(u1 > u0)) continue;
      faces.push({
        kind: group.kind,
        ends,
        u0,
        v0: along(eye.towards, ends, 0),
        u1,
        v1: along(eye.towards, ends, 2),
        hasLine: [isEdge(ring, i, eye, -1), isEdge(ring, i, eye, 1)],
        feet: under === undefined ? [ends] : uncovered(ends, under.rings),
      });
    }
    return faces;
  });
}

const along = ([x, y]: readonly [number, number], xy: Float64Array, at: number): number =>
  x * xy[at] + y * xy[at + 1];

/** Whether the face from vertex `i` meets the one beside it at an angle, or that one looks away. */
function isEdge(ring: Float64Array, i: number, { right }: Eye, step: 1 | -1): boolean {
  const n = ring.length;
  const direction = (at: number): readonly [number, number] => {
    const [from, to] = [(at + n) % n, (at + 2 + n) % n];
    const [dx, dy] = [ring[to] - ring[from], ring[to + 1] - ring[from + 1]];
    const length = Math.hypot(dx, dy);
    return [dx / length, dy / length];
  };
  const [own, other] = [direction(i), direction(i + 2 * step)];
  const looksAway = right[0] * other[0] + right[1] * other[1] <= 0;
  return looksAway || own[0] * other[0] + own[1] * other[1] < FLAT;
}

/** What of an edge lies over no edge of the same direction: the lower side of a lintel, not the wall beside it. */
function uncovered(ends: Float64Array, rings: readonly Float64Array[]): Float64Array[] {
  const [ax, ay, bx, by] = ends;
  const length = Math.hypot(bx - ax, by - ay);
  const [dx, dy] = [(bx - ax) / length, (by - ay) / length];
  const spans: [from: number, to: number][] = [];
  for (const ring of rings) {
    for (let i = 0; i < ring.length; i += 2) {
      const j = (i + 2) % ring.length;
      const [px, py, qx, qy] = [ring[i] - ax, ring[i + 1] - ay, ring[j] - ax, ring[j + 1] - ay];
      const isOnLine = Math.abs(dx * py - dy * px) < ON_LINE && Math.abs(dx * qy - dy * qx) < ON_LINE;
      const [from, to] = [dx * px + dy * py, dx * qx + dy * qy];
      if (isOnLine && to > from) spans.push([from, to]);
    }
  }
  const free: Float64Array[] = [];
  let at = 0;
  for (const [from, to] of [...spans.sort((a, b) => a[0] - b[0]), [length, length]]) {
    const end = Math.min(from, length);
    if (end > at + ON_LINE) {
      free.push(Float64Array.of(ax + at * dx, ay + at * dy, ax + end * dx, ay + end * dy));
    }
    at = Math.max(at, to);
  }
  return free;
}

/** m */
const ON_LINE = 1e-6;

function paintSide(face: SideFace, { low, high }: SolidSlab, eye: Eye): string[] {
  const { ends, hasLine, feet, kind } = face;
  const [foot, head] = [eye.map(ends, low), eye.map(ends, high)];
  const colour = shade(CLAY[kind].side, ends, eye);
  const outline = Float64Array.of(foot[0], foot[1], foot[2], foot[3], head[2], head[3], head[0], head[1]);
  const lines = feet.map((line) => eye.map(line, low));
  if (hasLine[0]) lines.push(Float64Array.of(foot[0], foot[1], head[0], head[1]));
  if (hasLine[1]) lines.push(Float64Array.of(foot[2], foot[3], head[2], head[3]));
  const body = path([outline], true, { fill: colour, stroke: colour, 'stroke-width': SEAM });
  return lines.length === 0 ? [body] : [body, path(lines, false, EDGE)];
}

function paintTop({ group, rings }: GroupRings, z: number, eye: Eye): string {
  return path(
    rings.map((ring) => eye.map(ring, z)),
    true,
    { ...EDGE, fill: CLAY[group.kind].top, 'fill-rule': 'evenodd', 'stroke-linejoin': 'round' },
  );
}

function paintShadow(
  floor: readonly Float64Array[],
  z: number,
  above: readonly SolidSlab[],
  eye: Eye,
): string[] {
  const perMetre = [-SHADOW * eye.light[0], -SHADOW * eye.light[1]] as const;
  const shadow = castShadow(floor, z, above, perMetre);
  if (shadow.length === 0) return [];
  const rings = shadow.flatMap(({ outer, holes }) => [outer, ...holes]).map((ring) => eye.map(ring, z));
  return [path(rings, true, { fill: INK, 'fill-opacity': SHADE, 'fill-rule': 'evenodd' })];
}

/** Lambert's law under one light and an even sky. */
function shade(colour: Colour, [ax, ay, bx, by]: Float64Array, { light }: Eye): string {
  const length = Math.hypot(bx - ax, by - ay);
  const facing = ((by - ay) * light[0] - (bx - ax) * light[1]) / length;
  const share = AMBIENT + (1 - AMBIENT) * Math.max(0, facing);
  const hex = colour.map((part) =>
    Math.round(part * share)
      .toString(16)
      .padStart(2, '0'),
  );
  return `#${hex.join('').toUpperCase()}`;
}
