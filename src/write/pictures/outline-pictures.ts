/** The slice, its outline, and what each pass makes of it, seen from above. */
import { countOf } from '../../core/count-words.ts';
import { boundsOfAll, ringsOf, vertexCount } from '../../core/geometry/rings.ts';
import type { StageResults } from '../../core/stage-results.ts';
import type { Gap, Polygon, RegularisedBoundary } from '../../core/types.ts';
import { dots, path } from './marks.ts';
import type { Drawing } from './page.ts';
import { ACCENT, AMBER, INK, MUTED, OKABE_ITO, PALE } from './palette.ts';
import { type TopView, thinned, topView } from './top-view.ts';

type Results = Partial<StageResults>;

const [, VERMILION] = OKABE_ITO;

/** Diameter of a point, px: smaller where there are many. */
const FEW_POINT = 2.2;
const MANY_POINT = 1.3;
const MANY = 5000;
/** Widths of lines and diameter of a vertex, px. */
const OUTLINE = 1.5;
const BEFORE = 6;
const VERTEX = 4;
const DROPPED = 2.6;
/** Past this many vertices dots would hide the line. */
const MOST_VERTEX_DOTS = 1500;
const FINE_VERTEX = 2.4;

/** Fig. 4a, 5a: the points an outline is found from. */
export function drawSlice({ slice }: Results): Drawing | null {
  if (slice === undefined || slice.xy.length === 0) return null;
  const view = topView(boundsOfAll([slice.xy]));
  const { band, spacing, xy } = slice;
  const height = band[0] < band[1] ? [`${band[0].toFixed(2)} to ${band[1].toFixed(2)} m`] : [];
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: [slicePoints(xy, view, INK)],
    counts: [countOf(xy.length / 2, 'point'), ...height, `spacing ${(1000 * spacing).toFixed(0)} mm`],
  };
}

/** Fig. 4b, 5b: the outline as the boundary method finds it. */
export function drawHull({ slice, boundary }: Results): Drawing | null {
  if (slice === undefined || boundary === undefined) return null;
  const { polygons, gaps, method } = boundary;
  const view = topView(boundsOfAll([slice.xy, ...ringsOf(polygons)]));
  const bridged = gaps.length === 0 ? [] : [`${countOf(gaps.length, 'gap')} bridged`];
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: [
      slicePoints(slice.xy, view, MUTED),
      ...outlineMarks(polygons, view, ACCENT),
      ...gapMarks(gaps, view),
    ],
    counts: [
      METHOD_WORDS[method],
      countOf(slice.xy.length / 2, 'point'),
      countOf(vertexCount(polygons), 'vertex', 'vertices'),
      ...bridged,
    ],
    legend:
      gaps.length === 0
        ? []
        : [
            { colour: ACCENT, label: 'Outline' },
            { colour: AMBER, label: 'Bridged gap' },
          ],
  };
}

const METHOD_WORDS = {
  'gift-opening': 'Gift opening',
  convex: 'Convex hull',
  'alpha-shape': 'α-shape',
  concaveman: 'Concaveman',
} as const;

/** Whether a pass was made. @param pass a name of RegularisedBoundary.passes */
export function hasPass(pass: string, { passes }: RegularisedBoundary): boolean {
  return passes.some(({ name }) => name === pass);
}

/** Fig. 4c, 5c: what one pass made of the outline before it. @param pass a name of RegularisedBoundary.passes */
export function drawPass(pass: string, { boundary, regularise }: Results): Drawing | null {
  const at = regularise?.passes.findIndex(({ name }) => name === pass) ?? -1;
  if (boundary === undefined || regularise === undefined || at < 0) return null;
  const before = at === 0 ? boundary.polygons : regularise.passes[at - 1].polygons;
  const after = regularise.passes[at].polygons;
  const view = topView(boundsOfAll([...ringsOf(boundary.polygons), ...ringsOf(after)]));
  const [from, to] = [vertexCount(before), vertexCount(after)];
  // A pass that leaves as many has only moved them.
  const dropped = from === to ? new Float64Array(0) : droppedVertices(before, after);
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: [
      path(mappedRings(before, view), true, { fill: 'none', stroke: PALE, 'stroke-width': BEFORE, ...ROUND }),
      dots(view.map(dropped), { colour: VERMILION, size: DROPPED }),
      ...outlineMarks(after, view, ACCENT),
    ],
    counts: [`${from.toLocaleString('en-GB')} → ${countOf(to, 'vertex', 'vertices')}`],
    legend: [
      { colour: PALE, label: 'Before' },
      { colour: ACCENT, label: 'After' },
      ...(dropped.length === 0 ? [] : [{ colour: VERMILION, label: 'Vertex dropped' }]),
    ],
  };
}

/** Vertices of the rings before that the rings after do not have: x, y each. */
function droppedVertices(before: readonly Polygon[], after: readonly Polygon[]): Float64Array {
  const kept = new Set(ringsOf(after).flatMap(vertexKeys));
  const dropped: number[] = [];
  for (const ring of ringsOf(before)) {
    vertexKeys(ring).forEach((key, i) => {
      if (!kept.has(key)) dropped.push(ring[2 * i], ring[2 * i + 1]);
    });
  }
  return Float64Array.from(dropped);
}

function vertexKeys(ring: Float64Array): string[] {
  return Array.from({ length: ring.length / 2 }, (_, i) => `${ring[2 * i]} ${ring[2 * i + 1]}`);
}

const ROUND = { 'stroke-linejoin': 'round' } as const;

/** Points of a slice, thinned to what a picture can show. */
export function slicePoints(xy: Float64Array, view: TopView, colour: string): string {
  const shown = thinned(xy);
  const size = shown.length / 2 > MANY ? MANY_POINT : FEW_POINT;
  return dots(view.map(shown), { colour, size, opacity: colour === INK ? 0.8 : 0.6 }, { id: 'points' });
}

/** Rings with a dot at every vertex. */
export function outlineMarks(polygons: readonly Polygon[], view: TopView, colour: string): string[] {
  const rings = mappedRings(polygons, view);
  const line = path(rings, true, { fill: 'none', stroke: colour, 'stroke-width': OUTLINE, ...ROUND });
  const size = vertexCount(polygons) > MOST_VERTEX_DOTS ? FINE_VERTEX : VERTEX;
  return [line, ...rings.map((ring) => dots(ring, { colour, size }))];
}

/** Bridged gaps, each to be picked by its number. */
export function gapMarks(gaps: readonly Gap[], view: TopView): string[] {
  return gaps.map(({ from, to }, i) =>
    path([view.map(Float64Array.of(...from, ...to))], false, {
      id: `gap-${i}`,
      'data-pick': `gap:${i}`,
      fill: 'none',
      stroke: AMBER,
      'stroke-width': 3.5,
      'stroke-linecap': 'round',
    }),
  );
}

export const mappedRings = (polygons: readonly Polygon[], view: TopView): Float64Array[] =>
  ringsOf(polygons).map((ring) => view.map(ring));
