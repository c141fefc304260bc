import { beforeEach, expect, it } from 'vitest';
import { PlanMaker } from '../../../src/element/plan-maker.ts';
import { StepChoice } from '../../../src/element/step-choice.ts';

// Node has no Worker: the maker's client runs the real pipeline on this thread.
let maker: PlanMaker;
let steps: StepChoice;

beforeEach(async () => {
  maker = new PlanMaker({
    onChange() {},
    onScan() {},
    onView() {},
    onPreview() {},
    spawnWorker: () => null,
    emit() {},
  });
  steps = new StepChoice(maker);
  const lines = ['x,y'];
  for (let s = 0; s < 4; s += 0.02) lines.push(`${s},0`, `${s},3`, `0,${s * 0.75}`, `4,${s * 0.75}`);
  await maker.load([{ data: new Blob([lines.join('\n')]), name: 'room.csv' }], { unit: 'm' });
});

it('goes forth and back, and stops at either end', () => {
  expect(steps.picture).toBeNull();
  const names = steps.pictures.map(({ name }) => name);
  steps.open(names[0]);
  steps.move(-1);
  expect(steps.name).toBe(names[0]);
  for (const _ of names) steps.move(1);
  expect(steps.name).toBe(names.at(-1));
  steps.open(null);
  expect(steps.picture).toBeNull();
});

it('a picture the plan lacks is stood for by the one in its place', async () => {
  steps.open('visvalingam');
  const place = steps.pictures.findIndex(({ name }) => name === 'visvalingam');
  expect(steps.picture?.name).toBe('visvalingam');
  await maker.update({ unit: 'm', visvalingamPass: false });
  expect(steps.picture?.name).not.toBe('visvalingam');
  expect(steps.picture).toBe(steps.pictures[Math.min(place, steps.pictures.length - 1)]);
  await maker.update({ unit: 'm' });
  expect(steps.picture?.name).toBe('visvalingam');
});

it('turns to the last picture of a failed run, and back; a good run ends that', async () => {
  steps.open('model');
  await expect(maker.update({ unit: 'm', boundary: 'alpha-shape', alpha: 0.001 })).rejects.toThrow();
  expect(steps.of).toBe('plan');
  expect(steps.picture?.name).toBe('model');
  steps.turnTo('failed');
  expect(steps.picture?.name).toBe('slice');
  steps.turnTo('plan');
  expect(steps.pictures.at(-1)?.name).toBe('model');
  steps.turnTo('failed');
  await maker.update({ unit: 'm' });
  expect(steps.of).toBe('plan');
});
