import { ByteCursor } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud, ReadProgress } from '../cloud-reader.ts';
import { tooFewRows } from '../cut-off.ts';
import { canHoldMesh, type Mesh, MeshBuilder } from '../mesh/mesh.ts';
import { meshCloud } from '../mesh/mesh-cloud.ts';
import { lineBlocks } from '../text/line-blocks.ts';
import { type RowLayout, RowParser } from '../text/row-parser.ts';
import {
  type PlyBody,
  type PlyDecoder,
  readBinaryVertices,
  skipElement,
  vertexBuffer,
} from './ply-binary.ts';
import { FaceRecords, readTextFace } from './ply-faces.ts';
import type { PlyElement, PlyHeader } from './ply-header.ts';

/** A PLY file whose vertices are joined by faces. */
export interface PlyMeshFile {
  readonly source: ByteSource;
  readonly header: PlyHeader;
  readonly body: PlyBody;
  readonly layout: RowLayout;
  /** Elements after the vertices, the faces last. */
  readonly after: readonly PlyElement[];
  /** Which of the faces' properties lists the vertices. */
  readonly list: number;
}

/** The faces of a PLY as a cloud sampled on them; null where they are too many to be held. */
export function openPlyMesh(file: PlyMeshFile): OpenCloud | null {
  const { source, header, body, after } = file;
  const vertices = body.elements[body.elements.length - 1].count;
  if (!canHoldMesh(vertices, after[after.length - 1].count)) return null;
  const load = header.format === 'ascii' ? readTextMesh : readBinaryMesh;
  return meshCloud({ source, load: (progress) => load(file, progress) });
}

async function readBinaryMesh(file: PlyMeshFile, progress: ReadProgress): Promise<Mesh> {
  const { source, body, after, list } = file;
  const cursor = new ByteCursor(source.stream(), progress);
  const vertex = body.elements[body.elements.length - 1];
  const buffer = vertexBuffer(body);
  const decoder: PlyDecoder = { cursor, buffer, vertex, body, name: source.name };
  const builder = new MeshBuilder(source.name);
  try {
    for await (const chunk of readBinaryVertices(decoder)) builder.addChunk(chunk);
    for (const element of after.slice(0, -1)) await skipElement(decoder, element);
    const faces = after[after.length - 1];
    await new FaceRecords({
      cursor,
      faces,
      list,
      isLittleEndian: body.isLittleEndian,
      name: source.name,
    }).read(builder);
  } finally {
    await cursor.close();
  }
  return builder.build();
}

/** Rows: those before the vertices, the vertices, those between, the faces. */
async function readTextMesh(file: PlyMeshFile, progress: ReadProgress): Promise<Mesh> {
  const { source, header, body, layout } = file;
  const elements = [...body.elements, ...file.after].filter(({ count }) => count > 0);
  const vertex = body.elements[body.elements.length - 1];
  const faces = elements[elements.length - 1];
  const parser = new RowParser(layout, { name: source.name, line: header.bodyLine });
  const buffer = vertexBuffer(body);
  const builder = new MeshBuilder(source.name);
  let element = 0;
  let left = elements[0].count;
  for await (const { bytes, isCut } of lineBlocks(source, header.bodyBegin, progress)) {
    let at = parser.seek(bytes, 0);
    while (at < bytes.length && element < elements.length) {
      if (elements[element] === vertex) {
        at = parser.read(bytes, at, isCut);
        buffer.push(parser.values);
        if (buffer.free === 0 || left === 1) builder.addChunk(buffer.take());
      } else {
        if (elements[element] === faces) {
          readTextFace(
            { bytes, begin: at, faces, list: file.list, name: source.name, line: parser.line },
            builder,
          );
        }
        at = parser.skipLine(bytes, at);
      }
      if (--left === 0) left = elements[++element]?.count ?? 0;
      at = parser.seek(bytes, at);
    }
  }
  if (element < elements.length) {
    const { name, count } = elements[element];
    throw tooFewRows(source.name, count, count - left, name.slice(0, 20));
  }
  return builder.build();
}
