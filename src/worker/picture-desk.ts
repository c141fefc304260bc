import type { StageReport } from '../core/pipeline-run.ts';
import type { StageResults } from '../core/stage-results.ts';
import type { StageName } from '../core/stages.ts';
import {
  type PictureFacts as DrawnFacts,
  drawPicture,
  hasPicture,
  PICTURE_NAMES,
  PICTURES,
  type PictureName,
  pictureFile,
  roundsOf,
} from '../write/pictures.ts';
import type { PictureFacts } from './protocol.ts';

type Results = Partial<StageResults>;
type Asked = Pick<DrawnFacts, 'options' | 'round'>;

/** Draws the pictures of runs, each once as long as its stage's result lives. */
export class PictureDesk {
  /** By result of a stage: the stages before have made the same as long as it is the same. */
  readonly #drawn = new WeakMap<object, Map<string, string | null>>();
  /** Of each stage, when it last ran. */
  readonly #reports = new Map<StageName, StageReport>();

  /** The pictures a run has something to show in. @param reports of that run */
  list(results: Results, reports: readonly StageReport[]): PictureFacts[] {
    for (const report of reports) if (!report.isCached) this.#reports.set(report.name, report);
    return PICTURE_NAMES.filter((name) => hasPicture(name, results)).map((name) => {
      const { label, doc, stage, figure } = PICTURES[name];
      const { outcome = '', ms = 0 } = this.#reports.get(stage) ?? {};
      const rounds = roundsOf(name, results);
      return { name, file: pictureFile(name), stage, label, doc, figure, outcome, ms, rounds };
    });
  }

  /** How long each stage took when it last ran. ms */
  timeOf(stage: StageName): number {
    return this.#reports.get(stage)?.ms ?? 0;
  }

  /**
   * @param facts options of that run, and the round asked for
   * @returns SVG text, or null for a name that is no picture and where there is nothing to show
   */
  draw(name: string, results: Results, facts: Asked): string | null {
    if (!isPicture(name)) return null;
    const result = results[PICTURES[name].stage];
    if (!result) return null;
    const drawn = this.#drawn.get(result) ?? new Map<string, string | null>();
    this.#drawn.set(result, drawn);
    const key = `${name} ${facts.round ?? 'last'}`;
    const picture = drawn.get(key) ?? drawPicture(name, results, facts);
    drawn.set(key, picture);
    return picture;
  }
}

function isPicture(name: string): name is PictureName {
  return Object.hasOwn(PICTURES, name);
}
