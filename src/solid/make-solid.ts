import { FloorPlanError } from '../core/errors.ts';
import { combine } from '../core/geometry/areas.ts';
import type { Options } from '../core/params.ts';
import type {
  FloorPlan,
  Polygon,
  SecondaryBoundary,
  Solid,
  SolidGroup,
  Storey,
  Warning,
} from '../core/types.ts';
import { extrude } from './extrude.ts';
import { layeredShells } from './layers.ts';
import { openingBoxes } from './opening-boxes.ts';
import type { Engine, Part } from './part.ts';
import { carve, footprint, wallArea } from './sections.ts';
import { openEdges, type TriangleMesh } from './triangle-mesh.ts';

/**
 * Raises a plan into a model ([Stojanovic19] §3.2): walls as vertical prisms, each secondary boundary subtracted from
 * walls and slabs, added to them, or kept as a solid of its own, a slab under and, if asked for, over the footprint.
 * Openings are cut out of the walls (§3: a door as a CSG operation).
 *
 * The engine `slabs` cuts in the plane and extrudes: exact, since everything here is vertical. `bsp` is the paper's
 * Boolean operations on BSP trees; a part it leaves open is made by `slabs` instead, with a warning.
 *
 * @param warn takes warnings: `solid/bsp-open`
 * @returns metres, plan frame; every group a closed two-manifold
 * @throws input/degenerate when a storey has no height
 */
export async function makeSolid(
  plan: FloorPlan,
  options: Options,
  warn: (warning: Warning) => void = () => {},
): Promise<Solid> {
  const parts = plan.storeys.flatMap((storey) => partsOf(storey, options));
  const bsp = options.csg === 'bsp' ? (await import('./bsp-shells.ts')).bspShells : null;
  const shells = parts.flatMap((part) => {
    const isCut = part.changes.length > 0 || part.openings.length > 0;
    const engine = bsp !== null && isCut ? closedOr(bsp, slabShells, warn) : slabShells;
    return engine(part).map((mesh) => ({ mesh, part }));
  });
  return joinShells(shells);
}

/** The exact engine: Booleans in the plane, then extrusion. */
const slabShells: Engine = (part) =>
  part.openings.length > 0
    ? layeredShells(part)
    : carve(part.base, part.changes).map((polygon) => extrude(polygon, part.low, part.high));

function partsOf(storey: Storey, options: Options): Part[] {
  const { index, floor, height, secondary } = storey;
  if (!(height > 0)) {
    throw new FloorPlanError(
      'input/degenerate',
      `Storey ${index}: expected a height above 0 m, found ${height}`,
      {
        hint: 'Give the wall height, e.g. --wall-height 2.5.',
        detail: { storey: index },
      },
    );
  }
  const changes = secondary.filter(({ operation }) => operation !== 'independent');
  const ceiling = floor + height;
  const slab = options.slabThickness;
  const walls = wallArea(storey);
  const parts: Part[] = [];
  const add = (
    kind: Part['kind'],
    base: readonly Polygon[],
    [low, high]: readonly [number, number],
    name: string = kind,
  ) =>
    parts.push({
      ...{ name, kind, storey: index, base, low, high },
      changes: kind === 'secondary' ? [] : changes,
      openings: kind === 'wall' ? openingBoxes(storey) : [],
    });
  add('wall', walls, [floor, ceiling]);
  if (options.floorSlab) add('floor', footprint(storey), [floor - slab, floor]);
  if (options.ceilingSlab) add('ceiling', footprint(storey), [ceiling, ceiling + slab]);
  for (const { outline, operation, type } of secondary) {
    if (operation !== 'independent') continue;
    add('secondary', combine('union', [outline]), [floor, ceiling], structureName(type));
  }
  return parts;
}

/** What nodes of structures are called: column, shaft, structure. */
export function structureName(type: SecondaryBoundary['type']): string {
  return type === 'other' ? 'structure' : type;
}

function closedOr(engine: Engine, fallback: Engine, warn: (warning: Warning) => void): Engine {
  return (part) => {
    const shells = engine(part);
    if (shells.every(({ indices }) => openEdges(indices).length === 0)) return shells;
    warn({
      code: 'solid/bsp-open',
      message: `The BSP engine left the ${part.kind} of storey ${part.storey} open; it was cut in the plane instead.`,
      hint: 'Choose the solid engine slabs.',
    });
    return fallback(part);
  };
}

function joinShells(shells: readonly { mesh: TriangleMesh; part: Part }[]): Solid {
  const size = (of: 'positions' | 'indices') => shells.reduce((sum, { mesh }) => sum + mesh[of].length, 0);
  const positions = new Float64Array(size('positions'));
  const indices = new Uint32Array(size('indices'));
  const groups: SolidGroup[] = [];
  const named = new Map<string, number>();
  let [vertex, start] = [0, 0];
  for (const { mesh, part } of shells) {
    positions.set(mesh.positions, 3 * vertex);
    mesh.indices.forEach((index, i) => {
      indices[start + i] = vertex + index;
    });
    const number = named.get(part.name) ?? 0;
    named.set(part.name, number + 1);
    const { kind, storey } = part;
    groups.push({ name: `${part.name}-${number}`, kind, storey, start, count: mesh.indices.length });
    vertex += mesh.positions.length / 3;
    start += mesh.indices.length;
  }
  return { positions, indices, groups };
}
