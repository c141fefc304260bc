import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { type SampleFile, sampleFiles } from '../../../fixtures/simulator/samples.ts';

const root = resolve(import.meta.dirname, '../../..');
const MB = 1_000_000;
let files: SampleFile[] = [];

beforeAll(() => {
  files = sampleFiles();
});

const content = (path: string): Uint8Array => files.find((file) => file.path === path)!.content;

describe('samples of the start page', () => {
  it('in the repository are what the simulator makes, byte for byte', () => {
    for (const { path, content: made } of files) {
      expect(Buffer.compare(readFileSync(resolve(root, path)), made), path).toBe(0);
    }
  });

  it('load quickly', () => {
    expect(content('public/samples/home.ply').length).toBeLessThan(2 * MB);
    expect(content('public/samples/office.ply').length).toBeLessThan(1.5 * MB);
    expect(content('public/samples/hallway.csv').length).toBeLessThan(0.05 * MB);
  });

  it('show what they are for', () => {
    const home = JSON.parse(Buffer.from(content('fixtures/samples/home.gt.json')).toString());
    expect(home.rooms).toHaveLength(6);
    expect(home.columns).toHaveLength(1);
    expect(home.hiddenShare).toBeLessThan(0.05);
    const hallway = Buffer.from(content('public/samples/hallway.csv')).toString().trim().split('\n');
    expect(hallway).toHaveLength(1 + 1799);
  });
});
