import { combine } from '../core/geometry/areas.ts';
import { type Bounds, boundsMeet, boundsOf, boundsOfAll, inBounds, near } from '../core/geometry/rings.ts';
import type { Polygon } from '../core/types.ts';
import { type CutGroup, groupCuts, openAt, piecesByGroup } from './cut-groups.ts';
import { extrude, ON_EDGE } from './extrude.ts';
import { LayeredMesh } from './layered-mesh.ts';
import type { Part } from './part.ts';
import { PINCH_ROUNDS, pinchesOf } from './pinches.ts';
import { carve } from './sections.ts';
import { shareVertices } from './share-vertices.ts';
import { closeTJunctions } from './t-junctions.ts';
import { openEdges, type TriangleMesh } from './triangle-mesh.ts';
import { splitShells } from './weld.ts';

/** Heights closer than this are one, m: rounding alone tells them apart. */
const LEAST_LAYER = 1e-6;
/** What lies so near to openings at one place is looked at with them, m: enough to tell what touches what. */
const ABOUT = 5e-3;

/** One section from a height to the next. */
interface Layer {
  readonly section: readonly Polygon[];
  readonly low: number;
  readonly high: number;
}

/** A piece of a part's plan and how high it stands, lowest layer first. */
type Tile = readonly Layer[];

/** A part in tiles side by side, and its section where it begins and where it ends. */
interface TiledPart {
  readonly tiles: readonly Tile[];
  readonly bottom: readonly Polygon[];
  readonly top: readonly Polygon[];
}

/** A part's plan, which touches itself at no height, and the openings cut out of it by their places. */
interface CutPlan {
  readonly whole: readonly Polygon[];
  readonly groups: readonly CutGroup[];
  readonly low: number;
  readonly high: number;
}

/**
 * A part with openings: what none of them cuts rises from bottom to top; what those at one place cut is raised layer by
 * layer. Level faces close what lies bare at sills and heads, and where two pieces stand side by side there is none. So
 * piers and lintels are one shell without faces inside, and an opening costs what lies about it, not a section of the
 * whole part.
 *
 * All is cut from one section, and an edge takes up the vertices of other pieces that lie on it, so pieces meet vertex
 * by vertex. Where two openings meet corner to corner, no single shell is a two-manifold: there every layer is a shell
 * of its own.
 *
 * @returns one closed shell for each piece that hangs together
 */
export function layeredShells({ base, changes, openings, low, high }: Part): TriangleMesh[] {
  // Structures that were added stand in an opening's way.
  const added = changes.flatMap(({ outline, operation }) => (operation === 'add' ? [outline] : []));
  const groups = groupCuts(openings, added);
  let plan: CutPlan = { whole: carve(base, changes), groups, low, high };
  plan = { ...plan, whole: withoutPinches(plan) };
  const apart: TriangleMesh[] = [];
  for (;;) {
    const tiled = tilesOf(plan);
    const mesh = meshOf(tiled, plan);
    const open = openPlaces(mesh);
    if (open.length === 0) return [...splitShells(mesh), ...apart];
    const isTroubled = plan.groups.map(({ boxes }) =>
      boxes.some((box) => open.some((at) => boundsMeet(box, at))),
    );
    if (!isTroubled.includes(true)) return [...extruded(tiled.tiles), ...apart];
    apart.push(...extruded(tiled.tiles.filter((_, t) => t > 0 && isTroubled[t - 1])));
    plan = {
      ...plan,
      whole: combine('difference', plan.whole, placesOf(plan.groups.filter((_, g) => isTroubled[g]))),
      groups: plan.groups.filter((_, g) => !isTroubled[g]),
    };
  }
}

function meshOf({ tiles, bottom, top }: TiledPart, { low, high }: CutPlan): TriangleMesh {
  const mesh = new LayeredMesh();
  mesh.addCaps(bottom, low, 'down');
  for (const tile of tiles) {
    tile.forEach((layer, k) => {
      mesh.addSides(layer.section, layer.low, layer.high);
      if (k === 0) return;
      const below = tile[k - 1].section;
      mesh.addCaps(combine('difference', layer.section, below), layer.low, 'down');
      mesh.addCaps(combine('difference', below, layer.section), layer.low, 'up');
    });
  }
  mesh.addCaps(top, high, 'up');
  return closeTJunctions(mesh.toMesh(), ON_EDGE);
}

