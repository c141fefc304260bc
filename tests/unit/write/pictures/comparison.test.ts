import { describe, expect, test } from 'vitest';
import type { Polygon } from '../../../../src/core/types.ts';
import { comparePolygons } from '../../../../src/write/pictures/compare-polygons.ts';
import { drawComparison } from '../../../../src/write/pictures/comparison.ts';
import { rectangle, reversed } from '../../solid/plans.ts';
import { parseXml } from '../drawing/strict-xml.ts';

const area = (x: number, y: number, width: number, depth: number): Polygon => ({
  outer: rectangle(x, y, width, depth),
  holes: [],
});

describe('comparePolygons', () => {
  test('equal areas agree wholly', () => {
    const { iou, distance95, areaM2, vertices } = comparePolygons([area(0, 0, 4, 3)], [area(0, 0, 4, 3)]);
    expect({ iou, areaM2, vertices }).toEqual({ iou: 1, areaM2: [12, 12], vertices: [4, 4] });
    expect(distance95).toBeCloseTo(0, 12);
  });

  test('an area moved by a quarter of its width', () => {
    const { iou, distance95 } = comparePolygons([area(0, 0, 4, 3)], [area(1, 0, 4, 3)]);
    expect(iou).toBeCloseTo(9 / 15, 9);
    // Both upright sides, 6 of 14 m of either outline, are up to 1 m off.
    expect(distance95).toBeCloseTo(1, 2);
  });

  test('holes count', () => {
    const ring: Polygon = { outer: rectangle(0, 0, 4, 4), holes: [reversed(rectangle(1, 1, 2, 2))] };
    const { iou, areaM2, vertices, distance95 } = comparePolygons([ring], [area(0, 0, 4, 4)]);
    expect(iou).toBeCloseTo(12 / 16, 9);
    expect(areaM2).toEqual([12, 16]);
    expect(vertices).toEqual([8, 4]);
    // A third of one outline lies 1 m inside the other.
    expect(distance95).toBeCloseTo(1, 2);
  });

  test('nothing against something, and against nothing', () => {
    expect(comparePolygons([], [area(0, 0, 1, 1)])).toMatchObject({ iou: 0, distance95: Infinity });
    expect(comparePolygons([], [])).toMatchObject({ iou: 1, distance95: 0, areaM2: [0, 0] });
  });
});

describe('drawComparison', () => {
  const run = (label: string, x: number) => ({
    label,
    results: { regularise: { passes: [], polygons: [area(x, 0, 4, 3)] } },
  });

  test.each(['overlaid', 'beside'] as const)('%s, both outlines with the figures between them', (layout) => {
    const svg = drawComparison(run('Gift opening', 0), run('<α> & "shape"', 1), { layout })!;
    const root = parseXml(svg);
    const words = root.all('text').map((text) => text.text + text.all('tspan').map((span) => span.text));
    expect(words).toContain('Gift opening: 4 vertices');
    expect(words).toContain('<α> & "shape": 4 vertices');
    expect(root.byId('caption')!.all('tspan')[1].text).toContain('IoU 0.600 · 95 % within 1 m');
    const strokes = root.all('path').map((path) => path.getAttribute('stroke'));
    expect(strokes).toEqual(expect.arrayContaining(['#0072B2', '#D55E00']));
    expect(drawComparison(run('Gift opening', 0), run('<α> & "shape"', 1), { layout })).toBe(svg);
  });

  test('of structures the figures are those of the structures', () => {
    const structure = (x: number) => ({
      outline: area(x, 1, 1, 1),
      operation: 'subtract' as const,
      type: 'column' as const,
      points: 40,
    });
    const withStructure = (label: string, x: number) => {
      const secondary = { clusters: new Uint8Array(), searches: [], boundaries: [structure(x)] };
      return { label, results: { ...run(label, 0).results, secondary } };
    };
    const [a, b] = [withStructure('Paper', 1), withStructure('Robust', 1.5)];
    const root = parseXml(drawComparison(a, b, { subject: 'secondary' })!);
    expect(root.byId('caption')!.all('tspan')[1].text).toContain('Structures · IoU 0.333');
    const primary = parseXml(drawComparison(a, b)!);
    expect(primary.byId('caption')!.all('tspan')[1].text).toContain('IoU 1.000');
    const none = { label: 'None', results: run('None', 0).results };
    const words = drawComparison(a, none, { subject: 'secondary' })!;
    expect(words).toContain('None: 0 vertices');
    expect(words).not.toContain('∞');
  });

  test('needs both outlines', () => {
    expect(drawComparison(run('a', 0), { label: 'b', results: {} })).toBeNull();
  });
});
