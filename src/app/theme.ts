import { type IconName, icon } from '../element/icon.ts';
import { make } from '../element/make.ts';

const KEY = 'grundriss.theme';
const THEMES = ['system', 'light', 'dark'] as const;
type Theme = (typeof THEMES)[number];

const ICONS: Readonly<Record<Theme, IconName>> = { system: 'system', light: 'light', dark: 'dark' };

/** A button that goes from the system's theme to light to dark and remembers the choice. */
export function makeThemeButton(): HTMLButtonElement {
  const button = make('button', { type: 'button', on: { click: () => show(after(theme)) } });
  let theme = remembered();
  const show = (next: Theme) => {
    theme = next;
    remember(next);
    document.documentElement.dataset.theme = next;
    const label = `Theme: ${next}`;
    button.setAttribute('aria-label', label);
    button.title = label;
    button.replaceChildren(icon(ICONS[next]));
  };
  show(theme);
  return button;
}

function after(theme: Theme): Theme {
  return THEMES[(THEMES.indexOf(theme) + 1) % THEMES.length];
}

function remembered(): Theme {
  try {
    const kept = localStorage.getItem(KEY);
    return THEMES.find((theme) => theme === kept) ?? 'system';
  } catch {
    // A page without storage has no memory; the system's theme holds.
    return 'system';
  }
}

function remember(theme: Theme): void {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // As above.
  }
}
