import { FloorPlanError } from '../../core/errors.ts';
import type { ByteCursor } from '../bytes/byte-cursor.ts';
import { viewOf } from '../bytes/view-of.ts';
import { tooFewBytes } from '../cut-off.ts';
import type { MeshBuilder } from '../mesh/mesh.ts';
import { NUMBER_READERS } from '../records.ts';
import { isBlankOrEnd, skipBlanks } from '../text/characters.ts';
import { NumberScanner } from '../text/scan-number.ts';
import { NUMBER_TYPE_OF, type PlyElement, type PlyProperty, type PlyType, valueBytes } from './ply-header.ts';

/** A face with more corners, or any list with more items, is a sign of damage. */
const MOST_ITEMS = 1 << 16;

export interface FaceStream {
  readonly cursor: ByteCursor;
  readonly faces: PlyElement;
  /** Property that lists the vertices. */
  readonly list: number;
  readonly isLittleEndian: boolean;
  readonly name: string;
}

/** Binary faces, one after the other. */
export class FaceRecords {
  readonly #stream: FaceStream;
  #view: DataView = viewOf(new Uint8Array(0));
  #viewed: Uint8Array | undefined;
  #face = 0;
  readonly #corners: number[] = [];

  constructor(stream: FaceStream) {
    this.#stream = stream;
  }

  /** @param builder holds the vertices @throws input/malformed, input/truncated, input/too-large */
  async read(builder: MeshBuilder): Promise<void> {
    const { faces, list, cursor } = this.#stream;
    for (this.#face = 0; this.#face < faces.count; this.#face++) {
      for (let index = 0; index < faces.properties.length; index++) {
        const property = faces.properties[index];
        const { countType } = property;
        // Waiting once a face would cost more than reading it.
        if (countType && cursor.available < valueBytes(countType)) await this.#need(valueBytes(countType));
        const count = countType ? this.#takeCount(countType) : 1;
        const bytes = count * valueBytes(property.type);
        if (cursor.available < bytes) await this.#need(bytes);
        if (index === list) this.#readCorners(count, property, builder.vertices);
        cursor.position += bytes;
      }
      builder.addPolygon(this.#corners);
    }
  }

  /** The cursor holds the count. */
  #takeCount(type: PlyType): number {
    const { cursor } = this.#stream;
    const count = this.#value(type, cursor.position);
    if (!(count >= 0 && count <= MOST_ITEMS))
      throw this.#malformed(`a list of up to ${MOST_ITEMS} items`, count);
    cursor.position += valueBytes(type);
    return Math.floor(count);
  }

  #readCorners(count: number, { type }: PlyProperty, vertices: number): void {
    const { position } = this.#stream.cursor;
    const bytes = valueBytes(type);
    this.#corners.length = 0;
    for (let i = 0; i < count; i++) {
      const vertex = this.#value(type, position + i * bytes);
      if (!(vertex >= 0 && vertex < vertices))
        throw this.#malformed(`a vertex from 0 to ${vertices - 1}`, vertex);
      this.#corners.push(Math.floor(vertex));
    }
  }

  /** The cursor holds the value. */
  #value(type: PlyType, position: number): number {
    const { bytes } = this.#stream.cursor;
    if (bytes !== this.#viewed) {
      this.#viewed = bytes;
      this.#view = viewOf(bytes);
    }
    return NUMBER_READERS[NUMBER_TYPE_OF[type]](this.#view, position, this.#stream.isLittleEndian);
  }

  async #need(bytes: number): Promise<void> {
    const { cursor, faces, name } = this.#stream;
    if (await cursor.fill(bytes)) return;
    throw tooFewBytes(name, { count: faces.count, what: 'face' }, cursor.offset + cursor.available);
  }

  #malformed(expected: string, found: number): FloorPlanError {
    const { cursor, name } = this.#stream;
    return malformed(
      `${name}: expected ${expected} in face ${this.#face} at byte ${cursor.offset}, found ${found}`,
      {
        offset: cursor.offset,
      },
    );
  }
}

export interface TextFace {
  /** Whole lines. */
  readonly bytes: Uint8Array;
  readonly begin: number;
  readonly faces: PlyElement;
  readonly list: number;
  readonly name: string;
  readonly line: number;
}

/** One face of a text file. @param builder holds the vertices @throws input/malformed, input/too-large */
export function readTextFace(face: TextFace, builder: MeshBuilder): void {
  const { faces, list } = face;
  const row = new FaceRow(face);
  for (let index = 0; index < list; index++) {
    const items = faces.properties[index].countType ? row.next() : 1;
    for (let i = 0; i < items; i++) row.skip();
  }
  const corners: number[] = [];
  for (let left = row.next(); left > 0; left--) {
    const vertex = row.next();
    if (!(vertex < builder.vertices))
      throw row.malformed(`a vertex from 0 to ${builder.vertices - 1}`, `${vertex}`);
    corners.push(vertex);
  }
  builder.addPolygon(corners);
}

/** Whole numbers of a line, one after the other. */
class FaceRow {
  readonly #face: TextFace;
  readonly #scanner = new NumberScanner();
  #at: number;

  constructor(face: TextFace) {
    this.#face = face;
    this.#at = face.begin;
  }

  next(): number {
    const { bytes } = this.#face;
    const begin = this.skip();
    const value = this.#scanner.scan(bytes, begin, false);
    if (value !== undefined && value >= 0 && this.#scanner.position === this.#at) return Math.floor(value);
    const text = new TextDecoder().decode(bytes.subarray(begin, Math.min(this.#at, begin + 40)));
    throw this.malformed('whole numbers, the vertices of a face,', `"${text}"`);
  }

  /** Moves past the next field; returns where it began. */
  skip(): number {
    const { bytes } = this.#face;
    const begin = skipBlanks(bytes, this.#at);
    this.#at = begin;
    while (!isBlankOrEnd(bytes[this.#at])) this.#at++;
    return begin;
  }

  malformed(expected: string, found: string): FloorPlanError {
    const { name, line } = this.#face;
    return malformed(`${name}: expected ${expected} in line ${line}, found ${found}`, { line });
  }
}

function malformed(message: string, detail: Readonly<Record<string, number>>): FloorPlanError {
  return new FloorPlanError('input/malformed', message, {
    hint: 'The file seems damaged; export the mesh again.',
    detail,
  });
}
