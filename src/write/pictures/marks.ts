/** The marks pictures are made of, as SVG elements with presentation attributes only: they show under any policy. */
import { attributes, escapeXml } from '../xml.ts';
import { INK } from './palette.ts';

/** Coordinates are written in whole hundredths of a pixel. */
const STEPS_PER_PIXEL = 100;

type Attributes = Readonly<Record<string, string | number | undefined>>;

export interface DotLook {
  readonly colour: string;
  /** Diameter, px. */
  readonly size: number;
  readonly opacity?: number;
}

/** An element, with what it holds. */
export function element(name: string, values: Attributes, content: readonly string[] | string = []): string {
  const inner = typeof content === 'string' ? content : content.join('\n');
  const head = `<${name}${attributes(values)}`;
  return inner === '' ? `${head}/>` : `${head}>${inner}</${name}>`;
}

/** Lines or rings in one path. @param lines x, y a vertex, px */
export function path(lines: readonly Float64Array[], isClosed: boolean, look: Attributes): string {
  return element('path', { d: lines.map((line) => lineData(line, isClosed)).join(''), ...look });
}

/** Round dots in one path: lines without length under round caps. @param xy x, y a dot, px */
export function dots(xy: Float64Array, { colour, size, opacity }: DotLook, more: Attributes = {}): string {
  return element('path', {
    ...more,
    d: dotData(xy),
    fill: 'none',
    stroke: colour,
    'stroke-width': size,
    'stroke-linecap': 'round',
    'stroke-opacity': opacity,
  });
}

export interface TextLook {
  /** px */
  readonly size: number;
  readonly colour?: string;
  readonly anchor?: 'start' | 'middle' | 'end';
  readonly isBold?: boolean;
}

/** A line of text; `x`, `y` on its base line, px. */
export function text(words: string, x: number, y: number, look: TextLook): string {
  return element(
    'text',
    {
      x: pixels(x),
      y: pixels(y),
      'font-size': look.size,
      'font-weight': look.isBold ? 600 : undefined,
      'text-anchor': look.anchor,
      fill: look.colour ?? INK,
    },
    escapeXml(words),
  );
}

/** A number of pixels as short as can be. */
export const pixels = (value: number): string => steps(Math.round(value * STEPS_PER_PIXEL));

/** Relative after the first vertex, which halves the text; rounded before taking differences, so nothing drifts. */
function lineData(line: Float64Array, isClosed: boolean): string {
  let data = '';
  let [atX, atY] = [0, 0];
  for (let i = 0; i < line.length; i += 2) {
    const x = Math.round(line[i] * STEPS_PER_PIXEL);
    const y = Math.round(line[i + 1] * STEPS_PER_PIXEL);
    data += `${i === 0 ? 'M' : 'l'}${pair(x - atX, y - atY)}`;
    [atX, atY] = [x, y];
  }
  return isClosed && data !== '' ? `${data}z` : data;
}

function dotData(xy: Float64Array): string {
  const parts: string[] = [];
  let [atX, atY] = [0, 0];
  for (let i = 0; i < xy.length; i += 2) {
    const x = Math.round(xy[i] * STEPS_PER_PIXEL);
    const y = Math.round(xy[i + 1] * STEPS_PER_PIXEL);
    parts.push(`${i === 0 ? 'M' : 'm'}${pair(x - atX, y - atY)}h0`);
    [atX, atY] = [x, y];
  }
  return parts.join('');
}

function pair(x: number, y: number): string {
  const second = steps(y);
  return second.startsWith('-') ? `${steps(x)}${second}` : `${steps(x)} ${second}`;
}

/** Whole hundredths as a decimal without needless zeros: `.5`, `-1.25`, `3`. */
function steps(value: number): string {
  const whole = Math.trunc(Math.abs(value) / STEPS_PER_PIXEL);
  const rest = Math.abs(value) % STEPS_PER_PIXEL;
  const sign = value < 0 ? '-' : '';
  if (rest === 0) return `${sign}${whole}`;
  const decimals = `.${String(rest).padStart(2, '0').replace(/0$/, '')}`;
  return `${sign}${whole === 0 ? '' : whole}${decimals}`;
}
