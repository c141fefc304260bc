import { type Bounds, boundsOfAll, ringsOf } from '../../core/geometry/rings.ts';
import type { StageResults } from '../../core/stage-results.ts';
import type { Polygon } from '../../core/types.ts';
import { comparePolygons } from './compare-polygons.ts';
import { path } from './marks.ts';
import { mappedRings, slicePoints } from './outline-pictures.ts';
import { CONTENT_WIDTH, type Drawing, lengthWords, MARGIN, pageOf } from './page.ts';
import { MUTED, OKABE_ITO } from './palette.ts';
import { type TopView, topView } from './top-view.ts';

/** One side of a comparison. */
export interface ComparedRun {
  /** What sets it apart: "Gift opening". */
  readonly label: string;
  readonly results: Partial<StageResults>;
}

export interface ComparisonLook {
  /** Whose figures are told: the outlines' (where absent) or the structures'. */
  readonly subject?: 'primary' | 'secondary';
  /** `overlaid` draws both outlines on each other, `beside` each in a field of its own. */
  readonly layout?: 'overlaid' | 'beside';
}

const [BLUE, VERMILION] = OKABE_ITO;
/** Between the fields side by side, px. */
const GUTTER = 16;

/**
 * Two runs' outlines in blue and vermilion with the figures between them, as standalone SVG: the boundary as far as
 * each run brought it, and secondary boundaries.
 *
 * @returns null while either run has no boundary
 */
export function drawComparison(
  a: ComparedRun,
  b: ComparedRun,
  { layout = 'overlaid', subject = 'primary' }: ComparisonLook = {},
): string | null {
  const [outlineA, outlineB] = [outlineOf(a.results), outlineOf(b.results)];
  if (outlineA === null || outlineB === null) return null;
  const isOfStructures = subject === 'secondary';
  const { vertices, iou, distance95 } = isOfStructures
    ? comparePolygons(structuresOf(a.results), structuresOf(b.results))
    : comparePolygons(outlineA, outlineB);
  const draw = layout === 'overlaid' ? drawOverlaid : drawBeside;
  const drawing: Drawing = {
    ...draw([
      { run: a, outline: outlineA, colour: BLUE },
      { run: b, outline: outlineB, colour: VERMILION },
    ]),
    counts: [
      ...(isOfStructures ? ['Structures'] : []),
      `IoU ${iou.toFixed(3)}`,
      ...(Number.isFinite(distance95) ? [`95 % within ${lengthWords(distance95)}`] : []),
    ],
    legend: [
      { colour: BLUE, label: `${a.label}: ${vertices[0].toLocaleString('en-GB')} vertices` },
      { colour: VERMILION, label: `${b.label}: ${vertices[1].toLocaleString('en-GB')} vertices` },
    ],
  };
  const doc = `${a.label} against ${b.label}.`;
  return pageOf(drawing, { name: 'comparison', label: 'Comparison', doc });
}

/** The primary boundary as far as a run brought it. */
export function outlineOf({ boundary, regularise }: Partial<StageResults>): readonly Polygon[] | null {
  return regularise?.polygons ?? boundary?.polygons ?? null;
}

function structuresOf({ secondary }: Partial<StageResults>): readonly Polygon[] {
  return secondary?.boundaries.map(({ outline }) => outline) ?? [];
}

interface Side {
  readonly run: ComparedRun;
  readonly outline: readonly Polygon[];
  readonly colour: string;
}
type Sides = readonly [a: Side, b: Side];

function drawOverlaid(sides: Sides): Pick<Drawing, 'height' | 'items' | 'pixelsPerMetre'> {
  const view = topView(extentOf(sides));
  const [{ run }] = sides;
  const { height, pixelsPerMetre } = view;
  // The one beneath is wider, so that both show where they agree.
  const items = [
    ...pointMarks(run, view),
    ...sides.flatMap((side, i) => sideMarks(side, view, i === 0 ? 4 : 1.5)),
  ];
  return { height, pixelsPerMetre, items };
}

function drawBeside(sides: Sides): Pick<Drawing, 'height' | 'items' | 'pixelsPerMetre'> {
  const width = (CONTENT_WIDTH - GUTTER) / 2;
  const views = sides.map((_, i) => topView(extentOf(sides), { left: MARGIN + i * (width + GUTTER), width }));
  const [{ height, pixelsPerMetre }] = views;
  const items = sides.flatMap((side, i) => [
    ...pointMarks(side.run, views[i]),
    ...sideMarks(side, views[i], 1.5),
  ]);
  return { height, pixelsPerMetre, items };
}

/** One extent for both, so that sizes compare. */
function extentOf(sides: Sides): Bounds {
  return boundsOfAll(
    sides.flatMap(({ run, outline }) => [...ringsOf(outline), run.results.slice?.xy ?? new Float64Array(0)]),
  );
}

function pointMarks({ results: { slice } }: ComparedRun, view: TopView): string[] {
  return slice === undefined ? [] : [slicePoints(slice.xy, view, MUTED)];
}

function sideMarks({ run, outline, colour }: Side, view: TopView, width: number): string[] {
  const secondary = structuresOf(run.results);
  const look = { fill: 'none', stroke: colour, 'stroke-width': width, 'stroke-linejoin': 'round' };
  return [
    path(mappedRings(outline, view), true, look),
    ...(secondary.length === 0 ? [] : [path(mappedRings(secondary, view), true, look)]),
  ];
}
