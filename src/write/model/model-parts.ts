import { combine } from '../../core/geometry/areas.ts';
import type { Options } from '../../core/params.ts';
import type { Solid, SolidGroup, Storey } from '../../core/types.ts';
import { extrude } from '../../solid/extrude.ts';
import { structureName } from '../../solid/make-solid.ts';
import { openingFrames } from '../../solid/opening-frames.ts';
import { separatePinches } from '../../solid/pinches.ts';
import type { TriangleMesh } from '../../solid/triangle-mesh.ts';
import type { Product } from '../plan-writer.ts';

/** How a material looks in every format that can say it. */
interface Material {
  /** Linear RGB, 0 to 1. */
  readonly colour: readonly [red: number, green: number, blue: number];
  /** 1 where nothing shines through. */
  readonly opacity: number;
  /** 0 a mirror, 1 chalk. */
  readonly roughness: number;
}

/** Clay walls, paper floors, muted blue structures, pale timber, glass. */
export const MATERIALS = {
  wall: { colour: [0.76, 0.74, 0.7], opacity: 1, roughness: 0.9 },
  floor: { colour: [0.91, 0.9, 0.87], opacity: 1, roughness: 0.9 },
  ceiling: { colour: [0.91, 0.9, 0.87], opacity: 1, roughness: 0.9 },
  secondary: { colour: [0.36, 0.47, 0.7], opacity: 1, roughness: 0.9 },
  frame: { colour: [0.5, 0.42, 0.32], opacity: 1, roughness: 0.6 },
  glass: { colour: [0.62, 0.75, 0.8], opacity: 0.35, roughness: 0.05 },
} as const satisfies Record<string, Material>;

export type MaterialName = keyof typeof MATERIALS;

/** A thing of the model: a storey's walls that hang together, a slab, a column, a window. */
export interface ModelPart {
  /** Unique and plain ASCII: `wall-0`, `column-1`, `door-3`. */
  readonly name: string;
  /** Index in the plan's storeys. */
  readonly storey: number;
  /** What a format with room for it says of the part beside its shape. */
  readonly facts: Readonly<Record<string, string | number>>;
  /** Metres, plan frame; each a closed two-manifold. */
  readonly surfaces: readonly { readonly material: MaterialName; readonly mesh: TriangleMesh }[];
}

/**
 * The model as its files hold it: every group of the solid, columns that the plan cuts out of its area, which stand
 * there all the same, and what fills doors and windows.
 */
export function modelParts({ plan, solid }: Pick<Product, 'plan' | 'solid'>): ModelPart[] {
  const parts = solid.groups.map((group): ModelPart => {
    const { name, kind } = group;
    const storey = plan.storeys.findIndex(({ index }) => index === group.storey);
    return { name, storey, facts: { kind }, surfaces: [{ material: kind, mesh: meshOf(solid, group) }] };
  });
  const numbers = new Map<string, number>();
  for (const { name } of parts) {
    const [, base, number] = /^(.*)-(\d+)$/.exec(name)!;
    numbers.set(base, Math.max(numbers.get(base) ?? 0, Number(number) + 1));
  }
  const next = (base: string): string => {
    const number = numbers.get(base) ?? 0;
    numbers.set(base, number + 1);
    return `${base}-${number}`;
  };
  const more = plan.storeys.flatMap((storey, i) =>
    [...cutOutColumns(storey, plan.options), ...framesOf(storey)].map(({ base, ...part }) => ({
      ...{ name: next(base), storey: i, ...part },
    })),
  );
  return [...parts, ...more];
}

type Unnamed = Pick<ModelPart, 'facts' | 'surfaces'> & { readonly base: string };

/** They fill the holes that they leave in the slabs; a shaft that is cut out stays a hole. */
function cutOutColumns(
  { secondary, floor, height }: Storey,
  { floorSlab, ceilingSlab, slabThickness }: Options,
): Unnamed[] {
  const low = floor - (floorSlab ? slabThickness : 0);
  const high = floor + height + (ceilingSlab ? slabThickness : 0);
  return secondary.flatMap(({ outline, operation, type }) => {
    if (operation !== 'subtract' || type !== 'column') return [];
    return separatePinches(combine('union', [outline])).map((polygon) => ({
      base: structureName(type),
      facts: { kind: 'secondary' },
      surfaces: [{ material: 'secondary' as const, mesh: extrude(polygon, low, high) }],
    }));
  });
}

function framesOf(storey: Storey): Unnamed[] {
  return openingFrames(storey).map(({ opening, frame, pane }) => {
    const { type, sill, head, from, to, confidence } = opening;
    const width = Math.hypot(to[0] - from[0], to[1] - from[1]);
    return {
      base: type,
      facts: { kind: type, opening: storey.openings.indexOf(opening), width, sill, head, confidence },
      surfaces: [
        { material: 'frame' as const, mesh: frame },
        ...(pane === null ? [] : [{ material: 'glass' as const, mesh: pane }]),
      ],
    };
  });
}

/** A group with vertices of its own; the order of first use. */
function meshOf({ positions, indices }: Solid, { start, count }: SolidGroup): TriangleMesh {
  const numbers = new Map<number, number>();
  const own = indices.slice(start, start + count).map((vertex) => {
    const number = numbers.get(vertex) ?? numbers.size;
    numbers.set(vertex, number);
    return number;
  });
  const places = new Float64Array(3 * numbers.size);
  for (const [vertex, number] of numbers) {
    places.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * number);
  }
  return { positions: places, indices: own };
}

/** Corners and triangles of all parts. */
export function meshSize(meshes: readonly TriangleMesh[]): { vertices: number; triangles: number } {
  let [vertices, triangles] = [0, 0];
  for (const { positions, indices } of meshes) {
    vertices += positions.length / 3;
    triangles += indices.length / 3;
  }
  return { vertices, triangles };
}
