import { type Options, PARAMS } from '../core/params.ts';
import { makeChoiceAbove } from './above-stages.ts';
import { make, setText } from './make.ts';
import type { Actions, Panel } from './model.ts';
import { sayLabel } from './plain-words.ts';

type Preset = Options['preset'];

const PROMISES: Readonly<Record<Exclude<Preset, 'auto'>, string>> = {
  building: 'Every parameter has its value for 3D scans of buildings',
  paper: `Every parameter has the value of the paper, its pixels turned into metres by ${sayLabel('pixelsPerMetre')}`,
};
/** What a person would otherwise take for the paper's. */
const RESERVATIONS: typeof PROMISES = {
  building: '',
  paper: ` It has none for ${sayLabel('openingLength')}, ${sayLabel('bridgeGap')} and ${sayLabel('floorSlab')}, which stay ours; with ${sayLabel('bridgeGap')} at 0 the outline falls through doors, as the paper’s does.`,
};

/** What the automatic choice takes them for. */
const SCANS: Readonly<Record<Preset, string>> = {
  auto: '',
  building: 'for a 3D scan',
  paper: 'for a ready slice',
};

/** The start values of all parameters, one click each. */
export function makePresetPicker(actions: Actions): Panel {
  const { doc } = PARAMS.preset;
  const words = make('p', { class: 'hint' });
  const picker = makeChoiceAbove('preset', words, (preset) => actions.setPreset(preset));
  return {
    node: picker.node,
    show({ given, options, view }) {
      const preset = given.preset ?? 'auto';
      picker.set(preset);
      const others = Object.keys(given).length - (given.preset === undefined ? 0 : 1);
      if (preset !== 'auto')
        setText(words, `${PROMISES[preset]}${exceptions(others)}.${RESERVATIONS[preset]}`);
      else setText(words, view ? `Now: ${options.preset}, ${SCANS[options.preset]}.` : doc);
    },
  };
}

function exceptions(count: number): string {
  if (count === 0) return '';
  return count === 1 ? ', but for one set by hand' : `, but for ${count} set by hand`;
}
