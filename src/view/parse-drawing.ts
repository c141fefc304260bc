import { FloorPlanError } from '../core/errors.ts';

/** What the page's drawing may be made of; anything else could run code or reach out of the page. */
const ALLOWED = new Set([
  'svg',
  'g',
  'defs',
  'title',
  'desc',
  'metadata',
  'path',
  'rect',
  'circle',
  'ellipse',
  'line',
  'polyline',
  'polygon',
  'text',
  'tspan',
  'pattern',
  'clipPath',
  'marker',
  'symbol',
  'use',
]);
const SVG = 'http://www.w3.org/2000/svg';

/** Maps plan metres to millimetres on the sheet: x′ = a·x + c·y + e, y′ = b·x + d·y + f. */
export type SheetTransform = readonly [a: number, b: number, c: number, d: number, e: number, f: number];

/** A picture as nodes of this document. */
export interface Picture {
  readonly svg: SVGSVGElement;
  /** Size of its view box. */
  readonly width: number;
  readonly height: number;
}

/** A picture of the plan's sheet; sizes in mm. */
export interface Drawing extends Picture {
  readonly planToSheet: SheetTransform;
}

/**
 * Turns SVG text this program has written into nodes of this document, without `innerHTML`.
 *
 * @throws input/malformed where the text is no SVG or holds anything but shapes and text
 */
export function parsePicture(text: string): Picture {
  const parsed = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  if (parsed.localName !== 'svg' || parsed.namespaceURI !== SVG)
    throw refused('the root is not an svg element');
  refuseForeign(parsed);
  const svg = document.importNode(parsed, true) as unknown as SVGSVGElement;
  const { width, height } = svg.viewBox.baseVal;
  return { svg, width, height };
}

/**
 * The drawing of a plan, as {@link parsePicture} turns it into nodes.
 *
 * @throws input/malformed as there, or where the plan transform is missing
 */
export function parseDrawing(text: string): Drawing {
  const picture = parsePicture(text);
  const numbers = (picture.svg.dataset.planToSheet ?? '').trim().split(/\s+/).map(Number);
  if (numbers.length !== 6 || !numbers.every(Number.isFinite))
    throw refused('data-plan-to-sheet is not six numbers');
  return { ...picture, planToSheet: numbers as unknown as SheetTransform };
}

function refuseForeign(root: Element): void {
  for (const element of [root, ...root.querySelectorAll('*')]) {
    const isKnown = element.namespaceURI !== SVG || ALLOWED.has(element.localName);
    const isPlain = element.namespaceURI === SVG || element.closest('metadata') !== null;
    if (!isKnown || !isPlain) throw refused(`<${element.localName}> is not allowed`);
    for (const { name, value } of element.attributes) {
      const isLink = /(^|:)href$/i.test(name) && !value.startsWith('#');
      const isReference = /url\((?!#)/i.test(value);
      if (/^on/i.test(name) || name === 'style' || isLink || isReference)
        throw refused(`the attribute ${name} is not allowed`);
    }
  }
}

function refused(found: string): FloorPlanError {
  return new FloorPlanError('input/malformed', `Expected a drawing of shapes and text, but ${found}.`, {
    hint: 'Show only drawings this program has written.',
  });
}
