import type { ParamRow } from '../core/param-rows.ts';
import { PARAM_NAMES, PARAMS, type ParamName } from '../core/params.ts';
import type { StageReport } from '../core/pipeline-run.ts';
import { STAGE_NAMES, STAGES, type StageName } from '../core/stages.ts';
import { formatDuration } from '../view/measure.ts';
import { ABOVE_STAGES } from './above-stages.ts';
import { makeControl } from './controls.ts';
import { icon } from './icon.ts';
import { makeLevelPicker } from './level-picker.ts';
import { make, setAttribute, setText } from './make.ts';
import type { Actions, Model, Panel } from './model.ts';
import { makeStagePicture } from './stage-picture.ts';
import { makeStepLink } from './step-link.ts';

/** `saved`: a plan was opened without its scan, and this stage lies before it. */
type Mark = 'waiting' | 'running' | 'done' | 'kept' | 'saved' | 'failed';

/** One stage of the run: its state, what came out and how long it took; opens to what it does and its parameters. */
export function makeStageRow(stage: StageName, actions: Actions): Panel {
  const { label, doc, source } = STAGES[stage];
  const line = makeLine(label);
  const body = make('div', { class: 'stage-body' });
  const node = make(
    'details',
    { class: 'stage', 'data-stage': stage, open: stage === 'level' },
    line.node,
    body,
  );
  let parts: readonly Panel[] | null = null;
  let last: Model | null = null;
  // What a stage holds is made when it first opens: thirty controls that nobody sees would slow the page's start.
  const showParts = () => {
    if (!node.open || !last) return;
    if (!parts) {
      parts = makeParts(stage, actions);
      const words = source === 'ours' ? doc : `${doc} ${source}`;
      body.append(make('p', { class: 'hint' }, words), ...parts.map((part) => part.node));
    }
    for (const part of parts) part.show(last);
  };
  node.addEventListener('toggle', showParts);
  return {
    node,
    show(model) {
      last = model;
      const report = model.view?.stages.find(({ name }) => name === stage);
      const mark = markOf(stage, model);
      setAttribute(node, 'data-mark', mark);
      line.show(mark, report);
      showParts();
    },
  };
}

/** What is seen of a stage that is not open. */
function makeLine(label: string) {
  const symbol = make('span', { class: 'mark' });
  const outcome = make('span', { class: 'outcome' });
  const time = make('span', { class: 'time' });
  const node = make(
    'summary',
    { class: 'stage-line' },
    symbol,
    make('span', { class: 'stage-label' }, label),
    outcome,
    time,
    make('span', { class: 'chevron' }, icon('chevron')),
  );
  let shown: Mark | null = null;
  return {
    node,
    show(mark: Mark, report: StageReport | undefined) {
      if (mark !== shown) symbol.replaceChildren(...symbolOf(mark));
      shown = mark;
      const words =
        mark === 'waiting' ? '' : mark === 'saved' ? 'in the saved plan' : (report?.outcome ?? '');
      setText(outcome, words);
      // A long outcome is cut in a narrow rail.
      setAttribute(outcome, 'title', words);
      const isTimed = mark !== 'running' && report !== undefined;
      setText(time, !isTimed ? '' : report.isCached ? 'kept' : formatDuration(report.ms));
    },
  };
}

/** The way to its pictures, the small one, the controls, and those for few behind one more line. */
function makeParts(stage: StageName, actions: Actions): Panel[] {
  const above: readonly ParamName[] = ABOVE_STAGES;
  const names = PARAM_NAMES.filter((name) => PARAMS[name].stage === stage && !above.includes(name));
  const isAdvanced = (name: ParamName) => (PARAMS[name] as ParamRow).advanced === true;
  const main = names.filter((name) => !isAdvanced(name)).map((name) => controlOf(name, actions));
  const more = names.filter(isAdvanced).map((name) => controlOf(name, actions));
  const picture = makeStagePicture(stage);
  const parts = [makeStepLink(stage, actions), ...(picture ? [picture] : []), ...main];
  if (more.length === 0) return parts;
  const node = make(
    'details',
    { class: 'more' },
    make('summary', {}, 'More'),
    ...more.map((part) => part.node),
  );
  return [
    ...parts,
    {
      node,
      show(model) {
        for (const part of more) part.show(model);
      },
    },
  ];
}

function controlOf(name: ParamName, actions: Actions): Panel {
  return PARAMS[name].kind === 'level' ? makeLevelPicker(actions) : makeControl(name, actions);
}

function markOf(stage: StageName, { state, progress, failed, view }: Model): Mark {
  if (state === 'loading') {
    const at = progress ? STAGE_NAMES.indexOf(progress.stage) : 0;
    const own = STAGE_NAMES.indexOf(stage);
    return own < at ? 'done' : own === at ? 'running' : 'waiting';
  }
  // Progress is told thirty times a second; a run that fails at once has told less than its error knows.
  if (state === 'failed' && (failed ?? progress)?.stage === stage) return 'failed';
  const report = view?.stages.find(({ name }) => name === stage);
  if (!report) return view?.isSavedPlan ? 'saved' : 'waiting';
  return report.isCached ? 'kept' : 'done';
}

function symbolOf(mark: Mark): Node[] {
  const words = {
    waiting: 'Waiting',
    running: 'Running',
    done: 'Done',
    kept: 'Kept from before',
    saved: 'In the saved plan',
    failed: 'Failed',
  };
  const text = make('span', { class: 'visually-hidden' }, words[mark]);
  switch (mark) {
    case 'waiting':
      return [text];
    case 'running':
      return [icon('spinner'), text];
    case 'failed':
      return [icon('alert'), text];
    default:
      return [icon('check'), text];
  }
}
