import type { Product } from '../plan-writer.ts';
import { asciiLine, sourceNotes, sourceSpace } from './model-notes.ts';
import { meshSize, modelParts } from './model-parts.ts';

/** Three doubles a vertex; a count, three corners and the part a face. */
const VERTEX = 24;
const FACE = 17;

/**
 * Writes plan.ply ([Turk94]): binary little-endian, z up, true source coordinates in the source's unit as doubles, so
 * nothing of a UTM place is lost; every face tells the part it is of, and comments which part has which name.
 */
export function writePly({ name, plan, solid }: Product): Uint8Array<ArrayBuffer> {
  const parts = modelParts({ plan, solid });
  const meshes = parts.flatMap(({ surfaces }, part) => surfaces.map(({ mesh }) => ({ part, mesh })));
  const { vertices, triangles } = meshSize(meshes.map(({ mesh }) => mesh));
  const notes = [
    ...sourceNotes(name, plan.frame).map(asciiLine),
    ...parts.map((part, i) => `part ${i}: ${part.name}`),
  ];
  const header = new TextEncoder().encode(headerOf(notes, vertices, triangles));
  const file = new Uint8Array(header.length + vertices * VERTEX + triangles * FACE);
  file.set(header);
  const view = new DataView(file.buffer);
  const to = sourceSpace(plan.frame);
  let [offset, face, first] = [header.length, header.length + vertices * VERTEX, 0];
  for (const { part, mesh } of meshes) {
    const { positions: p, indices } = mesh;
    for (let i = 0; i < p.length; i += 3, offset += VERTEX) {
      view.setFloat64(offset, to.x(p[i]), true);
      view.setFloat64(offset + 8, to.y(p[i + 1]), true);
      view.setFloat64(offset + 16, to.z(p[i + 2]), true);
    }
    for (let i = 0; i < indices.length; i += 3, face += FACE) {
      view.setUint8(face, 3);
      for (let k = 0; k < 3; k++) view.setInt32(face + 1 + 4 * k, first + indices[i + k], true);
      view.setInt32(face + 13, part, true);
    }
    first += p.length / 3;
  }
  return file;
}

function headerOf(notes: readonly string[], vertices: number, faces: number): string {
  return [
    'ply',
    'format binary_little_endian 1.0',
    ...notes.map((note) => `comment ${note}`),
    `element vertex ${vertices}`,
    ...['x', 'y', 'z'].map((axis) => `property double ${axis}`),
    `element face ${faces}`,
    'property list uchar int vertex_indices',
    'property int part',
    'end_header\n',
  ].join('\n');
}
