import { expect, test } from 'vitest';
import type { Storey } from '../../../../src/core/types.ts';
import { writeGeoJson } from '../../../../src/write/data/geojson.ts';
import { parsePlanJson, writePlanJson } from '../../../../src/write/data/plan-json.ts';
import { writeSvg } from '../../../../src/write/drawing/svg.ts';
import { writeDxf } from '../../../../src/write/dxf/dxf.ts';
import { drawSheet } from '../../../../src/write/sheet/draw-sheet.ts';
import { rectangle } from '../../solid/plans.ts';
import { parseXml } from '../drawing/strict-xml.ts';
import { productOf } from '../products.ts';

const furnished: Partial<Storey> = {
  furniture: [
    {
      outline: { outer: rectangle(1, 1, 1.6, 0.8), holes: [] },
      height: 0.74,
      confidence: 0.9,
      room: 'Room 1',
    },
    {
      outline: { outer: rectangle(3, 2.4, 0.6, 0.6), holes: [] },
      height: 2.1,
      confidence: 0.5,
      room: 'Room 1',
    },
  ],
};
const bare = productOf({ storeys: [{}] });
const product = productOf({ storeys: [furnished] });

test('GeoJSON has a feature a thing, after all others', async () => {
  const { features } = JSON.parse(writeGeoJson(await product));
  const kinds = features.map(({ properties }: { properties: { kind: string } }) => properties.kind);
  expect(kinds.slice(-2)).toEqual(['furniture', 'furniture']);
  expect(features.at(-1)).toEqual({
    type: 'Feature',
    geometry: {
      type: 'Polygon',
      coordinates: [
        [
          [3, 2.4],
          [3.6, 2.4],
          [3.6, 3],
          [3, 3],
          [3, 2.4],
        ],
      ],
    },
    properties: {
      kind: 'furniture',
      storey: 0,
      room: 'Room 1',
      areaM2: 0.36,
      heightM: 2.1,
      confidence: 0.5,
    },
  });
});

test('the sheet has a layer of thin dashed outlines under the walls, and says so in the legend', async () => {
  const { layers } = drawSheet(await product, 0);
  const names = layers.map(({ name }) => name);
  expect(names.indexOf('furniture')).toBe(names.indexOf('walls') - 1);
  const text = writeSvg(await product, 0);
  parseXml(text);
  const [, group] = /<g id="furniture" data-layer="furniture">([\s\S]*?)<\/g>/.exec(text)!;
  expect(group.match(/<path /g)).toHaveLength(2);
  expect(group).toContain('data-kind="furniture" data-height="0.74" data-room="Room 1"');
  expect(group).toMatch(/stroke-opacity="0\.\d+" stroke-dasharray/);
  expect(text).toContain('>Furniture</text>');
});

test('DXF has closed polylines on a layer of their own', async () => {
  const text = writeDxf(await product, 0);
  expect(text.match(/LWPOLYLINE\n(?:.*\n){6} *8\nA-FURN\n(?:.*\n){4} *70\n1\n/g)).toHaveLength(2);
  expect(text).toMatch(/AcDbLayerTableRecord\n *2\nA-FURN\n/);
});

test('the plan JSON brings it back', async () => {
  const { plan } = await product;
  expect(parsePlanJson(writePlanJson(await product))).toEqual(plan);
});

test('without furniture no format speaks of it', async () => {
  for (const text of [writeGeoJson(await bare), writeSvg(await bare, 0), writeDxf(await bare, 0)])
    expect(text).not.toMatch(/furn/i);
});
