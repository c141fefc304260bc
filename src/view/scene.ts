import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Mesh,
  PerspectiveCamera,
  Raycaster,
  Vector2,
  Vector3,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { FloorPlanError } from '../core/errors.ts';
import type { Frame, Solid } from '../core/types.ts';
import { type AxisEvents, AxisGizmo } from './axis-gizmo.ts';
import { Glide, ISOMETRIC, OVERHEAD, type Stand, standFor } from './camera-path.ts';
import { SceneCanvas } from './scene-canvas.ts';
import { readColours } from './scene-colours.ts';
import type { SceneLayers } from './scene-painter.ts';
import { ViewCube } from './view-cube.ts';

export type { SceneLayers } from './scene-painter.ts';

export interface SceneContent {
  readonly solid: Solid;
  /** x, y, z a point, m, the solid's frame. */
  readonly positions: Float32Array;
  /** r, g, b a point, 0 to 255. */
  readonly colour?: Uint8Array | undefined;
  /** Height of the top of the walls, m; points of the ceiling are hidden with the ceiling. */
  readonly top: number;
  /** Where the source's axes point. */
  readonly frame: Pick<Frame, 'rotation' | 'up'>;
}

export interface SceneEvents extends AxisEvents {
  /** Nothing can be drawn: environment/webgl. */
  onFailed(error: FloorPlanError): void;
}

/** A long lens: near to a drawing, yet nearer walls still look nearer. Degrees. */
const FIELD_OF_VIEW = 26;
/** The points of ceilings lie within this of the highest: suspended ones of corridors hang lower. m */
const CEILING_DEPTH = 0.45;
/** A double click halves the way to what was clicked; a key goes a quarter nearer or further. */
const FOCUS = 0.5;
const NEARER = 0.8;
/** What is drawn reaches this far around the model, and no nearer to the eye than this; times the model's size. */
const DEPTH = 2;
const NEAREST = 0.001;
/** More pixels a px than this cost time no eye sees. */
const SHARPEST = 2;

/** The 3D view: a clay model, the cloud and a metre grid. The page moves the camera, a {@link SceneCanvas} draws. */
export class SceneView {
  readonly #host: HTMLElement;
  readonly #surface = document.createElement('div');
  readonly #canvas: SceneCanvas;
  readonly #camera = new PerspectiveCamera(FIELD_OF_VIEW);
  readonly #controls: OrbitControls;
  readonly #cube: ViewCube;
  readonly #axes: AxisGizmo;
  readonly #glide = new Glide();
  readonly #listening = new AbortController();
  readonly #resize: ResizeObserver;
  /** What the pointer can hit. */
  readonly #target = new Mesh(new BufferGeometry());
  #box = new Box3();
  #top = Number.MAX_VALUE;
  #layers: SceneLayers;
  #hasModel = false;
  #pending = 0;
  #ink = '';

