import type { StageName } from '../core/stages.ts';
import { drawSlice } from '../view/slice-picture.ts';
import type { PlanView } from '../worker/protocol.ts';
import { make } from './make.ts';
import type { Panel } from './model.ts';

const CAPTIONS: Partial<Record<StageName, string>> = {
  slice: 'The points the outline is made from.',
  secondary: 'Point groups the structures were looked for in.',
};

/** A stage's own picture, where one says more than numbers: the slice, and the clusters of its points. */
export function makeStagePicture(stage: StageName): Panel | null {
  const caption = CAPTIONS[stage];
  if (!caption) return null;
  const canvas = make('canvas', { class: 'stage-picture', role: 'img', 'aria-label': caption });
  const figure = make('figure', { class: 'picture', hidden: true }, canvas, make('figcaption', {}, caption));
  let drawn: PlanView | null = null;
  const draw = (view: PlanView) => {
    drawn = view;
    void drawSlice(canvas, view.slice.xy, stage === 'secondary' ? view.secondary.clusters : undefined);
  };
  // The canvas's colour has a transition, so its end tells that the theme changed.
  canvas.addEventListener('transitionend', () => drawn && draw(drawn));
  return {
    node: figure,
    show({ view }) {
      figure.hidden =
        !view || view.isSavedPlan || (stage === 'secondary' && view.secondary.clusters.length === 0);
      // Drawn when first seen: a closed stage has no size.
      if (!view || figure.hidden || drawn === view || canvas.clientWidth === 0) return;
      draw(view);
    },
  };
}
