import { type Quaternion, Vector3 } from 'three';
import type { Axis, Frame } from '../core/types.ts';

const SVG = 'http://www.w3.org/2000/svg';
const LETTERS = ['x', 'y', 'z'] as const;
/** Half the gizmo, and from its middle to an axis' end, px. */
const HALF = 56;
const REACH = 38;

export interface AxisEvents {
  /** Take this axis for up. */
  onUp(axis: Axis): void;
  /** Show the choice of axes at large. */
  onAxes(): void;
}

/** An end of one of the source's axes: a button that takes it for up. */
interface AxisEnd {
  readonly axis: Axis;
  readonly index: number;
  readonly sign: 1 | -1;
  readonly node: HTMLButtonElement;
}

/**
 * The source's three axes as the camera sees them, up marked; made of elements, so keys and screen readers reach it. What
 * is up, or what a press would do, is said beneath, where no axis ever points.
 */
export class AxisGizmo {
  readonly node = document.createElement('div');
  readonly #arms = LETTERS.map((letter) => {
    const arm = document.createElementNS(SVG, 'line');
    arm.setAttribute('class', `axis-arm axis-${letter}`);
    return arm;
  });
  readonly #ends: readonly AxisEnd[];
  readonly #caption = document.createElement('span');
  /** The source's axes in the plan frame. */
  #axes: readonly Vector3[] = [];
  #up: Axis = 'z';
  #camera: Quaternion | null = null;

  constructor(events: AxisEvents) {
    this.node.className = 'axis-gizmo';
    this.node.setAttribute('role', 'group');
    this.node.setAttribute('aria-label', 'Axes of the scan');
    this.node.hidden = true;
    const drawing = document.createElementNS(SVG, 'svg');
    drawing.setAttribute('viewBox', `${-HALF} ${-HALF} ${2 * HALF} ${2 * HALF}`);
    drawing.setAttribute('aria-hidden', 'true');
    drawing.append(...this.#arms);
    this.#ends = LETTERS.flatMap((_, index) =>
      ([1, -1] as const).map((sign) => makeEnd(index, sign, (axis) => events.onUp(axis))),
    );
    this.#caption.className = 'axis-caption';
    this.#caption.setAttribute('aria-hidden', 'true');
    this.node.append(drawing, ...this.#ends.map(({ node }) => node), this.#caption, makeMore(events));
    for (const { axis, node } of this.#ends) {
      for (const type of ['pointerenter', 'focus']) node.addEventListener(type, () => this.#say(axis));
      for (const type of ['pointerleave', 'blur']) node.addEventListener(type, () => this.#say(this.#up));
    }
  }

  /** Where the source's axes point in the plan frame, and which is up. */
  show({ rotation, up }: Pick<Frame, 'rotation' | 'up'>): void {
    this.#axes = LETTERS.map((_, k) => new Vector3(rotation[k], rotation[3 + k], rotation[6 + k]));
    this.#up = up;
    this.node.hidden = false;
    for (const { axis, node } of this.#ends) {
      const words = this.#wordsFor(axis);
      node.setAttribute('aria-label', words);
      node.title = words;
      node.setAttribute('aria-pressed', String(axis === up));
    }
    this.#say(up);
    if (this.#camera) this.turn(this.#camera);
  }

  /** Turns the axes as a camera of this orientation sees them. CSS points y down. */
  turn(camera: Quaternion): void {
    this.#camera = camera.clone();
    if (this.#axes.length === 0) return;
    const seen = this.#axes.map((axis) => axis.clone().applyQuaternion(camera.clone().invert()));
    for (const [k, tip] of seen.entries()) {
      this.#arms[k].setAttribute('x2', (REACH * tip.x).toFixed(1));
      this.#arms[k].setAttribute('y2', (-REACH * tip.y).toFixed(1));
    }
    for (const { index, sign, node } of this.#ends) {
      const { x, y, z } = seen[index].clone().multiplyScalar(sign);
      node.style.transform = `translate(${(REACH * x).toFixed(1)}px, ${(-REACH * y).toFixed(1)}px)`;
      // What is nearer to the eye lies above.
      node.style.zIndex = String(Math.round(10 * (z + 1)));
    }
  }

  #wordsFor(axis: Axis): string {
    return axis === this.#up ? `${axis} is up` : `Take ${axis} for up`;
  }

  #say(axis: Axis): void {
    this.#caption.textContent = this.#wordsFor(axis).replace('-', '−');
  }
}

function makeEnd(index: number, sign: 1 | -1, onUp: (axis: Axis) => void): AxisEnd {
  const letter = LETTERS[index];
  const axis: Axis = sign === 1 ? letter : `-${letter}`;
  const node = document.createElement('button');
  node.type = 'button';
  node.className = `axis-end axis-${letter}${sign === 1 ? ' is-positive' : ''}`;
  node.textContent = axis.replace('-', '−');
  node.dataset.axis = axis;
  node.addEventListener('click', () => onUp(axis));
  return { axis, index, sign, node };
}

/** For a finger the ends are too small: on a phone the whole gizmo leads to the choice. */
function makeMore({ onAxes }: AxisEvents): HTMLButtonElement {
  const more = document.createElement('button');
  more.type = 'button';
  more.className = 'axis-more';
  more.setAttribute('aria-label', 'Set the up axis');
  more.addEventListener('click', () => onAxes());
  return more;
}
