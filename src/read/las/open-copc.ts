import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud, PointChunk, ReadProgress } from '../cloud-reader.ts';
import { tooFewBytes } from '../cut-off.ts';
import { CopcHierarchy, type CopcInfo, type CopcNode, readCopcInfo } from './copc-hierarchy.ts';
import { malformed } from './las-header.ts';
import { type LaszipRecord, readLaszipRecord } from './laszip-record.ts';
import { LazDecoder } from './laz-decoder.ts';
import { type LasFile, lasCloud, type ReadCount, readLasFile } from './open-las.ts';
import { openLazFile } from './open-laz.ts';

/** Points of a rough whole: enough to judge the unit, some hundred kilobytes. */
const ROUGH_POINTS = 200_000;
/** Nodes nearer together than this are fetched at once, up to a piece of some megabytes. */
const GAP_BYTES = 1 << 16;
const PIECE_BYTES = 1 << 22;

/**
 * Reads the header of a COPC file: a LAZ file whose chunks are the nodes of an octree. Only nodes coarse enough for the
 * spacing asked for are fetched; where slices cost all bytes before them, it is read as the LAZ file that it is too.
 *
 * @throws input/…
 */
export async function openCopc(source: ByteSource): Promise<OpenCloud> {
  const file = await readLasFile(source);
  if (source.isSequential) return openLazFile(file);
  const laszip = readLaszipRecord(source.name, file.header, file.records);
  const info = readCopcInfo(source.name, file.records);
  const cloud = lasCloud(file, (progress, spacing) => readNodes({ file, laszip, info, spacing }, progress));
  return { ...cloud, isAdaptive: true };
}

interface NodeReading {
  readonly file: LasFile;
  readonly laszip: LaszipRecord;
  readonly info: CopcInfo;
  readonly spacing: number;
}

/** In file order, neighbours fetched together. Progress is the place in the file up to which all is read or passed over. */
async function* readNodes(
  reading: NodeReading,
  progress: ReadProgress,
): AsyncGenerator<PointChunk, ReadCount> {
  const { file, laszip } = reading;
  const { source, header } = file;
  const nodes = inFileOrder(source.name, await chooseNodes(reading));
  const decoder = await LazDecoder.create(file, laszip);
  for (const run of runsOf(nodes)) {
    const begin = run[0].offset;
    const last = run[run.length - 1];
    const end = last.offset + last.bytes;
    const piece = await source.slice(begin, end);
    if (piece.length < end - begin)
      throw tooFewBytes(source.name, { count: header.count, needed: end }, begin + piece.length);
    progress(end);
    for (const { offset, bytes, points } of run) {
      const chunk = piece.subarray(offset - begin, offset - begin + bytes);
      yield* decoder.decode({ bytes: chunk, points, offset });
    }
  }
  yield* decoder.flush();
  if (source.size !== undefined) progress(source.size);
  return decoder.count;
}

/** The levels down to the one whose points lie `spacing` apart; without a spacing, those that make a rough whole. */
async function chooseNodes({ file, info, spacing }: NodeReading): Promise<CopcNode[]> {
  const hierarchy = new CopcHierarchy(file.source, info.root, file.header.count);
  const chosen: CopcNode[] = [];
  let points = 0;
  for (let level = 0; ; level++) {
    await hierarchy.load(level);
    const nodes = hierarchy.nodes.filter((node) => node.level === level);
    chosen.push(...nodes);
    points += nodes.reduce((sum, node) => sum + node.points, 0);
    const isFine = spacing > 0 ? info.spacing / 2 ** level <= spacing : points >= ROUGH_POINTS;
    if (isFine || !hierarchy.reaches(level + 1)) return chosen;
  }
}

/** A node told twice would double its points. @throws input/malformed */
function inFileOrder(name: string, nodes: readonly CopcNode[]): CopcNode[] {
  const sorted = [...nodes].sort((a, b) => a.offset - b.offset);
  let end = 0;
  for (const { offset, bytes } of sorted) {
    if (offset < end) throw malformed(name, offset, 'nodes of the octree side by side', 'two in one place');
    end = offset + bytes;
  }
  return sorted;
}

function* runsOf(nodes: readonly CopcNode[]): Generator<CopcNode[]> {
  let run: CopcNode[] = [];
  for (const node of nodes) {
    const last = run.at(-1);
    const isNear = last && node.offset - (last.offset + last.bytes) <= GAP_BYTES;
    if (isNear && node.offset + node.bytes - run[0].offset <= PIECE_BYTES) run.push(node);
    else {
      if (run.length > 0) yield run;
      run = [node];
    }
  }
  if (run.length > 0) yield run;
}
