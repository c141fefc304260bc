import { PARAMS } from '../core/params.ts';
import { make } from './make.ts';
import { sayChoice } from './plain-words.ts';
import { makeSwitch, type Switch } from './switch.ts';

/** Choices that decide over several stages, and stand above them. */
export const ABOVE_STAGES = ['preset', 'planMethod'] as const;

type Name = (typeof ABOVE_STAGES)[number];
type Choice<N extends Name> = (typeof PARAMS)[N]['choices'][number];

/** The choices of a parameter all in sight, with words below. */
export function makeChoiceAbove<N extends Name>(
  name: N,
  words: HTMLElement,
  onPick: (choice: Choice<N>) => void,
): Switch<Choice<N>> {
  const { label, choices } = PARAMS[name];
  const labels = Object.fromEntries(choices.map((choice) => [choice, sayChoice(choice)]));
  const picker = makeSwitch<Choice<N>>(label, labels as Record<Choice<N>, string>, onPick);
  const line = make('div', { class: 'choice-line' }, make('span', {}, label), picker.node);
  return { ...picker, node: make('div', { class: 'choice-above', 'data-param': name }, line, words) };
}
