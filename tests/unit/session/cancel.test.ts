import { expect, test } from 'vitest';
import { Session } from '../../../src/session/session.ts';
import { roomPoints } from '../core/made-scan.ts';
import { memorySource } from '../read/memory-source.ts';

const ROOM = roomPoints();
const CSV = Array.from({ length: ROOM.length / 3 }, (_, i) => ROOM.subarray(3 * i, 3 * i + 3).join()).join(
  '\n',
);

test('a session of the library hears a cancellation between the stages, too', async () => {
  const controller = new AbortController();
  const stages: string[] = [];
  const run = new Session().load(
    memorySource(CSV, 'room.csv'),
    {},
    {
      signal: controller.signal,
      onProgress: ({ stage }) => {
        if (stage === 'frame') setTimeout(() => controller.abort());
        stages.push(stage);
      },
    },
  );
  await expect(run).rejects.toMatchObject({ code: 'cancelled' });
  expect(stages).toContain('frame');
  expect(stages).not.toContain('solid');
});

test('progress never falls and ends at the whole', async () => {
  const shares: number[] = [];
  await new Session().load(
    memorySource(CSV, 'room.csv'),
    {},
    { onProgress: ({ share }) => void shares.push(share) },
  );
  expect(shares).toEqual(shares.toSorted((a, b) => a - b));
  expect(shares.at(-1)).toBe(1);
});
