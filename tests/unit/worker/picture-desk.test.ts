import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { blobSource } from '../../../src/read/bytes/blob-source.ts';
import { Session } from '../../../src/session/session.ts';
import { listPictures, PictureDesk } from '../../../src/worker/picture-desk.ts';
import { parseXml } from '../write/drawing/strict-xml.ts';

const file = new URL('../../golden/room-2/slice.csv', import.meta.url);
const session = new Session({ strokeTest: createStrokeTest() });
const { options } = await session.load(blobSource(new Blob([readFileSync(file)]), 'room-2.csv'), {
  preset: 'paper',
  unit: 'm',
  secondaryCount: 1,
  secondaryRounds: 2,
});

test('the picture of the stroke can be asked for by round, the others have none to choose', () => {
  const { evidence } = session;
  const desk = new PictureDesk();
  const rounds = listPictures(session).filter((picture) => picture.rounds > 1);
  const [{ rounds: run }] = evidence.secondary!.searches;
  expect(run).toHaveLength(2);
  expect(rounds.map(({ name, rounds: count }) => [name, count])).toEqual([['secondary-outline', 2]]);
  const draw = (round?: number) => desk.draw('secondary-outline', evidence, { ...(round && { round }) });
  expect(draw(1)).toContain('round 1');
  expect(draw(1)).not.toBe(draw(2));
  expect(draw(1)).toBe(draw(1));
});

test('a run that got no further than the structures has its own stroke', () => {
  const { plan: _, solid: __, ...evidence } = session.evidence;
  const root = parseXml(new PictureDesk().draw('secondary-outline', evidence, { options })!);
  const scale = Number(root.getAttribute('data-pixels-per-metre'));
  expect(Number(root.byId('stroke')!.getAttribute('stroke-width'))).toBeCloseTo(
    options.strokeWidth * scale,
    1,
  );
});
