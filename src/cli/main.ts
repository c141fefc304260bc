#!/usr/bin/env node
import { join } from 'node:path';
import { FloorPlanError, type PlainError, toPlainError } from '../core/errors.ts';
import type { Progress } from '../core/pipeline-run.ts';
import { STAGES } from '../core/stages.ts';
import type { ByteSource } from '../read/bytes/source.ts';
import { urlSource } from '../read/bytes/url-source.ts';
import { makeReport, type Report } from '../session/report.ts';
import { baseName, Session } from '../session/session.ts';
import { writePictures } from '../write/pictures/pictures.ts';
import type { WrittenFile } from '../write/plan-writer.ts';
import { type Command, parseArguments } from './arguments.ts';
import { createStrokeTest } from './canvas-stroke.ts';
import { helpText } from './help.ts';
import { makeNodeCanvas } from './node-canvas.ts';
import { nodeSource } from './node-source.ts';
import { summaryText } from './summary.ts';
import { writeFolder } from './write-folder.ts';

declare const GRUNDRISS_VERSION: string;

// Who reads the output may leave before its end, as `head` does; the files are written all the same.
for (const stream of [process.stdout, process.stderr]) {
  stream.on('error', (error: NodeJS.ErrnoException) => {
    if (error.code !== 'EPIPE') throw error;
  });
}
process.exitCode = await main(process.argv.slice(2));

/** @returns the exit code: 0 done, 2 options, 3 input, 4 no plan, 5 environment, 130, 70 */
async function main(words: readonly string[]): Promise<number> {
  const controller = new AbortController();
  process.once('SIGINT', () => controller.abort());
  try {
    const command = parseArguments(words);
    if (command.task === 'help') process.stdout.write(helpText());
    else if (command.task === 'version') process.stdout.write(`${GRUNDRISS_VERSION}\n`);
    else await runAll(command, controller.signal);
    return 0;
  } catch (error) {
    const plain = toPlainError(error);
    process.stderr.write(
      words.includes('--json') ? `${JSON.stringify({ error: plain })}\n` : errorLine(plain),
    );
    if (plain.code === 'bug' && error instanceof Error) process.stderr.write(`${error.stack}\n`);
    return exitCode(plain.code);
  }
}

async function runAll(command: Command, signal: AbortSignal): Promise<void> {
  const folders = outputFolders(command);
  const scans = command.isMerge ? [command.inputs] : command.inputs.map((input) => [input]);
  for (const [i, inputs] of scans.entries()) {
    const report = await runOne(inputs, folders[i], command, signal);
    if (process.stderr.isTTY) process.stderr.write(summaryText(report));
    process.stdout.write(`${JSON.stringify(report)}\n`);
  }
}

/** One scan writes into the folder itself, several into a folder each; equal names are numbered. */
function outputFolders({ inputs, folder, isMerge }: Command): readonly string[] {
  if (inputs.length === 1 || isMerge) return [folder];
  const taken = new Set<string>();
  return inputs.map((input) => {
    const name = baseName(fileName(input));
    let unique = name;
    for (let n = 2; taken.has(unique); n++) unique = `${name}-${n}`;
    taken.add(unique);
    return join(folder, unique);
  });
}

async function runOne(
  inputs: readonly string[],
  folder: string,
  command: Command,
  signal: AbortSignal,
): Promise<Report> {
  const session = new Session({ strokeTest: createStrokeTest(), makeCanvas: makeNodeCanvas });
  const bar = progressBar(inputs.map(fileName).join(' + '));
  const start = performance.now();
  const sources: ByteSource[] = [];
  for (const input of inputs) sources.push(await openInput(input, signal));
  try {
    const result = await session.load(sources, command.options, { signal, onProgress: bar.show });
    const files = await writeFormats(session, command);
    const memory = process.resourceUsage().maxRSS / 1024;
    const report = makeReport(result, performance.now() - start, memory);
    const all = [...files, { name: 'report.json', content: `${JSON.stringify(report, null, 2)}\n` }];
    if (signal.aborted) throw new FloorPlanError('cancelled', 'The run was cancelled.');
    await writeFolder(folder, all);
    return report;
  } catch (error) {
    if (!signal.aborted && command.formats.includes('pictures')) await writeEvidence(session, folder);
    throw error;
  } finally {
    bar.end();
  }
}

/** The files of all formats; of those that nobody named the plan may lack what one needs. */
async function writeFormats(
  session: Session,
  { formats, hasNamedFormats }: Command,
): Promise<readonly WrittenFile[]> {
  const files: WrittenFile[] = [];
  for (const format of formats) {
    try {
      files.push(...(await session.write(format)));
    } catch (error) {
      if (hasNamedFormats || toPlainError(error).code !== 'result/cannot-write') throw error;
    }
  }
  return files;
}

/** The pictures of the stages before the one that failed; what failed first is what is told. */
async function writeEvidence({ evidence }: Session, folder: string): Promise<void> {
  const pictures = writePictures(evidence);
  if (pictures.length > 0) await writeFolder(folder, pictures).catch(() => {});
}

/** A path or an address. */
async function openInput(input: string, signal: AbortSignal): Promise<ByteSource> {
  return /^https?:/.test(input) ? urlSource(input, signal) : nodeSource(input, signal);
}

/** A line on a terminal that tells stage and share; nothing elsewhere. */
function progressBar(title: string): { show(progress: Progress): void; end(): void } {
  const width = 24;
  if (!process.stderr.isTTY) return { show: () => {}, end: () => {} };
  return {
    show({ stage, share }) {
      const done = Math.round(share * width);
      const bar = '█'.repeat(done) + '░'.repeat(width - done);
      process.stderr.write(`\r\x1b[K${title} ${bar} ${Math.round(share * 100)} % ${STAGES[stage].label}`);
    },
    end: () => void process.stderr.write('\r\x1b[K'),
  };
}

function errorLine({ code, message, hint }: PlainError): string {
  return `grundriss: ${code}: ${message}${hint ? ` (${hint})` : ''}\n`;
}

function exitCode(code: string): number {
  const codes: Record<string, number> = { option: 2, input: 3, result: 4, environment: 5, cancelled: 130 };
  return codes[code.split('/')[0]] ?? 70;
}

function fileName(input: string): string {
  return input.split(/[\\/]/).pop() || input;
}