  /** @param host an empty element; it gets the keyboard focus and the gestures */
  constructor(host: HTMLElement, layers: SceneLayers, events: SceneEvents) {
    this.#host = host;
    this.#layers = layers;
    host.tabIndex = 0;
    host.setAttribute('role', 'group');
    host.setAttribute(
      'aria-label',
      'Model. Arrow keys move, with Shift they turn, plus and minus zoom, 0 shows all.',
    );
    this.#surface.className = 'surface';
    this.#camera.up.set(0, 0, 1);
    this.#cube = new ViewCube((from) => this.lookFrom(from.z > 0.5 ? OVERHEAD : from));
    this.#axes = new AxisGizmo(events);
    host.append(this.#surface, this.#cube.node, this.#axes.node);
    this.#canvas = new SceneCanvas(this.#surface, (error) => events.onFailed(error));
    this.#controls = new OrbitControls(this.#camera, this.#surface);
    this.#controls.zoomToCursor = true;
    this.#controls.listenToKeyEvents(host);
    this.#controls.addEventListener('change', this.#invalidate);
    this.#listen();
    this.#resize = new ResizeObserver(() => this.#size());
    this.#resize.observe(host);
    this.#size();
  }

  /** Shows a model and its points; the camera stays where a model was shown before, unless it `isNew`. */
  show({ solid, positions, colour, top, frame }: SceneContent, isNew: boolean): void {
    this.#top = top;
    this.#axes.show(frame);
    this.#aimAt(solid);
    this.#box = boundsOf(solid.positions.length > 0 ? solid.positions : positions);
    this.#fill(solid, positions, colour);
    this.showLayers(this.#layers);
    if (isNew || !this.#hasModel) this.#stand(standFor(this.#box, ISOMETRIC, this.#camera));
    this.#hasModel = true;
  }

  /** Shows points alone while a scan is being read; source units, any axes. */
  preview(positions: Float32Array): void {
    if (this.#hasModel) return;
    this.#box = boundsOf(positions);
    this.#fill(null, positions, undefined);
    this.#stand(standFor(this.#box, ISOMETRIC, this.#camera));
  }

  showLayers(layers: SceneLayers): void {
    this.#layers = layers;
    const cut = layers.ceiling ? Number.MAX_VALUE : this.#top - CEILING_DEPTH;
    this.#canvas.send({ kind: 'layers', layers, cut });
  }

  /** Glides to where everything is seen from `direction`. */
  lookFrom(direction: Vector3): void {
    if (!this.#box.isEmpty()) this.#glideTo(standFor(this.#box, direction, this.#camera));
  }

  lookFromAbove(): void {
    this.lookFrom(OVERHEAD);
  }

  fit(): void {
    this.lookFrom(ISOMETRIC);
  }

  dispose(): void {
    cancelAnimationFrame(this.#pending);
    this.#glide.stop();
    this.#listening.abort();
    this.#resize.disconnect();
    this.#controls.stopListenToKeyEvents();
    this.#controls.dispose();
    this.#canvas.dispose();
    this.#host.replaceChildren();
  }

  #fill(solid: Solid | null, positions: Float32Array, colour: Uint8Array | undefined): void {
    const { min, max } = this.#box;
    const bounds = [...min.toArray(), ...max.toArray()];
    this.#canvas.send({ kind: 'content', solid, positions, colour, bounds });
  }

  #size(): void {
    const { clientWidth, clientHeight } = this.#host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#camera.aspect = clientWidth / clientHeight;
    this.#camera.updateProjectionMatrix();
    this.#invalidate();
  }

  readonly #invalidate = (): void => {
    if (this.#pending === 0) this.#pending = requestAnimationFrame(() => this.#draw());
  };

  #draw(): void {
    this.#pending = 0;
    const { clientWidth: width, clientHeight: height } = this.#host;
    if (width === 0 || height === 0 || this.#box.isEmpty()) return;
    this.#recolour();
    this.#cube.turn(this.#camera.quaternion);
    this.#axes.turn(this.#camera.quaternion);
    // Near and far planes close around the model, so that depth stays fine when it is small on screen.
    const size = this.#box.getSize(new Vector3()).length();
    const off = this.#camera.position.distanceTo(this.#box.getCenter(new Vector3()));
    this.#canvas.send({
      kind: 'pose',
      width,
      height,
      ratio: Math.min(SHARPEST, globalThis.devicePixelRatio),
      fov: FIELD_OF_VIEW,
      near: Math.max(off - DEPTH * size, NEAREST * size),
      far: off + DEPTH * size,
      position: this.#camera.position.toArray(),
      quaternion: this.#camera.quaternion.toArray(),
    });
  }

  #recolour(): void {
    const ink = getComputedStyle(this.#host).color;
    if (ink === this.#ink) return;
    this.#ink = ink;
    this.#canvas.send({ kind: 'colours', colours: readColours(this.#host) });
  }

  #listen(): void {
    const { signal } = this.#listening;
    this.#surface.addEventListener('pointerdown', (event) => this.#pivot(event), { signal, capture: true });
    this.#surface.addEventListener('dblclick', (event) => this.#focus(event), { signal });
    this.#host.addEventListener('keydown', (event) => this.#key(event), { signal });
    // The host's colour has a transition, so its end tells that the theme changed.
    const recolour = ({ target }: Event) => target === this.#host && this.#invalidate();
    this.#host.addEventListener('transitionend', recolour, { signal });
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const acts: Record<string, () => void> = {
      '0': () => this.fit(),
      '+': () => this.#dolly(NEARER),
      '=': () => this.#dolly(NEARER),
      '-': () => this.#dolly(1 / NEARER),
    };
    const act = acts[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  #dolly(factor: number): void {
    const stand = this.#where();
    this.#glideTo({ ...stand, distance: stand.distance * factor });
  }

  /** Turning goes around what is under the pointer: the target moves along the line of sight to that depth. */
  #pivot(event: PointerEvent): void {
    this.#glide.stop();
    const hit = this.#hit(event);
    if (!hit) return;
    const { direction } = this.#where();
    const depth = this.#camera.position.clone().sub(hit).dot(direction);
    this.#controls.target.copy(this.#camera.position).addScaledVector(direction, -depth);
  }

  #focus(event: MouseEvent): void {
    const hit = this.#hit(event);
    if (!hit) return;
    const { direction, distance } = this.#where();
    this.#glideTo({ target: hit, direction, distance: distance * FOCUS });
  }

  #hit({ clientX, clientY }: MouseEvent): Vector3 | null {
    if (!this.#layers.model || !this.#hasModel) return null;
    const { left, top, width, height } = this.#host.getBoundingClientRect();
    const caster = new Raycaster();
    const pointer = new Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height);
    this.#camera.updateMatrixWorld();
    caster.setFromCamera(pointer, this.#camera);
    return caster.intersectObject(this.#target)[0]?.point ?? null;
  }

  /** The pointer hits what is seen: everything but ceilings. */
  #aimAt({ positions, indices, groups }: Solid): void {
    const seen = groups
      .filter(({ kind }) => kind !== 'ceiling')
      .flatMap(({ start, count }) => [...indices.subarray(start, start + count)]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
    geometry.setIndex(seen);
    this.#target.geometry = geometry;
  }

  #where(): Stand {
    const target = this.#controls.target.clone();
    const offset = this.#camera.position.clone().sub(target);
    return { target, distance: offset.length(), direction: offset.normalize() };
  }

  #stand({ target, direction, distance }: Stand): void {
    this.#camera.position.copy(target).addScaledVector(direction, distance);
    this.#controls.target.copy(target);
    this.#controls.update();
    this.#invalidate();
  }

  #glideTo(stand: Stand): void {
    this.#glide.run(this.#where(), stand, (step) => this.#stand(step));
  }
}

/** @param positions x, y, z a point */
function boundsOf(positions: Float32Array | Float64Array): Box3 {
  return new Box3().setFromArray(positions);
}
