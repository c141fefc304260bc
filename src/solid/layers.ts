import { combine } from '../core/geometry/areas.ts';
import { boundsOfAll, inBounds, near } from '../core/geometry/rings.ts';
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

/**
 * A part with openings: what none of them cuts rises from bottom to top; what those at one place cut is raised layer by
 * layer. Level faces close what lies bare at sills and heads, and where two pieces stand side by side there is none. So
 * piers and lintels are one shell without faces inside, and an opening costs what lies about it, not a section of the
 * whole part.
 *
 * All is cut from one section, and an edge takes up the vertices of other pieces that lie on it, so pieces meet vertex
 * by vertex. Where two openings meet corner to corner, no single shell is a two-manifold: then every layer is a shell of
 * its own.
 *
 * @returns one closed shell for each piece that hangs together
 */
export function layeredShells(part: Part): TriangleMesh[] {
  const { tiles, bottom, top } = withSharedVertices(tilesOf(part));
  const mesh = new LayeredMesh();
  mesh.addCaps(bottom, part.low, 'down');
  for (const tile of tiles) {
    tile.forEach(({ section, low, high }, k) => {
      mesh.addSides(section, low, high);
      if (k === 0) return;
      const below = tile[k - 1].section;
      mesh.addCaps(combine('difference', section, below), low, 'down');
      mesh.addCaps(combine('difference', below, section), low, 'up');
    });
  }
  mesh.addCaps(top, part.high, 'up');
  const joined = closeTJunctions(mesh.toMesh(), ON_EDGE);
  if (openEdges(joined.indices).length === 0) return splitShells(joined);
  if (openEdges(joined.indices).length === 0) return splitShells(joined);
  return tiles.flat().flatMap(({ section, low, high }) => section.map((area) => extrude(area, low, high)));
}

/** The first tile is what no opening cuts. */
function tilesOf(part: Part): TiledPart {
  const { base, changes, openings, low, high } = part;
  // Structures that were added stand in an opening's way.
  const added = changes.flatMap(({ outline, operation }) => (operation === 'add' ? [outline] : []));
  const groups = groupCuts(openings, added);
  const whole = withoutPinches(carve(base, changes), groups, part);
  const cuts = groups.flatMap((group) => group.cuts);
  const places = cuts.flatMap((cut) => cut.base);
  const pieces = piecesByGroup(combine('intersection', whole, places), groups);
  return {
    tiles: [
      [{ section: combine('difference', whole, places), low, high }],
      ...groups.map((group, g) => layersOf(pieces[g], group, part)),
    ],
    bottom: combine('difference', whole, openAt({ cuts }, low + LEAST_LAYER)),
    top: combine('difference', whole, openAt({ cuts }, high - LEAST_LAYER)),
  };
}

/** An area with the openings of a group cut out of it. */
function layersOf(
  area: readonly Polygon[],
  group: CutGroup,
  { low, high }: Pick<Part, 'low' | 'high'>,
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

/** An area that touches itself at no height, whatever is cut out of it there. */
function withoutPinches(
  area: readonly Polygon[],
  groups: readonly CutGroup[],
  part: Part,
): readonly Polygon[] {
  let whole = area;
  for (let round = 0; round < PINCH_ROUNDS; round++) {
    const pinches = [...pinchesAllOpen(whole, groups), ...pinchesByLayer(whole, groups, part)];
    if (pinches.length === 0) break;
    whole = combine('difference', whole, pinches);
  }
  return whole;
}

/** Where a group is one opening, there is no more to see than with all of them open. */
const pinchesAllOpen = (whole: readonly Polygon[], groups: readonly CutGroup[]): Polygon[] =>
  pinchesOf(
    combine(
      'difference',
      whole,
      groups.flatMap(({ cuts }) => cuts.flatMap(({ base }) => base)),
    ),
  );

function pinchesByLayer(whole: readonly Polygon[], groups: readonly CutGroup[], part: Part): Polygon[] {
  const several = groups.filter(({ cuts }) => cuts.length > 1);
  const windows = several.map(({ cuts }) => windowAround(cuts.flatMap(({ base }) => base)));
  const seen = combine('intersection', whole, windows).map(inBounds);
  return several.flatMap((group, g) => {
    const area = near(seen, windows[g]);
    return layersOf(area, group, part).flatMap(({ section }) => pinchesOf(section));
  });
}

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
