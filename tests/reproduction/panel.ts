import { countOf } from '../../src/core/count-words.ts';
import { boundsOf, ringsOf, vertexCount } from '../../src/core/geometry/rings.ts';
import type { StageResults } from '../../src/core/stage-results.ts';
import type { Polygon } from '../../src/core/types.ts';
import { dots, path } from '../../src/write/pictures/marks.ts';
import { outlineMarks } from '../../src/write/pictures/outline-pictures.ts';
import { pageOf } from '../../src/write/pictures/page.ts';
import { ACCENT, INK, OKABE_ITO, PALE } from '../../src/write/pictures/palette.ts';
import { topView } from '../../src/write/pictures/top-view.ts';

/** What a panel of Fig. 6 shows: points, and outlines over them. Metres, plan frame. */
export interface Panel {
  readonly name: string;
  readonly label: string;
  readonly doc: string;
  readonly points: Float64Array;
  readonly primary: readonly Polygon[];
  readonly secondary: readonly Polygon[];
}

const VERMILION = OKABE_ITO[1];

/** All panels of one room have one scale and one frame, that of the points, so they compare. */
export function drawPanel({ name, label, doc, points, primary, secondary }: Panel): string {
  const view = topView(boundsOf(points));
  const shape = (polygons: readonly Polygon[], colour: string) =>
    path(
      ringsOf(polygons).map((ring) => view.map(ring)),
      true,
      {
        fill: colour,
        'fill-opacity': 0.12,
        'fill-rule': 'evenodd',
        stroke: colour,
        'stroke-width': 2,
        'stroke-linejoin': 'round',
      },
    );
  const all = [...primary, ...secondary];
  return pageOf(
    {
      height: view.height,
      items: [
        ...(primary.length > 0 ? [shape(primary, ACCENT)] : []),
        ...(secondary.length > 0 ? [shape(secondary, VERMILION)] : []),
        dots(view.map(points), { colour: INK, size: 2.5, opacity: 0.6 }),
      ],
      counts: [countOf(all.length, 'piece'), countOf(vertexCount(all), 'vertex', 'vertices')],
      pixelsPerMetre: view.pixelsPerMetre,
    },
    { name, label, doc },
  );
}

/** Fig. 4c and 5c: the outline after all passes, over the points. */
export function drawRegularised(name: string, { slice, boundary, regularise }: StageResults): string {
  const view = topView(boundsOf(slice.xy));
  const [before, after] = [boundary, regularise].map(({ polygons }) => vertexCount(polygons));
  return pageOf(
    {
      height: view.height,
      items: [
        dots(view.map(slice.xy), { colour: PALE, size: 2.5 }),
        ...outlineMarks(regularise.polygons, view, ACCENT),
      ],
      counts: [`${countOf(after, 'vertex', 'vertices')} of ${before}`],
      pixelsPerMetre: view.pixelsPerMetre,
    },
    { name, label: 'Regularised', doc: 'The outline after all passes, over the points.' },
  );
}
