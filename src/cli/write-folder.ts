import { mkdir, rename, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { FloorPlanError } from '../core/errors.ts';

/** A file's name within the folder and its content. */
export interface NamedContent {
  readonly name: string;
  readonly content: string | Uint8Array;
}

/**
 * Writes files so that none is ever seen half-written: all under temporary names first, then renamed.
 *
 * @throws environment/file-system; no temporary file is left then
 */
export async function writeFolder(folder: string, files: readonly NamedContent[]): Promise<void> {
  const temporary = (name: string) => join(folder, `.${name}.${process.pid}.part`);
  try {
    await mkdir(folder, { recursive: true });
    for (const { name, content } of files) await writeFile(temporary(name), content);
    for (const { name } of files) await rename(temporary(name), join(folder, name));
  } catch (cause) {
    await Promise.all(files.map(({ name }) => rm(temporary(name), { force: true }).catch(() => {})));
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new FloorPlanError(
      'environment/file-system',
      `The folder ${folder} could not be written: ${reason}`,
      {
        hint: 'Name a folder that you may write to, with -o.',
        cause,
      },
    );
  }
}
