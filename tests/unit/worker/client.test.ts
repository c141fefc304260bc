import { expect, it } from 'vitest';
import { PlanClient } from '../../../src/worker/client.ts';
import type { Evidence, PlanView } from '../../../src/worker/protocol.ts';

// Node has no Worker, so the client ends on its own thread: the real protocol, server and session answer.

/** The walls of a room as a ready slice, a point every 2 cm. */
function room(width: number): Blob {
  const lines = ['x,y'];
  for (let s = 0; s < width; s += 0.02) lines.push(`${s},0`, `${s},3`);
  for (let s = 0; s < 3; s += 0.02) lines.push(`0,${s}`, `${width},${s}`);
  return new Blob([lines.join('\n')]);
}

const cancelled = { code: 'cancelled' };

it('makes a plan, changes it and writes it, and says that there is no worker', async () => {
  const warnings: string[] = [];
  const client = new PlanClient({ onWarning: ({ code }) => warnings.push(code) });
  const first = await client.load([{ data: room(4), name: 'room.csv' }]);
  expect(first.plan.storeys[0].primary).toHaveLength(1);
  const changed = await client.update({ wallThickness: 0.5 });
  expect(changed.options.wallThickness).toBe(0.5);
  expect(changed.stages.find(({ name }) => name === 'boundary')?.isCached).toBe(true);
  const [file] = await client.export('svg');
  expect(await file.blob.text()).toBe(changed.drawings[0]);
  expect(warnings).toEqual(['environment/worker']);
});

it('asks the page for a worker first, once', async () => {
  let asked = 0;
  const spawn = () => {
    asked++;
    throw new Error('refused');
  };
  const client = new PlanClient({ spawnWorker: () => spawn });
  await client.load([{ data: room(4), name: 'room.csv' }]);
  client.cancel();
  await client.load([{ data: room(4), name: 'room.csv' }]);
  expect(asked).toBe(1);
});

it('of two loads the later wins, even before the line is ready', async () => {
  const client = new PlanClient();
  const overtaken = expect(client.load([{ data: room(4), name: 'a.csv' }])).rejects.toMatchObject(cancelled);
  const view = await client.load([{ data: room(6), name: 'b.csv' }]);
  await overtaken;
  expect(view.plan.source.name).toBe('b.csv');
});

it('of two updates the later wins; a load under way falls to an update of the scan shown', async () => {
  const client = new PlanClient();
  await client.load([{ data: room(4), name: 'a.csv' }]);
  const overtaken = expect(client.update({ wallThickness: 0.3 })).rejects.toMatchObject(cancelled);
  const view = await client.update({ wallThickness: 0.4 });
  await overtaken;
  expect(view.options.wallThickness).toBe(0.4);
  const fallen = expect(client.load([{ data: room(6), name: 'b.csv' }])).rejects.toMatchObject(cancelled);
  const again = await client.update({ wallThickness: 0.6 });
  await fallen;
  expect(again.plan.source.name).toBe('a.csv');
});

it('after a cancelled load the scan before is read again for an export, with its own options', async () => {
  const client = new PlanClient();
  const shown = await client.load([{ data: room(4), name: 'a.csv' }], { wallThickness: 0.4 });
  const stopped = expect(client.load([{ data: room(6), name: 'b.csv' }])).rejects.toMatchObject(cancelled);
  client.cancel();
  await stopped;
  const [file] = await client.export('svg');
  expect(await file.blob.text()).toBe(shown.drawings[0]);
});

it('after a load that fails the scan before is still there', async () => {
  const client = new PlanClient();
  const shown = await client.load([{ data: room(4), name: 'a.csv' }]);
  await expect(client.load([{ data: new Blob(['no cloud']), name: 'x.ply' }])).rejects.toMatchObject({
    code: 'input/unknown-format',
  });
  const [file] = await client.export('svg');
  expect(await file.blob.text()).toBe(shown.drawings[0]);
});

it('draws the pictures of the plan, each once as long as its stage stands', async () => {
  const client = new PlanClient();
  const view = await client.load([{ data: room(4), name: 'room.csv' }]);
  const names = view.pictures.map(({ name }) => name);
  expect(names).toEqual(expect.arrayContaining(['slice', 'hull', 'plan', 'model']));
  for (const name of names)
    expect(await client.picture({ name, of: 'plan' })).toContain(`data-picture="${name}"`);
  expect(await client.picture({ name: 'clusters', of: 'plan' })).toBeNull();
  expect(await client.picture({ name: 'toString', of: 'plan' })).toBeNull();
  const [hull, plan] = [
    await client.picture({ name: 'hull', of: 'plan' }),
    await client.picture({ name: 'plan', of: 'plan' }),
  ];
  const changed = await client.update({ wallThickness: 0.5 });
  expect(await client.picture({ name: 'hull', of: 'plan' })).toBe(hull);
  expect(await client.picture({ name: 'plan', of: 'plan' })).not.toBe(plan);
  const facts = (name: string) => changed.pictures.find((picture) => picture.name === name);
  expect(facts('hull')?.outcome).toMatch(/vertices/);
  expect(facts('hull')?.ms).toBe(view.stages.find(({ name }) => name === 'boundary')?.ms);
});

