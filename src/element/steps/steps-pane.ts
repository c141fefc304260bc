import { FloorPlanError } from '../../core/errors.ts';
import { PictureView } from '../../view/picture.ts';
import type { PictureFacts } from '../../worker/protocol.ts';
import { saveFile } from '../files.ts';
import { make, setAttribute, setText } from '../make.ts';
import type { Actions, Model } from '../model.ts';
import { saySentence } from '../plain-words.ts';
import { addStyles } from '../styles.ts';
import { Caption } from './caption.ts';
import { ClusterPicker } from './cluster-picker.ts';
import { ComparePanel } from './compare-panel.ts';
import { FailedBanner } from './failed-banner.ts';
import { Filmstrip } from './filmstrip.ts';
import { PictureShelf } from './picture-shelf.ts';
import stepsStyles from './steps.css?inline';

/** Keys that leaf through the steps, where they do not move the picture. */
const KEYS: Readonly<Record<string, 1 | -1>> = { ArrowLeft: -1, ArrowRight: 1 };
const HINT = 'Arrow keys move it, plus and minus zoom, 0 shows all, square brackets change the step.';

/** The chain step by step: one picture large, all in small, and two plans compared. */
export class StepsPane {
  readonly node: HTMLElement;
  readonly #actions: Actions;
  readonly #onCompare: (isComparing: boolean) => void;
  readonly #host = make('div', { class: 'sheet step-sheet', id: 'step-picture', testid: 'step-picture' });
  readonly #notice = make('p', { class: 'notice', hidden: true, role: 'status' });
  readonly #view: PictureView;
  readonly #shelf: PictureShelf;
  readonly #banner: FailedBanner;
  readonly #caption: Caption;
  readonly #clusters: ClusterPicker;
  readonly #strip: Filmstrip;
  readonly #compare: ComparePanel;
  #model: Model | null = null;
  /** Of the search for structures, as chosen; beyond the last it is the last. */
  #round = Number.POSITIVE_INFINITY;
  /** SVG text on show, and what it is of. */
  #shown = '';
  #subject = '';
  /** Counts what was asked for: an answer that comes late is not shown. */
  #asked = 0;

