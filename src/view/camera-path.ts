import { type Box3, type PerspectiveCamera, Vector3 } from 'three';

/** Where a camera stands: it looks at `target` from `direction` (unit, away from the target), `distance` metres off. */
export interface Stand {
  readonly target: Vector3;
  readonly direction: Vector3;
  readonly distance: number;
}

/** From the south-east at the angle of an isometric drawing: the cube's diagonal. */
export const ISOMETRIC = new Vector3(1, -1, 1).normalize();
/** Straight down, with a hair of south so that the plan's y points up the screen. */
export const OVERHEAD = new Vector3(0, -1e-4, 1).normalize();

/** Length of a glide, ms. */
const GLIDE = 200;
/** Room around a fitted box. */
const AIR = 1.08;

/** The nearest stand in `direction` from which the whole box is in view. */
export function standFor(box: Box3, direction: Vector3, camera: PerspectiveCamera): Stand {
  const target = box.getCenter(new Vector3());
  const right = new Vector3().crossVectors(camera.up, direction).normalize();
  const up = new Vector3().crossVectors(direction, right);
  const tall = Math.tan((camera.fov * Math.PI) / 360);
  const wide = tall * camera.aspect;
  let distance = 0;
  for (let corner = 0; corner < 8; corner++) {
    const point = new Vector3(
      corner & 1 ? box.max.x : box.min.x,
      corner & 2 ? box.max.y : box.min.y,
      corner & 4 ? box.max.z : box.min.z,
    ).sub(target);
    const across = Math.max(Math.abs(point.dot(right)) / wide, Math.abs(point.dot(up)) / tall);
    distance = Math.max(distance, AIR * across + point.dot(direction));
  }
  return { target, direction: direction.clone(), distance };
}

/** Moves smoothly from one stand to another and calls `onStep` on the way; at once under reduced motion. */
export class Glide {
  #frame = 0;

  run(from: Stand, to: Stand, onStep: (stand: Stand) => void): void {
    cancelAnimationFrame(this.#frame);
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
      onStep(to);
      return;
    }
    const start = performance.now();
    const step = (now: number) => {
      const t = Math.min(1, Math.max(0, (now - start) / GLIDE));
      onStep(t === 1 ? to : between(from, to, t * t * (3 - 2 * t)));
      if (t < 1) this.#frame = requestAnimationFrame(step);
    };
    this.#frame = requestAnimationFrame(step);
  }

  stop(): void {
    cancelAnimationFrame(this.#frame);
  }
}

function between(from: Stand, to: Stand, t: number): Stand {
  const direction = from.direction.clone().lerp(to.direction, t);
  // Opposite directions meet in nothing half way; any way round will do.
  if (direction.lengthSq() < 1e-6) direction.copy(OVERHEAD);
  return {
    target: from.target.clone().lerp(to.target, t),
    direction: direction.normalize(),
    distance: from.distance + (to.distance - from.distance) * t,
  };
}