/** Every layer a shell of its own. */
const extruded = (tiles: readonly Tile[]): TriangleMesh[] =>
  tiles.flat().flatMap(({ section, low, high }) => section.map((area) => extrude(area, low, high)));

/** Where edges lack a neighbour, seen from above. */
function openPlaces({ positions, indices }: TriangleMesh): Bounds[] {
  return [...new Set(openEdges(indices))].map((vertex) =>
    boundsOf(positions.subarray(3 * vertex, 3 * vertex + 2)),
  );
}

/** The first tile is what no opening cuts, then one for each group. */
function tilesOf(plan: CutPlan): TiledPart {
  const { whole, groups, low, high } = plan;
  const cuts = groups.flatMap((group) => group.cuts);
  const pieces = piecesByGroup(combine('intersection', whole, placesOf(groups)), groups);
  return withSharedVertices({
    tiles: [
      [{ section: combine('difference', whole, placesOf(groups)), low, high }],
      ...groups.map((group, g) => layersOf(pieces[g], group, plan)),
    ],
    bottom: combine('difference', whole, openAt({ cuts }, low + LEAST_LAYER)),
    top: combine('difference', whole, openAt({ cuts }, high - LEAST_LAYER)),
  });
}

/** An area with the openings of a group cut out of it. */
function layersOf(
  area: readonly Polygon[],
  group: CutGroup,
  { low, high }: Pick<CutPlan, 'low' | 'high'>,
): Layer[] {
  const heights = [low];
  for (const z of group.cuts.flatMap((cut) => [cut.low, cut.high]).sort((a, b) => a - b)) {
    if (z > heights.at(-1)! + LEAST_LAYER && z < high - LEAST_LAYER) heights.push(z);
  }
  heights.push(high);
  return heights.slice(1).map((top, k) => ({
    section: combine('difference', area, openAt(group, (heights[k] + top) / 2)),
    ...{ low: heights[k], high: top },
  }));
}

/** A part's plan that touches itself at no height, whatever is cut out of it there. */
function withoutPinches(plan: CutPlan): readonly Polygon[] {
  let { whole } = plan;
  for (let round = 0; round < PINCH_ROUNDS; round++) {
    // Where a group is one opening, there is no more to see than with all of them open.
    const allOpen = combine('difference', whole, placesOf(plan.groups));
    const pinches = [...pinchesOf(allOpen), ...pinchesByLayer({ ...plan, whole })];
    if (pinches.length === 0) break;
    whole = combine('difference', whole, pinches);
  }
  return whole;
}

function pinchesByLayer(plan: CutPlan): Polygon[] {
  const several = plan.groups.filter(({ cuts }) => cuts.length > 1);
  const windows = several.map((group) => windowAround(placesOf([group])));
  const seen = combine('intersection', plan.whole, windows).map(inBounds);
  return several.flatMap((group, g) =>
    layersOf(near(seen, windows[g]), group, plan).flatMap(({ section }) => pinchesOf(section)),
  );
}

/** All that some opening of the groups cuts away. */
const placesOf = (groups: readonly CutGroup[]): Polygon[] =>
  groups.flatMap(({ cuts }) => cuts.flatMap(({ base }) => base));

function windowAround(areas: readonly Polygon[]): Polygon {
  const { minX, minY, maxX, maxY } = boundsOfAll(areas.map(({ outer }) => outer));
  const [x0, y0, x1, y1] = [minX - ABOUT, minY - ABOUT, maxX + ABOUT, maxY + ABOUT];
  return { outer: Float64Array.of(x0, y0, x1, y0, x1, y1, x0, y1), holes: [] };
}

function withSharedVertices({ tiles, bottom, top }: TiledPart): TiledPart {
  const [first, last, ...sections] = shareVertices([
    bottom,
    top,
    ...tiles.flat().map(({ section }) => section),
  ]);
  let next = 0;
  return {
    bottom: first,
    top: last,
    tiles: tiles.map((tile) => tile.map((layer) => ({ ...layer, section: sections[next++] }))),
  };
}