  /** @param onCompare a comparison was opened, or left */
  constructor(actions: Actions, root: ShadowRoot, onCompare: (isComparing: boolean) => void) {
    this.#actions = actions;
    this.#onCompare = onCompare;
    addStyles(root, stepsStyles);
    this.#shelf = new PictureShelf((asked) => actions.picture(asked));
    this.#view = new PictureView(this.#host, (picked) => this.#clusters.pick(picked));
    this.#banner = new FailedBanner(actions);
    this.#caption = new Caption(actions, {
      onSave: () => this.#save(),
      onRound: (round) => {
        this.#round = round;
        if (this.#model) this.show(this.#model);
      },
    });
    this.#clusters = new ClusterPicker(actions);
    this.#strip = new Filmstrip(actions);
    this.#compare = new ComparePanel(actions, {
      onPicture: () => this.#showComparison(),
      onClose: () => this.compare(false),
      onSave: () => this.#save(),
    });
    this.node = make(
      'div',
      { class: 'steps', on: { keydown: (event: KeyboardEvent) => this.#key(event) } },
      this.#banner.node,
      make('div', { class: 'picture-place' }, this.#host, this.#notice),
      this.#clusters.node,
      this.#caption.node,
      this.#strip.node,
      this.#compare.node,
    );
  }

  get isComparing(): boolean {
    return !this.#compare.node.hidden;
  }

  show(model: Model): void {
    this.#model = model;
    const { picture, pictures, of } = model.steps;
    if (!picture) return;
    // Nothing to compare a failed run with.
    if (of === 'failed') this.compare(false);
    const isAnother = this.#shelf.turnTo(runOf(model), of);
    this.#banner.show(model);
    this.#caption.show(model.steps, picture, this.#roundOf(picture));
    this.#clusters.show(model);
    if (this.isComparing) this.#clusters.node.hidden = true;
    this.#strip.show(pictures, picture);
    this.#compare.show(model);
    setAttribute(this.#host, 'aria-label', `${picture.label}. ${HINT}`);
    if (!this.isComparing) void this.#showPicture(picture);
    if (isAnother) void this.#develop(pictures);
  }

  /** Puts two plans side by side in place of the step's picture, or goes back to it. */
  compare(isComparing: boolean): void {
    if (!this.#model || isComparing === this.isComparing) return;
    if (isComparing) this.#compare.open(this.#model);
    else this.#compare.close();
    this.#onCompare(isComparing);
    for (const part of [this.#caption.node, this.#strip.node]) part.hidden = isComparing;
    this.#clusters.node.hidden = true;
    if (isComparing) return;
    this.#shown = '';
    this.show(this.#model);
  }

  /** The keyboard goes to the picture. */
  focus(): void {
    this.#host.focus();
  }

  fit(): void {
    this.#view.fit();
  }

  zoomIn(): void {
    this.#view.zoomIn();
  }

  zoomOut(): void {
    this.#view.zoomOut();
  }

  dispose(): void {
    this.#compare.close();
    this.#view.dispose();
    this.#strip.dispose();
    this.node.remove();
  }

  async #showPicture(picture: PictureFacts): Promise<void> {
    const { name, label, rounds } = picture;
    const asked = ++this.#asked;
    try {
      const svg = await this.#shelf.get(name, rounds > 1 ? this.#roundOf(picture) : undefined);
      if (asked === this.#asked) this.#put(svg, name, `${label}: this plan has nothing to show here.`);
    } catch (error) {
      if (asked === this.#asked) this.#put(null, name, sayError(error));
    }
  }

  #showComparison(): void {
    if (!this.isComparing) return;
    this.#asked++;
    const svg = this.#compare.picture;
    // The picture before stays while the next is made.
    if (svg) this.#put(svg, `comparison ${this.#compare.look}`, '');
  }

  /** @param subject what the picture is of: the next of the same subject keeps place and zoom */
  #put(svg: string | null, subject: string, otherwise: string): void {
    this.#notice.hidden = svg !== null;
    this.#host.classList.toggle('is-empty', svg === null);
    setText(this.#notice, svg === null ? otherwise : '');
    if (svg === null || svg === this.#shown) return;
    this.#view.show(svg, subject !== this.#subject);
    this.#shown = svg;
    this.#subject = subject;
  }

  /** The small pictures, one after the other, so that none holds up the large one. */
  async #develop(pictures: readonly PictureFacts[]): Promise<void> {
    const run = runOf(this.#model);
    for (const { name } of pictures) {
      const svg = await this.#shelf.get(name).catch(() => null);
      if (run !== runOf(this.#model)) return;
      if (svg) this.#strip.setPicture(name, svg);
    }
  }

  #roundOf({ rounds }: PictureFacts): number {
    return Math.min(this.#round, rounds);
  }

  #save(): void {
    const { picture } = this.#model?.steps ?? {};
    if (this.#shown === '' || !picture) return;
    const name = this.isComparing ? `comparison-${this.#compare.name}.svg` : this.#fileOf(picture);
    const blob = new Blob([this.#shown], { type: 'image/svg+xml' });
    saveFile({ name, blob });
  }

  #fileOf(picture: PictureFacts): string {
    if (picture.rounds === 1) return picture.file;
    return picture.file.replace('.svg', `-round-${this.#roundOf(picture)}.svg`);
  }

  #key(event: KeyboardEvent): void {
    if (event.key === 'Escape' && this.isComparing) {
      event.stopPropagation();
      this.compare(false);
      this.focus();
      return;
    }
    const by = KEYS[event.key];
    const [target] = event.composedPath() as [HTMLElement];
    if (!by || this.isComparing || target === this.#host || target.matches('input, select')) return;
    event.preventDefault();
    this.#actions.moveStep(by);
    if (target.role === 'tab') this.#strip.keepFocus();
  }
}

/** Whose pictures are shown. */
function runOf(model: Model | null): object | null {
  return model && (model.steps.of === 'failed' ? model.failed : model.view);
}

function sayError(error: unknown): string {
  if (!(error instanceof FloorPlanError))
    return 'This picture could not be drawn. This is a bug; please report it.';
  if (error.code === 'cancelled') return '';
  return saySentence(`${error.message} ${error.hint} (${error.code})`);
}
