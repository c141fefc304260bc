import { checkSolid } from '../../src/solid/check-solid.ts';
import { type PaperSet, runSet } from './paper-sets.ts';

/** Size of the model of a set. */
export interface MeshSize {
  readonly vertices: number;
  readonly faces: number;
  /** Every part is a closed two-manifold. */
  readonly isClosed: boolean;
}

/** By engine. */
export interface MeshSizes {
  readonly slabs: MeshSize;
  readonly bsp: MeshSize;
}

/** Walls and floor slab, the structure cut out of them, by both engines. */
export async function meshSizes(set: PaperSet): Promise<MeshSizes> {
  return { slabs: await meshSize(set, 'slabs'), bsp: await meshSize(set, 'bsp') };
}

async function meshSize(set: PaperSet, csg: 'slabs' | 'bsp'): Promise<MeshSize> {
  const { solid } = await runSet(set, { csg });
  return {
    vertices: solid.positions.length / 3,
    faces: solid.indices.length / 3,
    isClosed: checkSolid(solid).watertight,
  };
}
