import { Matrix4, type Quaternion, Vector3 } from 'three';

/** Faces of the cube with the direction a camera looks from; plan frame, z up. */
const FACES = {
  top: { label: 'Top', from: [0, 0, 1] },
  front: { label: 'Front', from: [0, -1, 0] },
  right: { label: 'Right', from: [1, 0, 0] },
  back: { label: 'Back', from: [0, 1, 0] },
  left: { label: 'Left', from: [-1, 0, 0] },
  bottom: { label: 'Below', from: [0, 0, -1] },
} as const satisfies Record<string, { label: string; from: readonly [number, number, number] }>;

/** A cube of six buttons that turns with the camera. Made of elements, so keys and screen readers reach it. */
export class ViewCube {
  readonly node = document.createElement('div');
  readonly #cube = document.createElement('div');

  /** @param onPick called with the direction to look from */
  constructor(onPick: (from: Vector3) => void) {
    this.node.className = 'view-cube';
    this.#cube.className = 'cube';
    for (const [name, { label, from }] of Object.entries(FACES)) {
      const face = document.createElement('button');
      face.type = 'button';
      face.className = `face face-${name}`;
      face.textContent = label;
      face.setAttribute('aria-label', `Look from ${name === 'bottom' ? 'below' : `the ${name}`}`);
      face.addEventListener('click', () => onPick(new Vector3(...from)));
      this.#cube.append(face);
    }
    this.node.append(this.#cube);
  }

  /** Turns the cube as a camera of this orientation sees it. CSS points y down, so y is flipped going in and out. */
  turn(camera: Quaternion): void {
    const seen = new Matrix4().makeRotationFromQuaternion(camera.clone().invert());
    const flip = new Matrix4().makeScale(1, -1, 1);
    const css = flip.clone().multiply(seen).multiply(flip);
    this.#cube.style.transform = `matrix3d(${css.elements.map((value) => value.toFixed(6)).join(',')})`;
  }
}
