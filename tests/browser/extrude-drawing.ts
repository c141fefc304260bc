import { ExtrudeGeometry, ShapeUtils } from 'three';
import { SVGLoader } from 'three/examples/jsm/loaders/SVGLoader.js';
import { checkSolid } from '../../src/solid/check-solid.ts';
import { weld } from '../../src/solid/weld.ts';

/** What a path of plan.minimal.svg is once three has extruded it; metres, y up again. */
export interface Extruded {
  readonly id: string;
  readonly area: number;
  readonly volume: number;
  readonly isClosed: boolean;
  /** Least and greatest x, y, z. */
  readonly bounds: readonly number[];
}

/** Loads a drawing as anyone would, with three's SVGLoader in a browser, and extrudes every path of it. */
export function extrudeDrawing(svg: string, height: number): Extruded[] {
  return new SVGLoader().parse(svg).paths.map((path) => {
    const { node } = path.userData as { node: SVGPathElement };
    const shapes = path.toShapes();
    const area = shapes.reduce((sum, shape) => {
      const rings = [shape.getPoints(), ...shape.holes.map((hole) => hole.getPoints())];
      const [outer, ...holes] = rings.map((ring) => Math.abs(ShapeUtils.area(ring)));
      return holes.reduce((left, hole) => left - hole, sum + outer);
    }, 0);
    const geometry = new ExtrudeGeometry(shapes, { depth: height, bevelEnabled: false });
    const corners = Float64Array.from(geometry.getAttribute('position').array);
    for (let i = 1; i < corners.length; i += 3) corners[i] = -corners[i];
    const mesh = weld(corners, 1e-5);
    // Turning y over turns every triangle inside out.
    const indices = mesh.indices.toReversed();
    const group = { name: node.id, kind: 'wall', storey: 0, start: 0, count: indices.length } as const;
    const { volume, watertight } = checkSolid({ positions: mesh.positions, indices, groups: [group] });
    return { id: node.id, area, volume, isClosed: watertight, bounds: boundsOf(mesh.positions) };
  });
}

function boundsOf(positions: Float64Array): number[] {
  return [0, 1, 2].flatMap((axis) => {
    const values = positions.filter((_, i) => i % 3 === axis);
    return [Math.min(...values), Math.max(...values)];
  });
}
