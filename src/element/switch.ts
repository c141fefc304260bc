import { make, setAttribute } from './make.ts';

export interface Switch<Choice extends string> {
  readonly node: HTMLElement;
  set(choice: Choice): void;
}

/** One of a few choices, all in sight. */
export function makeSwitch<Choice extends string>(
  label: string,
  choices: Readonly<Record<Choice, string>>,
  onPick: (choice: Choice) => void,
): Switch<Choice> {
  const buttons = (Object.keys(choices) as Choice[]).map((choice) => {
    const on = { click: () => onPick(choice) };
    return make(
      'button',
      { type: 'button', 'data-choice': choice, 'aria-pressed': 'false', on },
      choices[choice],
    );
  });
  return {
    node: make('div', { class: 'choices', role: 'group', 'aria-label': label }, ...buttons),
    set(choice) {
      for (const button of buttons)
        setAttribute(button, 'aria-pressed', String(button.dataset.choice === choice));
    },
  };
}
