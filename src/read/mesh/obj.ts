import type { ReadFormat } from '../cloud-reader.ts';
import { isText, latin1 } from '../signatures.ts';

/** First words of an OBJ file's lines; comments begin with #. */
const WORDS =
  /^(v|vt|vn|vp|f|fo|l|p|o|g|s|mg|mtllib|usemtl|usemap|maplib|curv2?|surf|cstype|deg|parm|end|lod|bevel|c_interp|d_interp|shadow_obj|trace_obj|call|csh)$/;
/** Lines looked at. */
const LOOKED_AT = 200;

export const OBJ_FORMAT: ReadFormat = {
  label: 'OBJ',
  extensions: ['obj'],
  doc: 'Wavefront mesh: triangles and polygons are sampled to the working resolution, with vertex colours where present; without faces the vertices are the points.',
  detect: (head) => isText(head) && hasVertices(latin1(head)),
  open: async (source) => (await import('./obj-reader.ts')).openObj(source),
};

/** Nothing but lines of OBJ, with a vertex among them. */
function hasVertices(text: string): boolean {
  const lines = text.replace(/\\\r?\n/g, ' ').split(/[\r\n]+/, LOOKED_AT);
  // The last line may be cut.
  const rows = lines.slice(0, -1).filter((line) => !/^\s*(#|$)/.test(line));
  const hasVertex = lines.some((line) => /^\s*v(\s+[-+.\d]\S*){3}/.test(line));
  return hasVertex && rows.every((line) => WORDS.test(line.trim().split(/\s/, 1)[0]));
}
