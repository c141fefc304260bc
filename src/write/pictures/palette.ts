import { viridis } from './viridis.ts';

/** Ink on white paper: a picture looks the same in print, on a light page and on a dark one. */
export const PAPER = '#FFFFFF';
export const INK = '#1B1F24';
/** Second to the ink: captions' figures, rules. */
export const MUTED = '#5C626B';
/** What a picture shows for comparison only. */
export const PALE = '#C3C8D0';
/** Blueprint blue. */
export const ACCENT = '#2457D6';
/** What wants attention. */
export const AMBER = '#B26B00';

/** Okabe and Ito's palette, told apart with any kind of colour vision; yellow last, it is faint on paper. */
export const OKABE_ITO = [
  '#0072B2',
  '#D55E00',
  '#009E73',
  '#CC79A7',
  '#E69F00',
  '#56B4E9',
  '#999999',
  '#F0E442',
] as const;

/** Colour of a cluster; numbers past the palette start over. */
export const clusterColour = (cluster: number): string => OKABE_ITO[cluster % OKABE_ITO.length];

/** Viridis at `t` from 0 to 1, as SVG writes it. */
export function heightColour(t: number): string {
  const word = viridis(t).map((part) => Math.round(part).toString(16).padStart(2, '0'));
  return `#${word.join('').toUpperCase()}`;
}
