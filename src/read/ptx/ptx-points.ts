import { FloorPlanError } from '../../core/errors.ts';
import type { Vec3, Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { PointChunk, ReadProgress } from '../cloud-reader.ts';
import { cutOff, goOnWith, tooFewRows } from '../cut-off.ts';
import { BLUE, CHUNK_POINTS, INTENSITY, PointBuffer, RED, X, Z } from '../point-buffer.ts';
import { applyPose, MOST_STATIONS } from '../pose.ts';
import { BLANK, skipBlanks } from '../text/characters.ts';
import { LastRow } from '../text/last-row.ts';
import { type LineBlock, lineBlocks } from '../text/line-blocks.ts';
import { type RowLayout, RowParser } from '../text/row-parser.ts';
import { NumberScanner } from '../text/scan-number.ts';
import { HEADER_LINES, PtxFault, type PtxHeader, parsePtxHeader } from './ptx-header.ts';

const ZERO = 48;
const SHOWN_CHARACTERS = 40;
const COLOURS = [RED, RED + 1, BLUE];

export interface PtxPoints {
  /** Emptied, then filled with the scanners' places. */
  readonly stations: Vec3[];
  readonly warnings: Warning[];
}

/**
 * Points of all scans, each in its place; rows of zeros, where no ray came back, are passed over.
 *
 * @throws input/malformed, input/truncated, input/too-large
 */
export async function* readPtxPoints(
  source: ByteSource,
  { stations, warnings }: PtxPoints,
  progress: ReadProgress,
): AsyncGenerator<PointChunk> {
  const reader = new PtxReader(source.name, stations);
  for await (const block of lineBlocks(source, 0, progress)) {
    let at = 0;
    while (at < block.bytes.length) {
      at = reader.read(block, at);
      const chunk = reader.take();
      if (chunk) yield chunk;
    }
  }
  reader.end(warnings);
  const rest = reader.take();
  if (rest) yield rest;
}

/** Reads lines one by one and knows whether the next belongs to a header or to points. */
class PtxReader {
  readonly #name: string;
  readonly #stations: Vec3[];
  readonly #station = new Uint16Array(CHUNK_POINTS);
  readonly #scanner = new NumberScanner();
  /** Those of a header that is not yet whole. */
  #headerLines: string[] = [];
  #header: PtxHeader = { count: 0, pose: { rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], translation: [0, 0, 0] } };
  /** Rows of the scan that are still to come. */
  #left = 0;
  #parser: RowParser;
  /** Rows announced by all scans so far. */
  #announced = 0;
  readonly #last = new LastRow();
  /** Whether the scan's columns are known. */
  #isLaidOut = false;
  #buffer: PointBuffer | null = null;

  constructor(name: string, stations: Vec3[]) {
    this.#name = name;
    this.#stations = stations;
    this.#parser = new RowParser(layoutOf(3), { name, line: 1 });
    stations.length = 0;
  }

  /** Reads lines from `begin` until points are to be taken or the lines end, and returns where. */
  read(block: LineBlock, begin: number): number {
    const { bytes } = block;
    let at = this.#parser.seek(bytes, begin);
    while (at < bytes.length && !this.#isDue()) {
      at = this.#left > 0 ? this.#readRow(block, at) : this.#readHeaderLine(bytes, at);
      at = this.#parser.seek(bytes, at);
    }
    return at;
  }

  /** The points read, where a chunk is full or the scan has ended. */
  take(): PointChunk | null {
    if (!this.#buffer || !this.#isDue()) return null;
    const chunk = this.#buffer.take();
    applyPose(chunk.xyz, this.#header.pose, 0, chunk.count);
    return { ...chunk, station: this.#station };
  }

  /** Says where the file ended too soon. @throws input/truncated, where little is whole */
  end(warnings: Warning[]): void {
    const { count } = this.#header;
    const left = this.#left;
    const isShort = left > 0 || this.#headerLines.length > 0;
    if (!isShort) return;
    const few =
      left > 0 ? tooFewRows(this.#name, count, count - left) : headerCut(this.#name, this.#parser.line);
    const announced = this.#announced;
    goOnWith({ found: announced - left, announced }, this.#last.fault ?? few, warnings);
    this.#left = 0;
  }

  #isDue(): boolean {
    if (!this.#buffer || this.#buffer.count === 0) return false;
    return this.#buffer.free === 0 || this.#left === 0;
  }

  #readHeaderLine(bytes: Uint8Array, begin: number): number {
    const end = this.#parser.skipLine(bytes, begin);
    const line = new TextDecoder().decode(bytes.subarray(begin, end)).trim();
    if (this.#headerLines.push(line) === HEADER_LINES) this.#beginScan();
    return end;
  }

  #beginScan(): void {
    const lines = this.#headerLines;
    const header = parsePtxHeader(lines);
    if (header instanceof PtxFault) {
      throw malformedHeader(this.#name, header, this.#parser.line - HEADER_LINES, lines[header.line]);
    }
    this.#headerLines = [];
    this.#header = header;
    this.#left = header.count;
    this.#announced += header.count;
    this.#isLaidOut = false;
    if (this.#stations.length === MOST_STATIONS) throw tooManyScans(this.#name);
    this.#station.fill(this.#stations.length);
    this.#stations.push(header.pose.translation);
  }

  #readRow(block: LineBlock, begin: number): number {
    const { bytes } = block;
    const isNoReturn = this.#isNoReturn(bytes, begin);
    if (!isNoReturn && !this.#isLaidOut) this.#layOut(bytes, begin);
    const isWhole = isNoReturn && this.#left === 1;
    if (!isWhole && this.#last.isCut(block, begin, this.#left, this.#parser)) return bytes.length;
    this.#left--;
    if (isNoReturn) return this.#parser.skipLine(bytes, begin);
    const end = this.#parser.read(bytes, begin, false);
    const { values } = this.#parser;
    // Zeros spelt otherwise: -0, .0
    if (values[X] !== 0 || values[X + 1] !== 0 || values[Z] !== 0) this.#buffer?.push(values);
    return end;
  }

  /** Whether x, y and z are 0; a row that does not begin with a 0 is not looked at further. */
  #isNoReturn(bytes: Uint8Array, begin: number): boolean {
    let at = skipBlanks(bytes, begin);
    if (bytes[at] !== ZERO) return false;
    for (let axis = X; axis <= Z; axis++) {
      at = skipBlanks(bytes, at);
      if (this.#scanner.scan(bytes, at, true) !== 0) return false;
      at = this.#scanner.position;
    }
    return true;
  }

  /** Finds the columns in the scan's first row with a return; which attributes chunks have, the first scan tells. */
  #layOut(bytes: Uint8Array, begin: number): void {
    const { line } = this.#parser;
    const end = new RowParser(layoutOf(0), { name: this.#name, line }).skipLine(bytes, begin);
    const row = new TextDecoder().decode(bytes.subarray(begin, end)).trim();
    const layout = layoutOf(row.split(/[ \t]+/).length);
    this.#parser = new RowParser(layout, { name: this.#name, line });
    this.#buffer ??= new PointBuffer((field) => layout.targets.includes(field));
    this.#isLaidOut = true;
  }
}

/** x y z, then intensity, then red, green and blue; six columns have no intensity. */
function layoutOf(columns: number): RowLayout {
  const place = [X, X + 1, Z];
  if (columns >= 7) return { separator: BLANK, targets: Int8Array.of(...place, INTENSITY, ...COLOURS) };
  if (columns === 6) return { separator: BLANK, targets: Int8Array.of(...place, ...COLOURS) };
  return { separator: BLANK, targets: Int8Array.from(columns > 3 ? [...place, INTENSITY] : place) };
}

function malformedHeader(name: string, { line, expected }: PtxFault, first: number, found: string) {
  const shown = found.slice(0, SHOWN_CHARACTERS);
  return new FloorPlanError(
    'input/malformed',
    `${name}: expected ${expected} in line ${first + line} of a PTX header, found "${shown}"`,
    {
      hint: 'Export the scans again; a wrong number of columns or rows shifts all that follows.',
      detail: { line: first + line, text: shown },
    },
  );
}

function headerCut(name: string, line: number) {
  const found = `the end of the file before line ${line}`;
  return cutOff(name, `${HEADER_LINES} lines of a PTX header`, found, { line });
}

function tooManyScans(name: string) {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected at most ${MOST_STATIONS} scans, found more`,
    {
      hint: 'Export the scans in several files.',
      detail: { scans: MOST_STATIONS },
    },
  );
}
