import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { READ_FORMATS } from '../../src/read/formats.ts';
import type { CorpusTruth } from './classes.ts';
import { type SurveyedRoom, surveyedTruth } from './surveyed-room.ts';

export interface SceneFiles {
  readonly name: string;
  readonly scan: string;
  /** Null where nobody knows: the plan can only be looked at. */
  readonly truth: CorpusTruth | null;
}

/** Every scan of a folder, with its truth where NAME.gt.json or truth/NAME_plan_gt.json stands beside it. */
export function scenesIn(folder: string): SceneFiles[] {
  const extensions = new Set<string>(Object.values(READ_FORMATS).flatMap(({ extensions }) => extensions));
  return readdirSync(folder)
    .sort()
    .flatMap((file) => {
      const dot = file.lastIndexOf('.');
      const name = file.slice(0, dot);
      if (dot < 0 || !extensions.has(file.slice(dot + 1).toLowerCase()) || file.startsWith('LICENSE'))
        return [];
      return [{ name, scan: join(folder, file), truth: truthOf(folder, name) }];
    });
}

function truthOf(folder: string, name: string): CorpusTruth | null {
  const exact = join(folder, `${name}.gt.json`);
  if (existsSync(exact)) return readJson<CorpusTruth>(exact);
  const surveyed = join(folder, 'truth', `${name.replace(/_points$/, '')}_plan_gt.json`);
  return existsSync(surveyed) ? surveyedTruth(name, readJson<SurveyedRoom>(surveyed)) : null;
}

export function readJson<T>(path: string): T {
  return JSON.parse(readFileSync(path, 'utf8'));
}
