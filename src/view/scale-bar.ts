import type { DisplayUnit } from '../write/sheet/measure-words.ts';
import { formatLength, roundLengths } from './measure.ts';

/** The bar is the longest round length below this, px. */
const LONGEST = 140;

/** A scale bar that always shows a round length. */
export class ScaleBar {
  readonly node = document.createElement('div');
  readonly #label = document.createElement('span');

  constructor() {
    this.node.className = 'scale-bar';
    this.#label.className = 'scale-bar-label';
    const rule = document.createElement('span');
    rule.className = 'scale-bar-rule';
    this.node.append(this.#label, rule);
  }

  show(pixelsPerMetre: number, unit: DisplayUnit): void {
    const lengths = roundLengths(unit);
    const metres = lengths.findLast((length) => length * pixelsPerMetre <= LONGEST) ?? lengths[0];
    this.node.style.setProperty('--length', `${metres * pixelsPerMetre}px`);
    this.#label.textContent = formatLength(metres, unit);
  }
}
