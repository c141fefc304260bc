import {
  Color,
  DirectionalLight,
  HemisphereLight,
  type Mesh,
  type Object3D,
  PerspectiveCamera,
  Plane,
  type Points,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import type { Solid } from '../core/types.ts';
import { makeCloud } from './scene-cloud.ts';
import type { SceneColours } from './scene-colours.ts';
import { makeGrid } from './scene-grid.ts';
import { SceneModel } from './scene-model.ts';

/** What of the scene is shown. */
export interface SceneLayers {
  readonly model: boolean;
  readonly cloud: boolean;
  readonly grid: boolean;
  readonly ceiling: boolean;
}

/** Everything that can be asked of a {@link Painter}; plain, so that it can be sent to a worker. */
export type PaintOrder =
  | {
      readonly kind: 'content';
      /** Null while only points are known. */
      readonly solid: Solid | null;
      /** x, y, z a point, m, the solid's frame. */
      readonly positions: Float32Array;
      /** r, g, b a point, 0 to 255. */
      readonly colour: Uint8Array | undefined;
      /** The grid lies under these: least and greatest x, y, z. */
      readonly bounds: readonly number[];
    }
  | {
      readonly kind: 'layers';
      readonly layers: SceneLayers;
      /** Points higher than this are not drawn, m. */
      readonly cut: number;
    }
  | { readonly kind: 'colours'; readonly colours: SceneColours }
  | {
      readonly kind: 'pose';
      /** Size of the canvas, px, and device pixels a px. */
      readonly width: number;
      readonly height: number;
      readonly ratio: number;
      /** Vertical field of view, degrees. */
      readonly fov: number;
      readonly near: number;
      readonly far: number;
      readonly position: readonly number[];
      readonly quaternion: readonly number[];
    };

type Content = Extract<PaintOrder, { kind: 'content' }>;
type Pose = Extract<PaintOrder, { kind: 'pose' }>;

/** Light from the sky, warmer from the ground, and one soft key from the front left; three's units. */
const SKY = { sky: '#ffffff', ground: '#c9c2b6', strength: 2.3 } as const;
const KEY = { from: [-1, -2, 3], strength: 1.2 } as const;

/**
 * Draws the scene on a canvas, the page's own or one handed to a worker. It draws only when something was asked,
 * once a frame, however much was.
 *
 * In a worker since starting WebGL and compiling shaders hold up their thread: on a machine without a graphics card
 * the page was deaf for 0.9 s, and now is not.
 */
export class Painter {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera();
  readonly #cut = new Plane(new Vector3(0, 0, -1), Number.MAX_VALUE);
  #model: SceneModel | null = null;
  #cloud: Points | null = null;
  #grid: ReturnType<typeof makeGrid> | null = null;
  #layers: SceneLayers | null = null;
  #colours: SceneColours | null = null;
  /** Size and sharpness of the canvas; empty before there is a pose. */
  #shape = '';
  #pending = 0;

  /** @throws Error where there is no WebGL 2 */
  constructor(canvas: HTMLCanvasElement | OffscreenCanvas) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: true });
    this.#renderer.localClippingEnabled = true;
    // Asking a shader for its errors waits for the graphics card.
    this.#renderer.debug.checkShaderErrors = false;
    const sky = new HemisphereLight(SKY.sky, SKY.ground, SKY.strength);
    sky.position.set(0, 0, 1);
    const key = new DirectionalLight(SKY.sky, KEY.strength);
    key.position.set(...KEY.from);
    this.#scene.add(sky, key);
  }

  take(order: PaintOrder): void {
    switch (order.kind) {
      case 'content':
        this.#fill(order);
        break;
      case 'layers':
        this.#layers = order.layers;
        this.#cut.constant = order.cut;
        break;
      case 'colours':
        this.#colours = order.colours;
        break;
      case 'pose':
        this.#place(order);
        break;
    }
    this.#dress();
    if (this.#pending === 0) this.#pending = requestAnimationFrame(() => this.#draw());
  }

  /** Frees the graphics card: browsers give a page only a few contexts. */
  dispose(): void {
    cancelAnimationFrame(this.#pending);
    this.#clear();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }

  #fill({ solid, positions, colour, bounds }: Content): void {
    this.#clear();
    this.#cloud = makeCloud(positions, colour, this.#cut);
    this.#scene.add(this.#cloud);
    if (!solid) return;
    this.#model = new SceneModel(solid);
    this.#grid = makeGrid(bounds);
    this.#scene.add(this.#model.node, this.#grid);
  }

  #place({ width, height, ratio, fov, near, far, position, quaternion }: Pose): void {
    const [x, y, z, w] = quaternion;
    const shape = `${width} ${height} ${ratio}`;
    // A canvas that is given its size loses its picture and its memory, even where the size is the same.
    if (shape !== this.#shape) {
      this.#shape = shape;
      this.#renderer.setPixelRatio(ratio);
      this.#renderer.setSize(width, height, false);
    }
    Object.assign(this.#camera, { fov, near, far, aspect: width / height });
    this.#camera.position.fromArray(position);
    this.#camera.quaternion.set(x, y, z, w);
    this.#camera.updateProjectionMatrix();
  }

  /** Layers and colours hold for what comes later, too. */
  #dress(): void {
    if (this.#layers) {
      const { model, cloud, grid, ceiling } = this.#layers;
      if (this.#cloud) this.#cloud.visible = cloud;
      if (this.#grid) this.#grid.visible = grid;
      if (this.#model) this.#model.node.visible = model;
      if (this.#model) this.#model.hasCeiling = ceiling;
    }
    if (this.#colours) {
      this.#scene.background = new Color(this.#colours.ground);
      this.#model?.recolour(this.#colours);
      this.#grid?.material.color.set(this.#colours.grid);
    }
  }

  #draw(): void {
    this.#pending = 0;
    if (this.#shape !== '') this.#renderer.render(this.#scene, this.#camera);
  }

  #clear(): void {
    for (const node of [this.#model?.node, this.#cloud, this.#grid]) if (node) release(node);
    this.#model = null;
    this.#cloud = null;
    this.#grid = null;
  }
}

function release(node: Object3D): void {
  node.traverse((part) => {
    const { geometry, material } = part as Partial<Mesh>;
    geometry?.dispose();
    for (const each of [material ?? []].flat()) each.dispose();
  });
  node.removeFromParent();
}