it('a run that fails tells which stage, and its pictures up to there can be had beside those of the plan', async () => {
  const evidence: Evidence[] = [];
  const client = new PlanClient({ onEvidence: (given) => evidence.push(given) });
  const view = await client.load([{ data: room(4), name: 'room.csv' }]);
  const hull = await client.picture({ name: 'hull', of: 'plan' });
  await expect(client.update({ boundary: 'alpha-shape', alpha: 0.001 })).rejects.toMatchObject({
    code: 'result/no-boundary',
  });
  expect(evidence).toHaveLength(1);
  expect(evidence[0].stage).toBe('boundary');
  expect(evidence[0].pictures.at(-1)?.name).toBe('slice');
  expect(await client.picture({ name: 'slice', of: 'failed' })).toContain('data-picture="slice"');
  expect(await client.picture({ name: 'hull', of: 'failed' })).toBeNull();
  expect(await client.picture({ name: 'hull', of: 'plan' })).toBe(hull);
  await client.update(view.options);
  expect(await client.picture({ name: 'slice', of: 'failed' })).toBeNull();
});

it('pictures of the plan shown tell what came out of it, not of a scan that failed after it', async () => {
  const client = new PlanClient();
  const slices: (string | undefined)[] = [];
  const tell = ({ pictures }: PlanView) =>
    slices.push(pictures.find(({ name }) => name === 'slice')?.outcome);
  tell(await client.load([{ data: room(4), name: 'a.csv' }]));
  const failing = client.load([{ data: room(6), name: 'b.csv' }], { boundary: 'alpha-shape', alpha: 0.001 });
  await expect(failing).rejects.toMatchObject({ code: 'result/no-boundary' });
  tell(await client.update({ wallThickness: 0.5 }));
  expect(slices[0]).toMatch(/points/);
  expect(slices[1]).toBe(slices[0]);
});

it('puts another plan beside the one shown, which stays', async () => {
  const client = new PlanClient();
  const shown = await client.load([{ data: room(4), name: 'room.csv' }]);
  const stages: string[] = [];
  const request = { options: { boundary: 'convex' }, labels: ['Gift opening', 'Convex'] } as const;
  const comparison = await client.compare(request, ({ stage }) => stages.push(stage));
  expect(comparison).toMatchObject({ subject: 'primary', there: { vertices: 4 } });
  expect(comparison.iou).toBeGreaterThan(0.98);
  expect(comparison.here.areaM2).toBeCloseTo(shown.report.boundary.areaM2, 3);
  expect(comparison.overlaid).toContain('Convex');
  expect(comparison.beside).not.toBe(comparison.overlaid);
  expect(stages).toContain('boundary');
  expect(stages).not.toContain('slice');
  const [file] = await client.export('svg');
  expect(await file.blob.text()).toBe(shown.drawings[0]);
});

it('a comparison can be stopped, is overtaken by the next, and falls to an update', async () => {
  const client = new PlanClient();
  await client.load([{ data: room(4), name: 'room.csv' }]);
  const request = (boundary: 'convex' | 'concaveman') =>
    ({ options: { boundary }, labels: ['', ''] }) as const;
  const stopped = expect(client.compare(request('convex'))).rejects.toMatchObject(cancelled);
  await Promise.resolve();
  client.stopComparing();
  await stopped;
  const overtaken = expect(client.compare(request('convex'))).rejects.toMatchObject(cancelled);
  expect((await client.compare(request('concaveman'))).iou).toBeGreaterThan(0.9);
  await overtaken;
  const fallen = expect(client.compare(request('convex'))).rejects.toMatchObject(cancelled);
  await Promise.resolve();
  await client.update({ wallThickness: 0.3 });
  await fallen;
});

it('after a cancelled load the scan before is read again for a picture', async () => {
  const client = new PlanClient();
  await client.load([{ data: room(4), name: 'a.csv' }]);
  const hull = await client.picture({ name: 'hull', of: 'plan' });
  const stopped = expect(client.load([{ data: room(6), name: 'b.csv' }])).rejects.toMatchObject(cancelled);
  client.cancel();
  await stopped;
  expect(await client.picture({ name: 'hull', of: 'plan' })).toBe(hull);
});

it('without a scan there is nothing to change or to write', async () => {
  const client = new PlanClient();
  await expect(client.update({})).rejects.toMatchObject({ code: 'input/empty' });
  await expect(client.export('svg')).rejects.toMatchObject({ code: 'input/empty' });
});
