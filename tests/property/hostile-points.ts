/** Point sets made to break hulls: every kind, at every size and place, from a seed. */
import { type Random, seededRandom } from '../../fixtures/simulator/random.ts';

export interface HostilePoints {
  /** What it is, to find it again. */
  readonly name: string;
  /** x, y a point. */
  readonly xy: Float64Array;
  /** Edges longer than this are to be opened; a share of the set's size, so that every set has some. */
  readonly openingLength: number;
  readonly bridgeGap: number;
  readonly alpha: number;
}

type Pair = readonly [x: number, y: number];

/** Points of about unit extent; `t` runs from 0 to 1. */
type Kind = (count: number, random: Random) => Pair[];

const TURN = 2 * Math.PI;
const along = (count: number, at: (t: number, k: number) => Pair): Pair[] =>
  Array.from({ length: count }, (_, k) => at(k / count, k));

const kinds: Record<string, Kind> = {
  uniform: (count, random) => along(count, () => [random.next(), random.next()]),
  duplicates: (count, random) => along(count, () => [random.integer(0, 3) / 3, random.integer(0, 2) / 2]),
  lattice: (count) => along(count, (_, k) => [(k % 9) / 9, Math.floor(k / 9) / 9]),
  'turned lattice': (count, random) => turned(kinds.lattice(count, random), random.next()),
  'on a line': (count, random) => along(count, () => onLine(random.integer(0, 20) / 20)),
  'on a line but one': (count, random) => [...kinds['on a line'](count, random), [0.5, random.next()]],
  'nearly on a line': (count, random) =>
    along(count, (t) => [t, t / 3 + random.integer(-3, 3) * Number.EPSILON]),
  'two lines': (count, random) => along(count, (t, k) => [t, k % 2 === 0 ? 0 : random.integer(0, 1) * 1e-9]),
  circle: (count) => along(count, (t) => [Math.cos(TURN * t), Math.sin(TURN * t)]),
  circles: (count) =>
    along(count, (t, k) => [Math.cos(TURN * t) / (1 + (k % 3)), Math.sin(TURN * t) / (1 + (k % 3))]),
  star: (count) =>
    along(count, (t, k) => [
      Math.cos(TURN * t) * (k % 2 ? 1 : 0.05),
      Math.sin(TURN * t) * (k % 2 ? 1 : 0.05),
    ]),
  spiral: (count) => along(count, (t) => [t * Math.cos(5 * TURN * t), t * Math.sin(5 * TURN * t)]),
  comb: (count, random) =>
    along(count, (_, k) => [(k % 10) / 10, k % 2 ? random.next() : random.integer(0, 1)]),
  clusters: (count, random) =>
    along(count, (_, k) => [(k % 3) / 2 + random.normal() * 1e-3, (k % 2) + random.normal() * 1e-6]),
  'one far away': (count, random) => [...kinds.uniform(count, random), [1e6, 1e6 * random.next()]],
  parabola: (count) => along(count, (t) => [t, t * t]),
  'wall with gaps': (count, random) =>
    along(count, (t) => beside(Math.floor(t * 40) % 7 === 0 ? t + 1 / 40 : t, random.normal() * 0.003)),
  'noisy room': (count, random) => along(count, () => beside(random.next(), random.normal() * 0.01)),
  'room with furniture': (count, random) =>
    along(count, (_, k) => (k % 3 === 0 ? [random.next(), random.next()] : beside(random.next(), 0))),
  cross: (count, random) => along(count, (t, k) => (k % 2 ? [t, 0.5] : [0.5, random.next()])),
  few: (_, random) => kinds.uniform(random.integer(0, 5), random),
};

const SIZES = [1e-6, 1e-3, 1, 30, 1e7];
const PLACES: readonly Pair[] = [
  [0, 0],
  [0, 0],
  [-0.5, 3],
  [691_000, 5_336_000],
];
const OPENINGS = [1e-3, 0.01, 0.05, 0.2, 0.7];
const BRIDGES = [0, 0.1, 0.35, 2];
const ALPHAS = [0.03, 0.1, 0.3, 3];

/** The set of a number: kinds take turns, the rest is drawn. */
export function hostilePoints(number: number): HostilePoints {
  const names = Object.keys(kinds);
  const kind = names[number % names.length];
  const random = seededRandom(number, kind);
  const size = random.pick(SIZES);
  const [x, y] = random.pick(PLACES);
  const pairs = kinds[kind](random.integer(3, random.chance(0.2) ? 400 : 80), random);
  const shuffled = pairs.map((pair) => ({ pair, key: random.next() })).sort((a, b) => a.key - b.key);
  return {
    name: `${number}: ${kind}, ${pairs.length} points of ${size} m at ${x}, ${y}`,
    xy: Float64Array.from(shuffled.flatMap(({ pair }) => [pair[0] * size + x, pair[1] * size + y])),
    openingLength: random.pick(OPENINGS) * size,
    bridgeGap: random.pick(BRIDGES) * size,
    alpha: random.pick(ALPHAS) * size,
  };
}

function onLine(t: number): Pair {
  return [t, t / 2];
}

function turned(pairs: readonly Pair[], angle: number): Pair[] {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return pairs.map(([x, y]): Pair => [x * cos - y * sin, x * sin + y * cos]);
}

/** A point beside the walls of an L, `t` of the way around. */
function beside(t: number, aside: number): Pair {
  const corners: readonly Pair[] = [
    [0, 0],
    [1, 0],
    [1, 0.4],
    [0.6, 0.4],
    [0.6, 1],
    [0, 1],
    [0, 0],
  ];
  let way = (t - Math.floor(t)) * 4;
  for (let k = 1; k < corners.length; k++) {
    const [[ax, ay], [bx, by]] = [corners[k - 1], corners[k]];
    const length = Math.abs(bx - ax) + Math.abs(by - ay);
    if (way > length && k < corners.length - 1) {
      way -= length;
      continue;
    }
    const [ux, uy] = [(bx - ax) / length, (by - ay) / length];
    return [ax + ux * way - uy * aside, ay + uy * way + ux * aside];
  }
  throw new Error('The way around is 4 long.');
}
