import { ExtrudeGeometry } from 'three';
import { SVGLoader } from 'three/examples/jsm/loaders/SVGLoader.js';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Solid } from '../../../../src/core/types.ts';
import { checkSolid } from '../../../../src/solid/check-solid.ts';
import { weld } from '../../../../src/solid/weld.ts';
import { writeMinimalSvg } from '../../../../src/write/drawing/minimal-svg.ts';
import { expectValidRing } from '../../../invariants.ts';
import { home, productOf } from '../products.ts';
import { parseXml } from './strict-xml.ts';

const HEIGHT = 2.5;

beforeAll(() => {
  class DOMParser {
    parseFromString(text: string) {
      const documentElement = parseXml(text);
      return {
        documentElement,
        querySelectorAll: (names: string) => documentElement.querySelectorAll(names),
      };
    }
  }
  Object.assign(globalThis, { DOMParser });
});
afterAll(() => {
  Reflect.deleteProperty(globalThis, 'DOMParser');
});

/** What anyone gets who extrudes a path of the file with three, and turns y up again. */
function extruded(svg: string, id: string) {
  const { paths } = new SVGLoader().parse(svg);
  const path = paths.find(
    ({ userData }) =>
      (userData as { node: { getAttribute(n: string): string } }).node.getAttribute('id') === id,
  )!;
  const geometry = new ExtrudeGeometry(path.toShapes(), { depth: HEIGHT, bevelEnabled: false });
  const soup = Float64Array.from(geometry.getAttribute('position').array);
  for (let i = 1; i < soup.length; i += 3) soup[i] = -soup[i];
  const mesh = weld(soup, 1e-5);
  // Turning y over turns every triangle inside out.
  const indices = mesh.indices.toReversed();
  const group = { name: id, kind: 'wall', storey: 0, start: 0, count: indices.length } as const;
  return { ...mesh, check: checkSolid({ positions: mesh.positions, indices, groups: [group] }) };
}

const groupsOf = (solid: Solid, kind: string): Solid => ({
  ...solid,
  groups: solid.groups.filter((group) => group.kind === kind),
});

const extentOf = (positions: Float64Array): number[] =>
  [0, 1].flatMap((axis) => {
    const values = positions.filter((_, i) => i % 3 === axis);
    return [Math.min(...values), Math.max(...values)];
  });

test("three's SVGLoader reads it, and extruding its walls gives the very solid", async () => {
  const product = await productOf({ ...home(), options: { floorSlab: false } });
  const walls = extruded(writeMinimalSvg(product, 0), 'walls');
  const ours = checkSolid(groupsOf(product.solid, 'wall'));
  expect(walls.check.openEdges).toBe(0);
  expect(walls.check.volume).toBeCloseTo(ours.volume, 4);
  expect(walls.check.area).toBeCloseTo(ours.area, 3);
  expect(walls.indices.length).toBe(
    groupsOf(product.solid, 'wall').groups.reduce((sum, { count }) => sum + count, 0),
  );
  expect(extentOf(walls.positions).map((value) => Number(value.toFixed(4)))).toEqual([0, 12, 0, 9]);
});

test('an independent structure extrudes to its own solid', async () => {
  const product = await productOf({ ...home(), options: { floorSlab: false } });
  const cubicle = extruded(writeMinimalSvg(product, 0), 'secondary-2');
  expect(cubicle.check.volume).toBeCloseTo(checkSolid(groupsOf(product.solid, 'secondary')).volume, 4);
});

test('it holds nothing but paths, one for the walls and one a structure', async () => {
  const svg = parseXml(writeMinimalSvg(await productOf(home()), 0));
  expect(svg.childNodes.map(({ nodeName }) => nodeName)).toEqual(['path', 'path', 'path', 'path']);
  expect(svg.getAttribute('viewBox')).toBe('0 -9 12 9');
  expect(svg.childNodes.map((path) => path.getAttribute('data-operation'))).toEqual([
    null,
    'add',
    'subtract',
    'independent',
  ]);
});

test('a storey without walls is an empty drawing', async () => {
  const svg = parseXml(
    writeMinimalSvg(
      await productOf({
        storeys: [{ walls: [], primary: [{ outer: Float64Array.of(0, 0, 1, 0, 1, 1), holes: [] }] }],
      }),
      0,
    ),
  );
  expect(svg.childNodes).toEqual([]);
});

test('walls are cut a metre above the floor, so doors are open', async () => {
  const openings = [
    { type: 'door', from: [1, -0.1], to: [1.9, -0.1], sill: 0, head: 2, confidence: 1 } as const,
  ];
  const walls = extruded(writeMinimalSvg(await productOf({ storeys: [{ openings }] }), 0), 'walls');
  expect(walls.check.volume).toBeCloseTo((4.4 * 3.4 - 12 - 0.9 * 0.2) * HEIGHT, 5);
  expect(walls.check.openEdges).toBe(0);
});

test('a structure stays simple when rounded to 0.01 mm', async () => {
  // A dent whose tip ends 2 µm before the edge across; rounded, it lies on that edge.
  const dented = Float64Array.of(0, 0, 1, 0.300002, 1, 0.8, 0.6, 0.8, 0.5, 0.150003, 0.4, 0.8, 0, 0.8);
  const structure = {
    outline: { outer: dented, holes: [] },
    operation: 'independent',
    type: 'other',
    points: 9,
  } as const;
  const svg = parseXml(writeMinimalSvg(await productOf({ storeys: [{ secondary: [structure] }] }), 0));
  const d = svg.childNodes.at(-1)!.getAttribute('d')!;
  const rings = d.split('Z').filter(Boolean);
  expect(rings).toHaveLength(2);
  for (const one of rings) {
    expectValidRing(Float64Array.from(one.split(/[ML ]/).filter(Boolean), Number));
  }
});
