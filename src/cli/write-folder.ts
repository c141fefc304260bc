import { mkdir, rename, rm, stat, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
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
    await makeFolder(folder);
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

/** With the folders above it. Node's own `recursive` never returns where a folder answers ENOENT, as /proc does. */
async function makeFolder(folder: string): Promise<void> {
  try {
    await mkdir(folder);
  } catch (error) {
    const parent = dirname(folder);
    if (await isFolder(folder)) return;
    if ((error as NodeJS.ErrnoException).code !== 'ENOENT' || parent === folder) throw error;
    await makeFolder(parent);
    await mkdir(folder);
  }
}

async function isFolder(path: string): Promise<boolean> {
  const facts = await stat(path).catch(() => null);
  return facts?.isDirectory() ?? false;
}
