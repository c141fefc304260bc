import { FloorPlanElement } from '../element/define.ts';
import { icon } from '../element/icon.ts';
import { make } from '../element/make.ts';
import { makeHelpDialog } from './help-dialog.ts';
import { fillSamples, fillThumbnails, SAMPLES } from './samples.ts';
import { makeThemeButton } from './theme.ts';

const plan = document.querySelector('floor-plan');
// A task of its own: the page has just built the element.
if (plan instanceof FloorPlanElement) setTimeout(() => start(plan));

/** Puts the page around the element: samples, theme, help, and the scan to begin with. */
function start(element: FloorPlanElement): void {
  const open = (file: string) => element.setAttribute('src', file);
  // The same sample again is no change of the attribute, so it is loaded by hand.
  const reopen = (file: string) => {
    if (element.getAttribute('src') === file) element.load(file).catch(() => {});
    else open(file);
  };
  fillSamples(place('samples'), reopen);
  fillThumbnails(place('thumbnails'), reopen);
  const help = makeHelpDialog();
  const showHelp = () => help.open || help.showModal();
  const helpButton = make(
    'button',
    { type: 'button', 'aria-label': 'Help', title: 'Help', on: { click: showHelp } },
    icon('help'),
  );
  place('page-tools').append(makeThemeButton(), helpButton);
  document.body.append(help);
  document.addEventListener('keydown', (event) => {
    const [target] = event.composedPath();
    if (event.key === '?' && !(target instanceof HTMLInputElement)) showHelp();
    // Before anything has the focus, keys are meant for the plan.
    const isForPlan = target === document.body;
    if (isForPlan && !element.dispatchEvent(new KeyboardEvent('keydown', event))) event.preventDefault();
  });
  element.addEventListener('load', () => {
    document.title = `${element.plan?.source.name ?? 'Plan'} – Grundriss`;
  });
  const asked = new URLSearchParams(location.search).get('src');
  const first = asked ?? SAMPLES[0].file;
  if (first !== '') open(first);
}

function place(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`The page lacks #${id}.`);
  return element;
}
