import { make, setAttribute } from './make.ts';

/** A small button that is on or off. */
export function toggleChip(
  label: string,
  isOn: boolean,
  onToggle: (isOn: boolean) => void,
): HTMLButtonElement {
  const chip = make(
    'button',
    {
      type: 'button',
      class: 'chip',
      'aria-pressed': String(isOn),
      on: {
        click: () => {
          const next = chip.getAttribute('aria-pressed') !== 'true';
          setAttribute(chip, 'aria-pressed', String(next));
          onToggle(next);
        },
      },
    },
    label,
  );
  return chip;
}

/** A button that shows an icon and is called `label`. */
export function iconButton(label: string, symbol: Node, onClick: () => void): HTMLButtonElement {
  const on = { click: onClick };
  return make(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': label, title: label, on },
    symbol,
  );
}
