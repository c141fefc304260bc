import { countOf } from '../core/count-words.ts';
import { STAGES } from '../core/stages.ts';
import { formatCount, formatDuration } from '../view/measure.ts';
import { formatArea } from '../write/sheet/measure-words.ts';
import { icon } from './icon.ts';
import { make, setText } from './make.ts';
import type { Actions, Model, Panel } from './model.ts';

/** A guess of the time left is worth showing after this, ms, and past this share. */
const GUESS_AFTER = 1500;
const GUESS_SHARE = 0.05;

/** The state of the run in words for eye and ear, a bar, and the way to stop it. */
export function makeRunStatus(actions: Actions): Panel {
  const status = make('p', { class: 'status', testid: 'status', role: 'status' });
  const detail = make('p', { class: 'status-detail' });
  const fill = make('div', { class: 'progress-fill' });
  const bar = make(
    'div',
    {
      class: 'progress',
      testid: 'progress',
      role: 'progressbar',
      'aria-label': 'Making the plan',
      'aria-valuemin': 0,
      'aria-valuemax': 100,
      hidden: true,
    },
    fill,
  );
  const cancel = make(
    'button',
    {
      type: 'button',
      class: 'button',
      testid: 'cancel',
      hidden: true,
      on: { click: () => actions.cancel() },
    },
    icon('close'),
    'Cancel',
  );
  const words = make('div', { class: 'status-words' }, status, detail);
  const node = make('div', { class: 'run-status' }, words, cancel, bar);
  return {
    node,
    show(model) {
      const isLoading = model.state === 'loading';
      const share = model.progress?.share ?? 0;
      bar.hidden = !isLoading;
      cancel.hidden = !isLoading;
      bar.setAttribute('aria-valuenow', String(Math.round(share * 100)));
      fill.style.setProperty('--share', String(share));
      setText(status, statusOf(model));
      setText(detail, isLoading ? runningDetail(model) : restingDetail(model));
    },
  };
}

/** Changes only with the stage: this is read aloud. */
function statusOf({ state, view, progress, name }: Model): string {
  switch (state) {
    case 'empty':
      return 'No scan yet';
    case 'failed':
      return view ? 'That did not work; the last plan stays' : 'That did not work';
    case 'ready':
      return 'Plan ready';
    case 'loading':
      return progress ? `${STAGES[progress.stage].label}: ${name}` : `Opening ${name}`;
  }
}

function runningDetail({ progress, startedAt, pointsSeen }: Model): string {
  const share = progress?.share ?? 0;
  const parts = [`${Math.round(share * 100)} %`];
  if (pointsSeen > 0 && progress?.stage === 'read') parts.push(`${formatCount(pointsSeen)} points`);
  const elapsed = performance.now() - startedAt;
  if (elapsed > GUESS_AFTER && share > GUESS_SHARE) {
    parts.push(`${formatDuration((elapsed / share) * (1 - share))} left`);
  }
  return parts.join(' · ');
}

function restingDetail({ view, unit }: Model): string {
  if (!view) return 'Open or drop one';
  const { boundary, rooms, totalMs, mesh } = view.report;
  return [
    formatArea(boundary.areaM2, unit),
    rooms.length > 0 ? countOf(rooms.length, 'room') : 'outline',
    ...(mesh.watertight ? ['closed model'] : []),
    formatDuration(totalMs),
  ].join(' · ');
}
