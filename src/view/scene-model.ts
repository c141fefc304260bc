import {
  BufferAttribute,
  BufferGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
} from 'three';
import type { Solid, SolidGroup } from '../core/types.ts';
import { featureEdges, triangleNormals } from './feature-edges.ts';
import type { SceneColours } from './scene-colours.ts';

/** A face counts as a cut top when its normal points up this steeply: within 10° of vertical. */
const UPWARD = Math.cos(Math.PI / 18);
const EDGE_OPACITY = 0.55;

/** A clay model of a solid: matt faces, darker cut tops, thin edge lines. */
export class SceneModel {
  readonly node = new Group();
  readonly #materials = {
    wall: clay(),
    cut: clay(),
    floor: clay(),
    structure: clay(),
    edge: new LineBasicMaterial({ transparent: true, opacity: EDGE_OPACITY }),
  };
  readonly #ceilings = new Group();

  constructor(solid: Solid) {
    const positions = new BufferAttribute(new Float32Array(solid.positions), 3);
    const normals = triangleNormals(solid);
    this.node.add(this.#ceilings);
    for (const group of solid.groups) {
      const parent = group.kind === 'ceiling' ? this.#ceilings : this.node;
      parent.add(...this.#meshes(solid, group, positions, normals), this.#edges(solid, group, normals));
    }
  }

  set hasCeiling(isShown: boolean) {
    this.#ceilings.visible = isShown;
  }

  recolour(colours: SceneColours): void {
    for (const name of ['wall', 'cut', 'floor', 'structure', 'edge'] as const) {
      this.#materials[name].color.set(colours[name]);
    }
  }

  #meshes({ indices }: Solid, group: SolidGroup, positions: BufferAttribute, normals: Float32Array): Mesh[] {
    const { kind, start, count } = group;
    const tops: number[] = [];
    const sides: number[] = [];
    for (let t = start; t < start + count; t += 3) {
      const isTop = kind === 'wall' && normals[t + 2] > UPWARD;
      (isTop ? tops : sides).push(indices[t], indices[t + 1], indices[t + 2]);
    }
    const face = kind === 'wall' ? 'wall' : kind === 'secondary' ? 'structure' : 'floor';
    return (
      [
        [sides, this.#materials[face]],
        [tops, this.#materials.cut],
      ] as const
    )
      .filter(([corners]) => corners.length > 0)
      .map(([corners, material]) => {
        const geometry = new BufferGeometry();
        geometry.setAttribute('position', positions);
        geometry.setIndex(corners);
        return new Mesh(geometry, material);
      });
  }

  #edges(solid: Solid, { start, count }: SolidGroup, normals: Float32Array): LineSegments {
    const geometry = new BufferGeometry();
    const ends = featureEdges(solid, normals, start, start + count);
    geometry.setAttribute('position', new BufferAttribute(ends, 3));
    return new LineSegments(geometry, this.#materials.edge);
  }
}

/** Faces step back a little so that the edge lines on them are not eaten. */
function clay(): MeshLambertMaterial {
  return new MeshLambertMaterial({
    flatShading: true,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
}
