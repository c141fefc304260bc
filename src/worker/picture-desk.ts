import type { StageResults } from '../core/stage-results.ts';
import type { Session } from '../session/session.ts';
import {
  type PictureFacts as DrawnFacts,
  drawPicture,
  hasPicture,
  PICTURE_NAMES,
  PICTURES,
  type PictureName,
  pictureFile,
  roundsOf,
} from '../write/pictures/pictures.ts';
import type { PictureFacts } from './protocol.ts';

type Results = Partial<StageResults>;
type Asked = Pick<DrawnFacts, 'options' | 'round'>;

/** The pictures that a session's last run has something to show in. */
export function listPictures({
  evidence,
  reports,
  times,
}: Pick<Session, 'evidence' | 'reports' | 'times'>): PictureFacts[] {
  return PICTURE_NAMES.filter((name) => hasPicture(name, evidence)).map((name) => {
    const { label, doc, stage, figure } = PICTURES[name];
    // What there is a picture of has run.
    const { outcome } = reports.find((report) => report.name === stage)!;
    const [ms, rounds] = [times.get(stage) ?? 0, roundsOf(name, evidence)];
    return { name, file: pictureFile(name), stage, label, doc, figure, outcome, ms, rounds };
  });
}

/** Draws the pictures of runs, each once as long as its stage's result lives. */
export class PictureDesk {
  /** By result of a stage: the stages before have made the same as long as it is the same. */
  readonly #drawn = new WeakMap<object, Map<string, string | null>>();

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
