import { beforeAll, expect, test } from 'vitest';
import { paperSlice } from '../../../fixtures/simulator/slices.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { blobSource } from '../../../src/read/bytes/blob-source.ts';
import { Session } from '../../../src/session/session.ts';
import { comparePolygons } from '../../../src/write/pictures/compare-polygons.ts';

let session: Session;
beforeAll(async () => {
  const { xy } = paperSlice('room-1a', 1);
  const rows = Array.from({ length: xy.length / 2 }, (_, i) => `${xy[2 * i]},${xy[2 * i + 1]}`);
  session = new Session({ strokeTest: createStrokeTest() });
  await session.load(blobSource(new Blob([`x,y\n${rows.join('\n')}\n`]), 'room-1a.csv'));
});

test('another run leaves plan, evidence and cache as they are, and shares the stages before', async () => {
  const { result, evidence, reports } = session;
  const other = await session.compare({ boundary: 'convex' });
  expect(session.result).toBe(result);
  expect(session.evidence).toBe(evidence);
  expect(session.reports).toBe(reports);

  const cached = other.stages.filter(({ isCached }) => isCached).map(({ name }) => name);
  expect(cached).toEqual(['read', 'frame', 'crop', 'outliers', 'level', 'slice']);
  expect(other.slice).toBe(evidence.slice);
  expect(other.boundary.method).toBe('convex');

  const again = await session.update({});
  expect(again.stages.every(({ isCached }) => isCached)).toBe(true);
});

test('two methods differ as their outlines do', async () => {
  const other = await session.compare({ boundary: 'convex' });
  const own = session.result!.regularise!.polygons;
  const { iou, areaM2 } = comparePolygons(own, other.regularise.polygons);
  expect(iou).toBeGreaterThan(0.95);
  expect(areaM2[1]).toBeGreaterThan(areaM2[0]);
});

test('options that make no plan fail by name and cost nothing', async () => {
  const { result } = session;
  await expect(session.compare({ boundary: 'alpha-shape', alpha: 0.001 })).rejects.toMatchObject({
    name: 'FloorPlanError',
  });
  expect(session.result).toBe(result);
  expect(session.picture('model')).not.toBeNull();
});

test('without a scan there is nothing to compare', async () => {
  await expect(new Session().compare({})).rejects.toMatchObject({ code: 'input/empty' });
});
