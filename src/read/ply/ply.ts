import { countOf } from '../../core/count-words.ts';
import { FloorPlanError } from '../../core/errors.ts';
import type { Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud, ReadFormat } from '../cloud-reader.ts';
import { isWorthReading, tooFewBytes } from '../cut-off.ts';
import { columnsOfFields } from '../field-names.ts';
import { type ColourRange, RED, Z } from '../point-buffer.ts';
import { latin1 } from '../signatures.ts';
import { BLANK } from '../text/characters.ts';
import { LIST } from '../text/row-parser.ts';
import { readTextPoints } from '../text/text-points.ts';
import { type PlyBody, readBinaryPly, recordBytes } from './ply-binary.ts';
import { type PlyElement, type PlyHeader, readPlyHeader, valueBytes, vertexListOf } from './ply-header.ts';

export const PLY_FORMAT: ReadFormat = {
  label: 'PLY',
  extensions: ['ply'],
  doc: 'Stanford polygon file, text or binary; vertices with colour, intensity and class where present, or points sampled on the faces.',
  detect: (head) => /^ply\s/.test(latin1(head.subarray(0, 4))),
  open: openPly,
};

/**
 * Reads the header of a PLY file [Turk94]; its vertices are the points, or where faces join them points on the faces;
 * all else is passed over.
 *
 * @throws input/malformed, input/truncated, input/empty
 */
async function openPly(source: ByteSource): Promise<OpenCloud> {
  const header = await readPlyHeader(source);
  const index = header.elements.findIndex(({ name }) => name === 'vertex');
  const vertex = header.elements[index];
  const columns = columnsOfFields(
    vertex?.properties.map(({ name, countType }) => (countType ? '' : name)) ?? [],
  );
  assertPoints(source.name, vertex, columns);
  const elements = header.elements.slice(0, index + 1);
  const body: PlyBody = {
    elements,
    columns,
    begin: header.bodyBegin,
    isLittleEndian: header.format === 'binary_little_endian',
    colourRange: colourRange(vertex, columns),
    endsWithVertices: header.elements.slice(index + 1).every(({ count }) => count === 0),
  };
  const rows = textPoints(header, elements, body);
  // Bare vertices leave walls empty, so where faces join them the faces are the surfaces.
  const faces = header.elements.findIndex((element, at) => at > index && vertexListOf(element) >= 0);
  assertLongEnough(source, header, header.elements.slice(0, Math.max(index, faces) + 1));
  const warnings: Warning[] = [];
  if (faces >= 0) {
    const { openPlyMesh } = await import('./ply-mesh.ts');
    const after = header.elements.slice(index + 1, faces + 1);
    const list = vertexListOf(header.elements[faces]);
    const mesh = openPlyMesh({ source, header, body, layout: rows.layout, after, list });
    if (mesh) return mesh;
    warnings.push(tooManyFaces(header.elements[faces]));
  }
  return {
    isSlice: false,
    pointsAnnounced: vertex.count,
    chunks: (progress) =>
      header.format === 'ascii'
        ? readTextPoints(source, { ...rows, warnings }, progress)
        : readBinaryPly(source, body, warnings, progress),
    warnings,
  };
}

/** A mesh too large to be held is dense: its vertices are points enough. */
function tooManyFaces({ count }: PlyElement): Warning {
  return {
    code: 'read/mesh-vertices-only',
    message: `The mesh of ${countOf(count, 'face')} is too large to be held; its vertices were taken as points.`,
    hint: 'If walls show gaps, simplify the mesh.',
  };
}

function textPoints(
  header: PlyHeader,
  elements: readonly PlyElement[],
  { columns, colourRange, endsWithVertices }: PlyBody,
) {
  const vertex = elements[elements.length - 1];
  const targets = vertex.properties.map(({ countType }, property) =>
    countType ? LIST : columns.indexOf(property),
  );
  const lastNeeded = targets.findLastIndex((target) => target >= 0);
  return {
    layout: { separator: BLANK, targets: Int8Array.from(targets.slice(0, lastNeeded + 1)) },
    begin: header.bodyBegin,
    line: header.bodyLine,
    rowsBefore: elements.slice(0, -1).reduce((rows, { count }) => rows + count, 0),
    rows: vertex.count,
    endsWithRows: endsWithVertices,
    colourRange,
  };
}

function colourRange({ properties }: PlyElement, columns: readonly number[]): ColourRange {
  const type = properties[columns[RED]]?.type;
  if (type === 'float' || type === 'double') return 'unit';
  return type === 'ushort' || type === 'short' ? 'short' : 'byte';
}

function assertPoints(name: string, vertex: PlyElement | undefined, columns: readonly number[]): void {
  if (vertex && columns.slice(0, Z + 1).some((column) => column < 0)) {
    const found = vertex.properties.map((property) => property.name).join(', ');
    throw new FloorPlanError(
      'input/malformed',
      `${name}: expected vertices with the properties x, y and z, found ${found.slice(0, 80) || 'none'}`,
      { hint: 'Export the cloud with plain x, y and z coordinates.' },
    );
  }
  if (vertex && vertex.count > 0) return;
  throw new FloorPlanError(
    'input/empty',
    `${name}: expected vertices after the PLY header, found no points`,
    {
      hint: 'Export the cloud again, with its points.',
    },
  );
}

/** Where the size is known, a header that promises far more than the file holds is caught before anything is read. */
function assertLongEnough(
  { name, size }: ByteSource,
  header: PlyHeader,
  elements: readonly PlyElement[],
): void {
  if (size === undefined) return;
  let needed = header.bodyBegin;
  for (const element of elements) needed += element.count * leastBytes(header, element);
  if (header.format === 'ascii') needed -= 1;
  if (needed <= size) return;
  const last = elements[elements.length - 1];
  const { count, name: what } = last;
  const found = Math.floor(count - (needed - size) / leastBytes(header, last));
  if (what === 'vertex' && isWorthReading({ found, announced: count })) return;
  throw tooFewBytes(name, { count, what: what === 'vertex' ? 'point' : 'face', needed }, size);
}

/** A text value takes a digit and a blank, a list its length. */
function leastBytes({ format }: PlyHeader, element: PlyElement): number {
  if (format === 'ascii') return 2 * element.properties.length;
  const fixed = recordBytes(element);
  if (fixed !== null) return fixed;
  return element.properties.reduce((bytes, { type, countType }) => bytes + valueBytes(countType ?? type), 0);
}
