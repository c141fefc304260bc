import { FloorPlanError } from '../core/errors.ts';
import type { ScanFile } from '../worker/protocol.ts';
import type { FilesShown } from './model.ts';

/** The files opened together, and whether all of them or one is the scan. */
export class OpenedFiles {
  #files: readonly ScanFile[] = [];
  #shown: FilesShown = { names: [], picked: null };

  /** What is read: parts of one scan. */
  get chosen(): readonly ScanFile[] {
    const { picked } = this.#shown;
    return picked === null ? this.#files : [this.#files[picked]];
  }

  get shown(): FilesShown {
    return this.#shown;
  }

  /** All of them at first. @throws input/empty */
  take(files: readonly ScanFile[]): void {
    if (files.length === 0) {
      throw new FloorPlanError('input/empty', 'expected a scan, found no file', {
        hint: 'Give one file or more.',
      });
    }
    this.#files = files;
    this.#shown = { names: files.map(({ name }) => name), picked: null };
  }

  /** @param picked index of a file; null for all as one scan */
  pick(picked: number | null): void {
    this.#shown = { ...this.#shown, picked };
  }
}
