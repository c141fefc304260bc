import type { ByteSource } from '../bytes/source.ts';
import type { PointChunk, ReadProgress } from '../cloud-reader.ts';
import { BLUE, CHUNK_POINTS, type FieldColumn, INTENSITY, PointBuffer, RED, Z } from '../point-buffer.ts';
import { applyPose } from '../pose.ts';
import type { E57Scan } from './e57-scans.ts';
import { PackedColumn } from './packed-column.ts';
import { PacketReader } from './packets.ts';
import { PagedCursor } from './pages.ts';
import { CARTESIAN, COLOURS, INTENSITY_NAME, type Prototype, type Range, SPHERICAL } from './prototype.ts';

/** Full colour in a {@link PointBuffer} of bytes. */
const FULL_COLOUR = 255;
/** A point is whole where these are 0: else it is a direction only, or nothing. */
const INVALID_STATES = ['cartesianInvalidState', 'sphericalInvalidState'];

export interface E57Points {
  /** At least one. */
  readonly scans: readonly E57Scan[];
  /** Whether points carry the number of their scan in `scans`. */
  readonly hasStations: boolean;
}

/**
 * Points of all scans in the order they lie in the file, each scan in its pose; invalid ones are left out.
 *
 * @throws input/malformed, input/truncated
 */
export async function* readE57Points(
  source: ByteSource,
  { scans, hasStations }: E57Points,
  progress: ReadProgress,
): AsyncGenerator<PointChunk> {
  const cursor = new PagedCursor(source, progress);
  const prototypes = scans.map(({ prototype }) => prototype);
  const buffer = new PointBuffer(
    (field) => prototypes.some((prototype) => hasField(prototype, field)),
    'byte',
  );
  const station = new Uint16Array(CHUNK_POINTS);
  const inOrder = scans.map((scan, number) => ({ scan, number }));
  inOrder.sort((a, b) => a.scan.offset - b.scan.offset);
  try {
    for (const { scan, number } of inOrder) {
      station.fill(number);
      const chunks = readScan(scan, new PacketReader(cursor, scan, source.name), buffer);
      for await (const chunk of chunks) yield hasStations ? { ...chunk, station } : chunk;
    }
  } finally {
    await cursor.close();
  }
}

function hasField({ hasColour, fields }: Prototype, field: number): boolean {
  if (field >= RED && field <= BLUE) return hasColour;
  return field === INTENSITY && fields.some(({ name }) => name === INTENSITY_NAME);
}

async function* readScan(
  scan: E57Scan,
  packets: PacketReader,
  buffer: PointBuffer,
): AsyncGenerator<PointChunk> {
  const run = beginRun(scan, buffer);
  let left = run.count;
  await packets.begin();
  while (left > 0) {
    const count = Math.min(left, buffer.free, ...run.needed.map(({ available }) => available));
    if (count === 0) {
      await packets.next(run.columns, left);
      continue;
    }
    unpackPoints(run, buffer, count);
    left -= count;
    if (buffer.free === 0) yield buffer.take();
  }
  if (buffer.count > 0) yield buffer.take();
}

/** A field of the prototype on its way to one of the buffer's. */
interface WantedField {
  readonly field: number;
  readonly column: PackedColumn;
  /** What becomes 0 … `top`, where that is known. */
  readonly range: Range | undefined;
  readonly top: number;
}

/** One scan while it is read. */
interface ScanRun {
  readonly scan: E57Scan;
  readonly count: number;
  /** One a field of the prototype, null where it is of no use. */
  readonly columns: readonly (PackedColumn | null)[];
  /** Those that are of use. */
  readonly needed: readonly PackedColumn[];
  readonly wanted: readonly WantedField[];
  /** Fields that other scans have. */
  readonly missing: readonly number[];
  readonly state: PackedColumn | null;
  readonly marks: Float64Array;
}

function beginRun(scan: E57Scan, buffer: PointBuffer): ScanRun {
  const { fields, isSpherical, limits } = scan.prototype;
  const names = [...(isSpherical ? SPHERICAL : CARTESIAN), ...COLOURS, INTENSITY_NAME];
  const states = isSpherical ? [...INVALID_STATES].reverse() : INVALID_STATES;
  const stateName = states.find((state) => fields.some(({ name }) => name === state));
  const isWanted = (name: string, field: number) =>
    name === stateName || (field >= 0 && buffer.column(field));
  const columns = fields.map((field) =>
    field.kind !== 'text' && isWanted(field.name, names.indexOf(field.name)) ? new PackedColumn(field) : null,
  );
  const columnOf = (name: string | undefined) =>
    columns.find((column) => column?.field.name === name) ?? null;
  const wanted = names.flatMap((name, field) => {
    const column = columnOf(name);
    const range = field > Z ? limits.get(name) : undefined;
    return column ? [{ field, column, range, top: field === INTENSITY ? 1 : FULL_COLOUR }] : [];
  });
  const missing = names.flatMap((name, field) => (columnOf(name) === null ? [field] : []));
  const placeBits = wanted.reduce(
    (bits, { field, column }) => bits + (field <= Z ? column.field.bits : 0),
    0,
  );
  return {
    scan,
    // Points that take no bytes all lie in one place: any number of them could be announced.
    count: placeBits === 0 ? 1 : scan.count,
    columns,
    needed: columns.filter((column) => column !== null),
    wanted,
    missing,
    state: columnOf(stateName),
    marks: new Float64Array(CHUNK_POINTS),
  };
}

/** Appends `count` points, which must be available, to a buffer with room for them. */
function unpackPoints(
  { scan, wanted, missing, state, marks }: ScanRun,
  buffer: PointBuffer,
  count: number,
): void {
  const first = buffer.count;
  for (const { field, column, range, top } of wanted) {
    const into = buffer.column(field);
    if (!into) continue;
    column.unpack(into, count);
    if (range) stretch(into, count, range, top);
  }
  for (const field of missing) {
    const column = buffer.column(field);
    if (column) fillZeros(column, count);
  }
  if (scan.prototype.isSpherical) toCartesian(buffer.xyz, first, count);
  if (scan.pose) applyPose(buffer.xyz, scan.pose, first, count);
  buffer.count += count;
  if (!state) return;
  state.unpack({ into: marks, first: 0, step: 1 }, count);
  buffer.dropMarked(first, marks);
}

/** Maps `range` to 0 … `top`. */
function stretch({ into, first, step }: FieldColumn, count: number, { low, high }: Range, top: number): void {
  const factor = top / (high - low);
  const end = first + step * count;
  for (let at = first; at < end; at += step) {
    const value = (into[at] - low) * factor;
    into[at] = value > 0 ? Math.min(value, top) : 0;
  }
}

function fillZeros({ into, first, step }: FieldColumn, count: number): void {
  for (let at = first, end = first + step * count; at < end; at += step) into[at] = 0;
}

/** Turns range, azimuth and elevation of `count` points from point `first` on into x, y, z ([E2807] §8.4.4). */
function toCartesian(xyz: Float64Array, first: number, count: number): void {
  for (let at = 3 * first; at < 3 * (first + count); at += 3) {
    const range = xyz[at];
    const azimuth = xyz[at + 1];
    const elevation = xyz[at + 2];
    const across = range * Math.cos(elevation);
    xyz[at] = across * Math.cos(azimuth);
    xyz[at + 1] = across * Math.sin(azimuth);
    xyz[at + 2] = range * Math.sin(elevation);
  }
}
