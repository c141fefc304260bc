import { FloorPlanError } from '../../core/errors.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud, ReadProgress } from '../cloud-reader.ts';
import { latin1 } from '../signatures.ts';
import { isBlank, skipBlanks } from '../text/characters.ts';
import { NumberScanner, parseNumber } from '../text/scan-number.ts';
import { type Mesh, MeshBuilder } from './mesh.ts';
import { meshCloud } from './mesh-cloud.ts';
import { readLines } from './obj-lines.ts';

const SMALL_V = 118;
const SMALL_F = 102;
const HASH = 35;
/** x y z and, after them, w or r g b or both. */
const MOST_VALUES = 7;
const SHOWN_CHARACTERS = 40;

/** A Wavefront OBJ file; what is not a vertex or a face is passed over. @throws input/… from `chunks` */
export async function openObj(source: ByteSource): Promise<OpenCloud> {
  return meshCloud({ source, load: (progress) => readObj(source, progress) });
}

/** @throws input/malformed, with the line; input/too-large */
async function readObj(source: ByteSource, progress: ReadProgress): Promise<Mesh> {
  const reader = new ObjReader(source.name);
  await readLines(source, (bytes, begin, end, line) => reader.read(bytes, begin, end, line), progress);
  return reader.finish();
}

class ObjReader {
  readonly #builder: MeshBuilder;
  readonly #scanner = new NumberScanner();
  readonly #values = new Float64Array(MOST_VALUES);
  readonly #name: string;
  #corners: number[] = [];
  #faces = 0;
  /** 255 while colours stay within 0 … 1. */
  #colourScale = 255;

  constructor(name: string) {
    this.#name = name;
    this.#builder = new MeshBuilder(name);
  }

  read(bytes: Uint8Array, begin: number, end: number, line: number): void {
    const at = skipBlanks(bytes, begin);
    if (at + 1 >= end || !isBlank(bytes[at + 1])) return;
    if (bytes[at] === SMALL_V) this.#readVertex({ bytes, end, line }, at + 2);
    else if (bytes[at] === SMALL_F) this.#readFace({ bytes, end, line }, at + 2);
  }

  /** Without faces every vertex is a point. */
  finish(): Mesh {
    if (this.#faces === 0) this.#builder.addPoints(0, this.#builder.vertices);
    return this.#builder.build();
  }

  #readVertex(place: Line, begin: number): void {
    const values = this.#values;
    let count = 0;
    let at = skipBlanks(place.bytes, begin);
    while (at < place.end && count < MOST_VALUES && place.bytes[at] !== HASH) {
      values[count++] = this.#number(place, at);
      at = skipBlanks(place.bytes, fieldEnd(place.bytes, at, place.end));
    }
    if (count < 3) throw this.#malformed(place, begin, 'a vertex of three numbers');
    this.#builder.addVertex(values[0], values[1], values[2]);
    if (count < 6) return;
    const first = count === 6 ? 3 : 4;
    if (Math.max(values[first], values[first + 1], values[first + 2]) > 1) this.#colourScale = 1;
    const scale = this.#colourScale;
    this.#builder.paintVertex(values[first] * scale, values[first + 1] * scale, values[first + 2] * scale);
  }

  #readFace(place: Line, begin: number): void {
    this.#faces++;
    this.#corners.length = 0;
    let at = skipBlanks(place.bytes, begin);
    while (at < place.end && place.bytes[at] !== HASH) {
      this.#corners.push(this.#corner(place, at));
      at = skipBlanks(place.bytes, fieldEnd(place.bytes, at, place.end));
    }
    this.#builder.addPolygon(this.#corners);
  }

  /** The vertex of a corner such as 7, 7/1, 7//3, -1/2/3: counted from 1, or back from the last one. */
  #corner(place: Line, begin: number): number {
    const { vertices } = this.#builder;
    const index = this.#scanner.scan(place.bytes, begin, false) ?? 0;
    const vertex = index < 0 ? vertices + index : index - 1;
    if (Number.isInteger(vertex) && vertex >= 0 && vertex < vertices) return vertex;
    throw this.#malformed(place, begin, `a vertex from 1 to ${vertices}, the ones before this line,`);
  }

  #number(place: Line, begin: number): number {
    const end = fieldEnd(place.bytes, begin, place.end);
    const value = this.#scanner.scan(place.bytes, begin, false);
    if (value !== undefined && this.#scanner.position === end) return value;
    const spelled = parseNumber(latin1(place.bytes.subarray(begin, end)), true);
    if (spelled === undefined) throw this.#malformed(place, begin, 'a number');
    return spelled;
  }

  #malformed({ bytes, end, line }: Line, begin: number, expected: string): FloorPlanError {
    const text = latin1(bytes.subarray(begin, Math.min(end, begin + SHOWN_CHARACTERS))).trim();
    return new FloorPlanError(
      'input/malformed',
      `${this.#name}: expected ${expected} in line ${line}, found "${text}"`,
      {
        hint: 'The file seems damaged; export the model again.',
        detail: { line, text },
      },
    );
  }
}

interface Line {
  readonly bytes: Uint8Array;
  readonly end: number;
  readonly line: number;
}

function fieldEnd(bytes: Uint8Array, begin: number, end: number): number {
  let at = begin;
  while (at < end && !isBlank(bytes[at])) at++;
  return at;
}
