import { countOf } from '../../core/count-words.ts';
import { isCounterClockwise, ringsOf } from '../../core/geometry/rings.ts';
import type { StageResults } from '../../core/stage-results.ts';
import { sheetTurn } from '../sheet/sheet-turn.ts';
import { path } from './marks.ts';
import { sideColour, topColour } from './model-clay.ts';
import { type Eye, makeEye } from './model-eye.ts';
import { facesOf, type SideFace } from './model-faces.ts';
import { castShadow } from './model-shadow.ts';
import type { Drawing } from './page.ts';
import { paintOrder } from './paint-order.ts';
import { INK } from './palette.ts';
import { type GroupRings, type SolidSlab, slabsOf } from './solid-slabs.ts';

/** Length of a shadow by the height that casts it, and its share of ink: a high sun in a bright sky. */
const SHADOW = 0.3;
const SHADE = 0.09;
const EDGE = { fill: 'none', stroke: INK, 'stroke-width': 0.7, 'stroke-linecap': 'round' } as const;
const HIDDEN_EDGE = { ...EDGE, 'stroke-dasharray': '4 3' } as const;
/** Heads and sills that differ by less are drawn at one height, m: as measured, hardly two of them are quite alike. */
const SAME_HEIGHT = 0.02;
/** A face's own colour along its edge closes the seams that smoothing would leave, px. */
const SEAM = 0.5;

/** Fig. 1c, 7, 8: the solid in parallel projection, hidden faces truly hidden but for what is cut out of the floor. */
export function drawModel({ solid, plan }: Partial<StageResults>): Drawing | null {
  if (solid === undefined || solid.indices.length === 0) return null;
  const turn = sheetTurn(plan?.storeys ?? []);
  const eye = makeEye(solid, turn);
  const slabs = slabsOf(solid, Math.min(SAME_HEIGHT, eye.pixel / 2));
  const items = slabs.flatMap((slab, k) => [
    ...paintSides(slab, slabs[k - 1], eye),
    ...slab.tops.map((top) => paintTop(top, slab.high, eye)),
    ...slab.tops.flatMap(({ group, rings }) =>
      group.kind === 'floor' ? paintShadow(rings, slab.high, slabs.slice(k + 1), eye) : [],
    ),
  ]);
  const hidden = slabs.flatMap(({ tops, high }) => tops.flatMap((top) => paintCuts(top, high, eye)));
  return {
    height: eye.height,
    items: [...items, ...hidden],
    counts: [
      countOf(solid.positions.length / 3, 'vertex', 'vertices'),
      countOf(solid.indices.length / 3, 'triangle'),
      countOf(solid.groups.length, 'solid'),
    ],
  };
}

function paintSides(slab: SolidSlab, below: SolidSlab | undefined, eye: Eye): string[] {
  const faces = facesOf(slab, below, eye);
  return paintOrder(faces).flatMap((i) => paintSide(faces[i], slab, eye));
}

function paintSide(face: SideFace, { low, high }: SolidSlab, eye: Eye): string[] {
  const { ends, hasLine, feet, kind } = face;
  const [foot, head] = [eye.map(ends, low), eye.map(ends, high)];
  const [nx, ny] = [ends[3] - ends[1], ends[0] - ends[2]];
  const length = Math.hypot(nx, ny);
  const colour = sideColour(kind, [nx / length, ny / length], eye.light);
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
    { ...EDGE, fill: topColour(group.kind), 'fill-rule': 'evenodd', 'stroke-linejoin': 'round' },
  );
}

/** Where a structure is cut out of a floor, dashed through the walls before it; on a visible edge no dash shows. */
function paintCuts({ group, rings }: GroupRings, z: number, eye: Eye): string[] {
  const cuts = group.kind === 'floor' ? rings.filter((ring) => !isCounterClockwise(ring)) : [];
  return cuts.length === 0
    ? []
    : [
        path(
          cuts.map((ring) => eye.map(ring, z)),
          true,
          HIDDEN_EDGE,
        ),
      ];
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
  const rings = ringsOf(shadow).map((ring) => eye.map(ring, z));
  return [path(rings, true, { fill: INK, 'fill-opacity': SHADE, 'fill-rule': 'evenodd' })];
}
