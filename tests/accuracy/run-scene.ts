import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { join, resolve } from 'node:path';
import type { XY } from '../../fixtures/simulator/ring.ts';
import type { Report } from '../../src/session/report.ts';
import type { PlanFile } from './facts.ts';
import { measurePlan } from './measure.ts';
import { drawComparison } from './picture.ts';
import { readJson, type SceneFiles } from './scene-files.ts';
import { formatFigures, type SceneResult } from './table.ts';
import { writePicture } from './write-picture.ts';

const command = resolve(import.meta.dirname, '../../dist/cli.js');

export interface SceneRun {
  /** Folder for the plans and pictures. */
  readonly out: string;
  /** What is kept back leaves nothing to look at. */
  readonly isHeldBack: boolean;
  /** Handed on to the command. */
  readonly rest: readonly string[];
}

/** The plan of one scan by the built command, judged where its truth is known, and drawn. */
export async function runScene(
  { name, scan, truth }: SceneFiles,
  { out, isHeldBack, rest }: SceneRun,
): Promise<SceneResult> {
  const folder = join(out, name);
  rmSync(folder, { recursive: true, force: true });
  const words = [command, scan, '-o', folder, '--formats', 'geojson,slice', ...rest];
  const start = performance.now();
  const { status, stderr } = spawnSync(process.execPath, words, { encoding: 'utf8' });
  const seconds = (performance.now() - start) / 1000;
  const facts = { name, ...(truth?.scene ? { class: truth.scene.class } : {}), seconds };
  if (status !== 0) return { ...facts, measures: null, problem: stderr.trim() || `exit code ${status}` };
  const plan = readJson<PlanFile>(join(folder, 'plan.geojson'));
  const report = readJson<Report>(join(folder, 'report.json'));
  const measures = truth ? { ...measurePlan(plan, truth), watertight: report.mesh.watertight ? 1 : 0 } : {};
  const note = truth === null ? summaryOf(report) : undefined;
  if (isHeldBack) rmSync(folder, { recursive: true });
  else {
    const points = readSlice(join(folder, 'slice.csv'));
    const storeys = 1 + Math.max(0, ...plan.features.map(({ properties }) => Number(properties.storey ?? 0)));
    for (let storey = 0; storey < storeys; storey++) {
      const path = join(out, storeys === 1 ? name : `${name}-${storey}`);
      const figures = note ?? formatFigures(measures);
      await writePicture(path, drawComparison({ name, plan, truth, points, storey, figures }));
    }
  }
  return { ...facts, measures, ...(note === undefined ? {} : { note }) };
}

/** What can be said of a plan whose truth nobody knows. */
function summaryOf({ boundary, rooms, warnings }: Report): string {
  const areas = rooms.map(({ areaM2 }) => areaM2.toFixed(1)).join(' ');
  const codes = [...new Set(warnings.map(({ code }) => code))].join(' ');
  return `outline ${boundary.areaM2.toFixed(1)} m², ${rooms.length} rooms ${areas}${codes ? `; ${codes}` : ''}`;
}

function readSlice(path: string): XY[] {
  if (!existsSync(path)) return [];
  const [, ...lines] = readFileSync(path, 'utf8').trim().split('\n');
  return lines.map((line) => {
    const [x, y] = line.split(',').map(Number);
    return [x, y];
  });
}
